#pragma once

#include "sim/rules/disposal_rules.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {

/// Readers of the tables [grasp], [charge], [vessel], [disrupter]; private to this folder. All
/// throw std::runtime_error "FILE:LINE: …".
GraspRules ReadGrasp(const TomlTable& table);
ChargeRules ReadCharge(const TomlTable& table);
VesselRules ReadVessel(const TomlTable& table);
DisrupterRules ReadDisrupter(const TomlTable& table);

}  // namespace eod::sim
