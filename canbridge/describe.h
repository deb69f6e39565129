#pragma once

#include <string>

#include "canbridge/bridge_node.h"

namespace eod::bridge {

/// What `--describe` prints: files, limits, rates, every message of the map with its identifier,
/// cycle time, direction and role, and the LCM channels. Throws std::runtime_error with one line
/// for a DBC or map that does not load.
std::string DescribeBridge(const BridgeNodeConfig& config, const std::string& bus_url);

}  // namespace eod::bridge
