#pragma once

#include "sim/robot/robot_model.h"
#include "sim/sdf/custom_element.h"

namespace eod::sim {

/// The words of robot files. All throw "FILE:LINE: …" with what is allowed.

/// "M05" in `attribute` is kFrontFlipperUp.
int MotionOf(const CustomElement& element, const std::string& attribute);

/// "M01 M03", "all", or "always" (cast even while nothing is commanded).
MotionSet MotionsOf(const CustomElement& element, const std::string& attribute);

/// "front_left_wheel" .. "held_bomb".
Part PartOf(const CustomElement& element, const std::string& attribute);

/// "volume" .. "bump".
IsectorMethod MethodOf(const CustomElement& element, const std::string& attribute);

/// "two_sided", "front_only".
FaceRule FaceRuleOf(const CustomElement& element, const std::string& attribute);

/// "nearest", "highest", "all".
HitRule HitRuleOf(const CustomElement& element, const std::string& attribute);

/// "bump clamp bomb movable vessel", or some of these: their bits in object_class.h.
uint32_t ClassesOf(const CustomElement& element, const std::string& attribute);

/// "drive", "gripper", "infrared".
SpotLightSpec::Switch SwitchOf(const CustomElement& element, const std::string& attribute);

/// "true", "false"; `missing` without the attribute.
bool FlagOf(const CustomElement& element, const std::string& attribute, bool missing);

}  // namespace eod::sim
