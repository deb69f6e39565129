#pragma once

#include <array>
#include <span>

#include <Eigen/Geometry>

#include "sim/response/response.h"
#include "sim/rules/disposal_rules.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// The nine lines of the hand (2.4 of the design): l1, l2, l3 from the middle of the left finger,
/// l4, l5, l6 from the right tip, l7, l8, l9 from the crossbeam.
enum HandLineId : int { kL1, kL2, kL3, kL4, kL5, kL6, kL7, kL8, kL9, kHandLineCount };

/// What a line of the hand sees of a charge.
struct HandLine {
  int charge = -1;  ///< index in ModuleModel::movables; -1: it meets none within its D
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< module's frame
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward
};
using HandLines = std::array<HandLine, kHandLineCount>;

/// Where the nine lines and the pads are on a robot. Names, as in the robot file: isectors B5, B6,
/// B7 with segments l1 .. l9; links "gripper", "left_hand", "right_hand". A robot that lacks one of
/// them never sees or presses anything with it.
class HandLayout {
 public:
  explicit HandLayout(const RobotModel& robot);

  /// What the lines see of charges of `module`, from one cast and its judgement. A hit counts as
  /// one of a charge if the object is one.
  HandLines Read(std::span<const CastSegment> segments, std::span<const SegmentContact> contacts,
                 const ModuleModel& module, std::span<const int> movable_of_object) const;

  bool has_hands() const { return gripper_ >= 0 && left_ >= 0 && right_ >= 0; }
  int gripper() const { return gripper_; }  ///< link, -1 if there is none
  int left() const { return left_; }
  int right() const { return right_; }
  /// [m] from a hand's frame to its tip; pads reach so far along Y.
  double finger() const { return finger_; }

 private:
  struct Place {
    int isector = -1;
    int segment = -1;
  };
  std::array<Place, kHandLineCount> lines_;
  int gripper_, left_, right_;
  double finger_ = 0;
};

/// How deep the pads are pressed into a charge [m]; 0 where they do not touch.
struct PadPress {
  double left = 0;
  double right = 0;
};

/// By the chords that lines across the jaws, through lower edge, middle and upper edge of the pads,
/// cut out of the exact cylinder; their mean, for a pad gives way to a charge that leans. A charge
/// outside of the hand, or beyond the tip, presses nothing.
PadPress PressOn(const HandLayout& hand, std::span<const Eigen::Isometry3d> X_ML,
                 const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO,
                 double pad_half_height);

}  // namespace eod::sim
