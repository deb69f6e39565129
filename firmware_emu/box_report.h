#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "firmware_emu/box_node.h"
#include "platform/time.h"

namespace eod::box {

/// For BoxNodeConfig::tell: prints plain lines "SECONDS  TEXT" to `out`, counted from `start`.
std::function<void(TimePoint, const std::string&)> PrintTo(std::FILE* out, TimePoint start);

/// Configuration, rates and channels as text, for --describe. Throws as BoxNode does.
std::string Describe(const BoxNodeConfig& config, const std::string& bus_url);

}  // namespace eod::box
