#include "tests/bench/isector_bench/workload.h"

#include <numbers>

#include "sim/geometry/pose.h"

namespace eod::bench {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using sim::SegmentQuery;

constexpr uint32_t kStandsOn = sim::kModuleOutdoor | sim::kClampProxy;
constexpr uint32_t kRunsInto = sim::kModuleOutdoor | sim::kBumpProxy;
constexpr double kLegsFrom = 1;       // [m] above the robot's origin
constexpr double kSightHeight = 1.1;  // [m]
constexpr uint32_t kFirstSight = kBumps + 1;

}  // namespace

std::vector<SegmentQuery> ShortLines(std::span<const RobotPose> path) {
  const Vector3d legs[kLegs] = {{-0.3, 0.375, 0}, {0.3, 0.375, 0}, {0, -0.375, 0}};
  std::vector<SegmentQuery> lines;
  lines.reserve(path.size() * kLinesPerFrame);
  for (const RobotPose& pose : path) {
    // TRIPOD turns with the heading alone, so that its lines stay vertical.
    Isometry3d X_MT = pose.X_MR;
    X_MT.linear() = sim::ToRotation({.heading = pose.heading});
    for (const Vector3d& leg : legs) {
      lines.push_back({.start = X_MT * (leg + kLegsFrom * Vector3d::UnitZ()),
                       .direction = -Vector3d::UnitZ(),
                       .length = kLegLength,
                       .class_mask = kStandsOn,
                       .hit_rule = sim::HitRule::kHighest,
                       .group = 0});
    }
    for (uint32_t bump = 0; bump < kBumps; ++bump) {
      const Isometry3d& X_MB = pose.X_MB[bump];
      for (int line = 0; line < kLinesPerBump; ++line) {
        const double sign = line % 2 == 0 ? 1 : -1;
        lines.push_back({.start = X_MB.translation(),
                         .direction = sign * X_MB.linear().col(line / 2).normalized(),
                         .length = kBumpLength,
                         .class_mask = kRunsInto,
                         .group = bump + 1});
      }
    }
  }
  return lines;
}

std::vector<SegmentQuery> SightLines(std::span<const RobotPose> path) {
  const double pitch_deg[kSightLinesPerFrame] = {0, -1, 1, -3, 0.5, -0.5, 1.5, -2};
  std::vector<SegmentQuery> lines;
  lines.reserve(path.size() * kSightLinesPerFrame);
  for (const RobotPose& pose : path) {
    for (uint32_t i = 0; i < kSightLinesPerFrame; ++i) {
      const double heading = pose.heading + i * std::numbers::pi / 4;
      const Eigen::Matrix3d R_ML =
          sim::ToRotation({.heading = heading, .pitch = pitch_deg[i] * std::numbers::pi / 180});
      lines.push_back({.start = pose.X_MR * Vector3d(0, 0.2, kSightHeight),
                       .direction = R_ML.col(1).normalized(),
                       .length = kSightLength,
                       .class_mask = kRunsInto,
                       .group = kFirstSight + i});
    }
  }
  return lines;
}

}  // namespace eod::bench
