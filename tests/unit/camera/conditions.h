#pragma once

#include <string>

#include "sim/robot/robot_lights.h"
#include "sim/world/weather.h"

namespace eod::sim {

/// "day|dusk|night[,fog=METRES][,rain=MM_PER_H]". Throws std::runtime_error.
Weather ParseWeather(const std::string& text);

/// Some of "drive", "gripper", "infrared", with commas between them. Throws std::runtime_error.
RobotLights ParseLights(const std::string& text);

}  // namespace eod::sim
