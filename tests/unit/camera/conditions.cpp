#include "tests/unit/camera/conditions.h"

#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::sim {

Weather ParseWeather(const std::string& text) {
  Weather weather;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (word == "day") {
      weather.light = Weather::Light::kDay;
    } else if (word == "dusk") {
      weather.light = Weather::Light::kDusk;
    } else if (word == "night") {
      weather.light = Weather::Light::kNight;
    } else if (word.starts_with("fog=")) {
      weather.visibility = std::stod(word.substr(4));
    } else if (word.starts_with("rain=")) {
      weather.rain = std::stod(word.substr(5));
    } else {
      throw std::runtime_error(fmt::format(
          "weather \"{}\": day|dusk|night[,fog=METRES][,rain=MM_PER_H], not \"{}\"", text, word));
    }
  }
  return weather;
}

RobotLights ParseLights(const std::string& text) {
  RobotLights lights;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (word == "drive") {
      lights.drive = true;
    } else if (word == "gripper") {
      lights.gripper = true;
    } else if (word == "infrared") {
      lights.infrared = true;
    } else {
      throw std::runtime_error(
          fmt::format("lights \"{}\": drive, gripper, infrared, not \"{}\"", text, word));
    }
  }
  return lights;
}

}  // namespace eod::sim
