#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "sim/robot/robot_parts.h"

namespace eod::sim {
namespace {

constexpr int kPresets = 7;  // BOX_MOTION.PresetReq: 1 stow .. 7 stair down

std::string Attribute(int joint) {
  return fmt::format("J{}_{}", joint + 1, joint == kGripperOpening ? "m" : "deg");
}

void AllowPresetAttributes(const CustomElement& preset) {
  preset.AllowAttributes({"index", "name", "J1_deg", "J2_deg", "J3_deg", "J4_deg", "J5_deg",
                          "J6_deg", "J7_m", "J8_deg", "J9_deg"});
}

PresetSpec ReadPreset(const CustomElement& element,
                      const std::array<JointSpec, kJointCount>& joints) {
  AllowPresetAttributes(element);
  PresetSpec preset{
      .index = element.Integer("index", 1, kPresets), .name = element.Text("name"), .joint = {}};
  for (int j = 0; j < kJointCount; ++j) {
    const std::string attribute = Attribute(j);
    if (!element.Has(attribute)) continue;
    const double unit = j == kGripperOpening ? 1 : std::numbers::pi / 180;
    const JointSpec& joint = joints[static_cast<size_t>(j)];
    preset.joint[static_cast<size_t>(j)] =
        unit * element.Number(attribute, joint.lower / unit, joint.upper / unit);
  }
  return preset;
}

}  // namespace

std::vector<PresetSpec> ReadPresets(const SdfModel& sdf,
                                    const std::array<JointSpec, kJointCount>& joints) {
  std::vector<PresetSpec> presets;
  for (const CustomElement& element : sdf.customs) {
    if (element.name != "preset") continue;
    PresetSpec preset = ReadPreset(element, joints);
    const bool known = std::any_of(presets.begin(), presets.end(), [&](const PresetSpec& other) {
      return other.index == preset.index;
    });
    if (known) element.Fail(fmt::format("second preset {}", preset.index));
    presets.push_back(std::move(preset));
  }
  return presets;
}

PayloadSpec ReadPayload(const SdfModel& sdf) {
  const CustomElement* payload = FindElement(sdf.customs, "payload");
  if (payload == nullptr) return {};
  payload->AllowAttributes({"folded_kg", "stretched_kg"});
  PayloadSpec spec{.folded = payload->Number("folded_kg", 0.1, 1000),
                   .stretched = payload->Number("stretched_kg", 0.1, 1000)};
  if (spec.stretched > spec.folded) {
    payload->Fail(
        fmt::format("stretched_kg = {} is above folded_kg = {}", spec.stretched, spec.folded));
  }
  return spec;
}

BatterySpec ReadBattery(const SdfModel& sdf) {
  const CustomElement* battery = FindElement(sdf.customs, "battery");
  if (battery == nullptr) return {};
  battery->AllowAttributes({"full_v", "empty_v", "capacity_ah", "resistance_ohm", "idle_a",
                            "drive_a", "joint_a", "low_v"});
  constexpr double kCoulombPerAmpereHour = 3600;
  const double full = battery->Number("full_v", 1, 1000);
  return {.full = full,
          .empty = battery->Number("empty_v", 1, full),
          .capacity = battery->Number("capacity_ah", 0.1, 10000) * kCoulombPerAmpereHour,
          .resistance = battery->Number("resistance_ohm", 0, 10),
          .idle_current = battery->Number("idle_a", 0, 1000),
          .drive_current = battery->Number("drive_a", 0, 1000),
          .joint_current = battery->Number("joint_a", 0, 1000),
          .low = battery->Number("low_v", 0, full)};
}

}  // namespace eod::sim
