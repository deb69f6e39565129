#include "firmware_emu/sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eod::box {

const SeenObject* Sight::Find(std::string_view name) const {
  const auto object = std::find_if(objects.begin(), objects.end(), [name](const SeenObject& seen) {
    return seen.name == name && !seen.is_gone;
  });
  return object == objects.end() ? nullptr : &*object;
}

double FromRobot::distance() const { return std::hypot(ahead, side); }

double FromRobot::bearing_deg() const {
  return std::atan2(-side, ahead) * (180 / std::numbers::pi);
}

FromRobot SeenFromRobot(const Sight& sight, double x, double y) {
  const double heading = sight.heading_deg * (std::numbers::pi / 180);
  const double dx = x - sight.position[0], dy = y - sight.position[1];
  return {.ahead = -dx * std::sin(heading) + dy * std::cos(heading),
          .side = dx * std::cos(heading) + dy * std::sin(heading)};
}

}  // namespace eod::box
