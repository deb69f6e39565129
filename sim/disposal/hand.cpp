#include "sim/disposal/hand.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "sim/disposal/charge.h"
#include "sim/segments/solid.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr std::array<std::string_view, 3> kIsectors = {"B5", "B6", "B7"};
constexpr std::array<std::string_view, kHandLineCount> kLines = {"l1", "l2", "l3", "l4", "l5",
                                                                 "l6", "l7", "l8", "l9"};

int FindSegment(const IsectorSpec& isector, std::string_view name) {
  for (size_t i = 0; i < isector.segments.size(); ++i) {
    if (isector.segments[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

/// Where the axis comes nearest to the height `z` of the gripper, within the charge's ends.
Vector3d AxisAtHeight(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_GO, double z) {
  const Vector3d axis = X_GO.linear().col(2);
  const Vector3d centre = X_GO.translation();
  constexpr double kLevel = 1e-6;
  if (std::abs(axis.z()) < kLevel) return centre;
  const double along = (z - centre.z()) / axis.z();
  return centre + std::clamp(along, -charge.half_height, charge.half_height) * axis;
}

}  // namespace

HandLayout::HandLayout(const RobotModel& robot)
    : gripper_(FindLink(robot, "gripper")),
      left_(FindLink(robot, "left_hand")),
      right_(FindLink(robot, "right_hand")) {
  for (size_t line = 0; line < kHandLineCount; ++line) {
    const int isector = FindIsector(robot, kIsectors[line / 3]);
    if (isector < 0) continue;
    lines_[line] = {isector, FindSegment(robot.isectors[isector], kLines[line])};
  }
  // B6 sits at the tip of the right finger.
  const int tip = lines_[kL5].isector;
  if (tip >= 0) finger_ = robot.isectors[tip].X_LI.translation().y();
}

HandLines HandLayout::Read(std::span<const CastSegment> segments,
                           std::span<const SegmentContact> contacts, const ModuleModel& module,
                           std::span<const int> movable_of_object) const {
  HandLines read;
  for (size_t i = 0; i < segments.size(); ++i) {
    const CastSegment& cast = segments[i];
    if (!cast.hit.hit || !contacts[i].contact) continue;
    const int movable = MovableOf(movable_of_object, cast.hit.object);
    if (movable < 0 || !module.movables[movable].explosive) continue;
    for (size_t line = 0; line < kHandLineCount; ++line) {
      if (lines_[line].isector != cast.isector || lines_[line].segment != cast.segment) continue;
      read[line] = {.charge = movable, .point = cast.hit.point, .normal = cast.hit.normal};
    }
  }
  return read;
}

PadPress PressOn(const HandLayout& hand, std::span<const Eigen::Isometry3d> X_ML,
                 const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO,
                 double pad_half_height) {
  PadPress press;
  if (!hand.has_hands()) return press;
  const Eigen::Isometry3d X_GM = X_ML[hand.gripper()].inverse();
  const Eigen::Isometry3d X_GO = X_GM * X_MO;
  const Vector3d left = X_GM * X_ML[hand.left()].translation();
  const Vector3d right = X_GM * X_ML[hand.right()].translation();
  const Solid solid = CylinderSolid{charge.radius, charge.half_height};
  const Eigen::Matrix3d R_OG = X_GO.linear().transpose();
  int left_levels = 0, right_levels = 0;
  for (const double z : {-pad_half_height, 0.0, pad_half_height}) {
    const double y = AxisAtHeight(charge, X_GO, left.z() + z).y();
    const Vector3d p_G(0, std::clamp(y, left.y(), left.y() + hand.finger()), left.z() + z);
    const auto chord = ChordOf(solid, R_OG * (p_G - X_GO.translation()), R_OG.col(0));
    if (!chord) continue;
    if (left.x() < chord->leave) {
      press.left += left.x() - chord->enter;
      ++left_levels;
    }
    if (right.x() > chord->enter) {
      press.right += chord->leave - right.x();
      ++right_levels;
    }
  }
  press.left = std::max(0.0, press.left / std::max(1, left_levels));
  press.right = std::max(0.0, press.right / std::max(1, right_levels));
  return press;
}

}  // namespace eod::sim
