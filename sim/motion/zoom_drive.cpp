#include "sim/motion/zoom_drive.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

ZoomDrive::ZoomDrive(const RobotModel& robot, double dt_s) {
  for (const CameraSpec& camera : robot.cameras) {
    if (camera.zoom_most <= 1) continue;
    most_ = camera.zoom_most;
    step_factor_ = std::pow(camera.zoom_per_s, dt_s);
    return;
  }
}

void ZoomDrive::Step(ZoomWish wish) {
  if (wish == ZoomWish::kIn) magnification_ *= step_factor_;
  if (wish == ZoomWish::kOut) magnification_ /= step_factor_;
  magnification_ = std::clamp(magnification_, 1.0, most_);
}

}  // namespace eod::sim
