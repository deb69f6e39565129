#include "sim/stance/tilt_guard.h"

#include <cmath>

namespace eod::sim {
namespace {

constexpr double kGrowth = 1e-6;  // [rad] a step; less is rounding
constexpr MotionSet kEvenMotions = 0x55555555;

bool Grew(double before, double after, double limit) {
  return std::abs(after) > limit && std::abs(after) > std::abs(before) + kGrowth;
}

/// Forward for reverse, left for right.
MotionSet Opposites(MotionSet motions) {
  return (motions & kEvenMotions) << 1 | (motions >> 1 & kEvenMotions);
}

}  // namespace

void TiltGuard::Update(const StanceSpec& limits, const Attitude& before, const Attitude& after,
                       MotionSet driven) {
  refused_ &= ~Opposites(driven);
  const bool within =
      std::abs(after.pitch) <= limits.pitch_limit && std::abs(after.roll) <= limits.roll_limit;
  if (within) refused_ = 0;
  if (Grew(before.pitch, after.pitch, limits.pitch_limit) ||
      Grew(before.roll, after.roll, limits.roll_limit)) {
    refused_ |= driven;
  }
}

}  // namespace eod::sim
