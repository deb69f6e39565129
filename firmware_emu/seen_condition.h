#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware_emu/condition.h"
#include "firmware_emu/sight.h"

namespace eod::box {

/// Why a script cannot go by its eyes.
inline constexpr std::string_view kNothingSeen =
    "the operator sees nothing: no EOD_ROBOT_STATE and EOD_SCENE on LCM";

bool IsByEye(Condition::Subject subject);

/// It names an object: "distance can < 2".
bool IsOfObject(Condition::Subject subject);

/// What a condition by eye compares [m], [deg]; kSeen: 1 or 0. None if its object is not seen.
std::optional<double> SeenQuantity(const Condition& condition, const Sight& sight);

/// "'charge_x' is not seen; seen are can, charge_m", for messages.
std::string NotSeen(std::string_view object, const Sight& sight);

}  // namespace eod::box
