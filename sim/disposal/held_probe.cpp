#include "sim/disposal/held_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr MotionSet kCarryingMotions =
    SetOf(kDriveForward) | SetOf(kDriveReverse) | SetOf(kTurnLeft) | SetOf(kTurnRight) |
    SetOf(kBigArmUp) | SetOf(kBigArmDown) | SetOf(kSmallArmUp) | SetOf(kSmallArmDown) |
    SetOf(kWristUp) | SetOf(kWristDown) | SetOf(kGripperCcw) | SetOf(kGripperCw);

/// A line in a charge's terms: `out` of its radius from the axis, `up` of its half height from the
/// middle, 1 being the surface.
struct ProbeLine {
  double turn = 0;  ///< [rad] round the axis
  double out = 0;
  double up = 0;
  enum class Looks { kOut, kDown, kUp } looks = Looks::kOut;
};

/// Lines to all sides of one level.
template <size_t size>
void AddRound(std::array<ProbeLine, size>& lines, size_t& used, int count, const ProbeLine& like) {
  for (int i = 0; i < count; ++i) {
    lines[used] = like;
    lines[used++].turn = 2 * std::numbers::pi * i / count;
  }
}

std::array<ProbeLine, 30> Lines() {
  using enum ProbeLine::Looks;
  std::array<ProbeLine, 30> lines;
  size_t used = 0;
  AddRound(lines, used, 8, {.out = 1, .up = -1, .looks = kOut});
  AddRound(lines, used, 4, {.out = 1, .up = 0, .looks = kOut});
  AddRound(lines, used, 4, {.out = 1, .up = 1, .looks = kOut});
  AddRound(lines, used, 8, {.out = 1, .up = -1, .looks = kDown});
  AddRound(lines, used, 4, {.out = 0.5, .up = -1, .looks = kDown});
  AddRound(lines, used, 1, {.up = -1, .looks = kDown});
  AddRound(lines, used, 1, {.up = 1, .looks = kUp});
  return lines;
}

/// The line in the charge's frame, +Z away from the ground.
SegmentSpec Lay(const ProbeLine& line, const ExplosiveSpec& charge, const ChargeRules& rules) {
  const Vector3d out(std::cos(line.turn), std::sin(line.turn), 0);
  SegmentSpec segment;
  segment.skin = rules.probe_skin;
  if (line.looks == ProbeLine::Looks::kOut) {
    const double inset = std::min(rules.probe_inset, charge.radius / 2);
    // As far from the ends as a thing below may come: what it stands on is not beside it.
    const double level = line.up * (charge.half_height - rules.probe_skin);
    segment.start = (charge.radius - inset) * out + level * Vector3d::UnitZ();
    segment.direction = out;
    segment.d0 = inset + rules.probe_skin;
  } else {
    const double inset = std::min(rules.probe_inset, charge.half_height / 2);
    const double side = line.looks == ProbeLine::Looks::kUp ? 1 : -1;
    segment.start =
        line.out * charge.radius * out + side * (charge.half_height - inset) * Vector3d::UnitZ();
    segment.direction = side * Vector3d::UnitZ();
    segment.d0 = inset + rules.probe_skin;
  }
  // Beyond D0 for what is far from reached: Eq. 2 adds v dt, a centimetre at most.
  constexpr double kBeyond = 0.1;  // [m]
  segment.length = segment.d0 + kBeyond;
  return segment;
}

}  // namespace

int AppendHeldProbe(RobotModel& robot) {
  IsectorSpec probe;
  probe.name = "HELD";
  probe.method = IsectorMethod::kVolume;
  probe.link = std::max(0, FindLink(robot, "gripper"));
  probe.class_mask = UsualClasses(IsectorMethod::kVolume);
  probe.motions = kCarryingMotions;
  probe.part = Part::kHeldBomb;
  probe.segments.resize(Lines().size());
  for (size_t i = 0; i < probe.segments.size(); ++i) {
    probe.segments[i].name = "held" + std::to_string(i + 1);
    probe.segments[i].enabled = false;
  }
  robot.isectors.push_back(std::move(probe));
  return static_cast<int>(robot.isectors.size()) - 1;
}

void ShapeHeldProbe(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_GO,
                    const Eigen::Vector3d& down_G, const ChargeRules& rules, IsectorSpec& probe) {
  Eigen::Isometry3d X_GC = X_GO;
  if (X_GO.linear().col(2).dot(down_G) > 0) {
    X_GC.linear() = X_GO.linear() * Eigen::Vector3d(1, -1, -1).asDiagonal();
  }
  const auto lines = Lines();
  for (size_t i = 0; i < lines.size(); ++i) {
    const SegmentSpec laid = Lay(lines[i], charge, rules);
    SegmentSpec& segment = probe.segments[i];
    segment.start = X_GC * laid.start;
    segment.direction = (X_GC.linear() * laid.direction).normalized();
    segment.length = laid.length;
    segment.d0 = laid.d0;
    segment.skin = laid.skin;
    segment.enabled = true;
  }
}

void FoldHeldProbe(IsectorSpec& probe) {
  for (SegmentSpec& segment : probe.segments) segment.enabled = false;
}

}  // namespace eod::sim
