#include "sim/stance/flipper_bearing.h"

namespace eod::sim {
namespace {

constexpr std::array<int, 2> kDown = {kFrontFlipperDown, kRearFlipperDown};
constexpr uint32_t kLoose = kBombObject | kMovableObject;
constexpr double kRounding = 1e-9;  // [s] of adding up steps

}  // namespace

bool FlipperBearing::StopsOnGround(const RobotModel& robot, const CastSegment& cast,
                                   MotionSet blocks) {
  const SegmentSpec& segment = robot.isectors[cast.isector].segments[cast.segment];
  const bool looks_down = blocks != 0 && (segment.motions & ~blocks) == 0;
  return looks_down && (cast.hit.object_class & kLoose) == 0;
}

void FlipperBearing::Press(const StanceSpec& stance, MotionSet pressed, double dt_s) {
  for (size_t i = 0; i < ends_.size(); ++i) {
    End& end = ends_[i];
    end.pressed_s = Contains(pressed, kDown[i]) ? end.pressed_s + dt_s : 0;
    if (end.pressed_s > 0 && end.pressed_s >= stance.press_on_s - kRounding) end.bears = true;
  }
}

void FlipperBearing::Lift(const StanceSpec& stance, const std::array<double, 2>& gaps) {
  for (size_t i = 0; i < ends_.size(); ++i) {
    if (gaps[i] > stance.lift_off) ends_[i] = {};
  }
}

MotionSet FlipperBearing::motions() const {
  MotionSet motions = 0;
  for (size_t i = 0; i < ends_.size(); ++i) {
    if (ends_[i].bears) motions |= SetOf(kDown[i]);
  }
  return motions;
}

}  // namespace eod::sim
