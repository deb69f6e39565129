#include <cmath>

#include <gtest/gtest.h>

#include "sim/segments/movable_shapes.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr uint32_t kBomb = kBombObject | kModuleBomb;
const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY();

/// The hand round a bomb: X across the jaws, Y along the fingers, [m].
struct Hand {
  double left, right;                   ///< where the fingers stand
  static constexpr double kTip = 0.08;  ///< the right isector before the middle of the finger
  // The beam retracts by two thirds of the mean opening from 80 mm behind the middle.
  double beam() const { return -0.08 - (right - left) / 3; }
};

class BombInTheHand : public ::testing::Test {
 protected:
  static constexpr double kRadius = 0.06;
  MovableShapes dut_;

  void PlaceBomb(double x, double turn = 0) {
    Isometry3d X_MO(Eigen::Translation3d(x, 0, 0));
    X_MO.rotate(Eigen::AngleAxisd(turn, Vector3d::UnitZ()));
    dut_.Add(3, kBomb, Shape::Cylinder(kRadius, 0.4), X_MO);
  }
  SegmentHit Line(double x, double y, const Vector3d& direction) {
    const SegmentQuery query{
        .start = {x, y, 0.02}, .direction = direction, .length = 0.3, .class_mask = kBombObject};
    SegmentHit hit;
    CastMemory memory;
    dut_.Cast({&query, 1}, {&hit, 1}, memory);
    return hit;
  }
};

TEST_F(BombInTheHand, CentredAndPressedByThreeMillimetresGivesTheGoldenRanges) {
  PlaceBomb(0, 0.7);
  const double delta = 0.003, half_chord = std::sqrt(2 * kRadius * delta - delta * delta);
  const Hand hand{delta - kRadius, kRadius - delta};
  const SegmentHit l1 = Line(hand.left, 0, kY), l2 = Line(hand.left, 0, -kY);
  EXPECT_NEAR(l1.range, half_chord, 1e-12);  // 18.7 mm
  EXPECT_NEAR(l2.range, half_chord, 1e-12);
  EXPECT_NEAR(1000 * half_chord, 18.7, 0.05);
  EXPECT_NEAR(Line(hand.left, 0, kX).range, 0.117, 1e-12);
  EXPECT_FALSE(Line(hand.right, Hand::kTip, kY).hit);                                    // l4
  EXPECT_NEAR(Line(hand.right, Hand::kTip, -kY).range, Hand::kTip - half_chord, 1e-12);  // l5
  EXPECT_NEAR(1000 * (Hand::kTip - half_chord), 61.3, 0.05);
  EXPECT_FALSE(Line(hand.right, Hand::kTip, -kX).hit);  // l6 passes in front
  EXPECT_FALSE(Line(0, hand.beam(), kX).hit);           // l7
  EXPECT_FALSE(Line(0, hand.beam(), -kX).hit);          // l8
  EXPECT_NEAR(Line(0, hand.beam(), kY).range, 0.058, 1e-12);
  // Normals look outward, at the hand: opposed contacts of left (l3's far side) and right (l5).
  EXPECT_LT((l1.normal - Vector3d(hand.left, half_chord, 0) / kRadius).norm(), 1e-12);
  EXPECT_EQ(l1.object, 3);
  EXPECT_EQ(l1.object_class, kBomb);
  EXPECT_EQ(l1.triangle, -1);
}

TEST_F(BombInTheHand, NotTouchedGivesNoGrasp) {
  PlaceBomb(0);
  const Hand hand{-kRadius - 0.001, kRadius + 0.001};
  EXPECT_FALSE(Line(hand.left, 0, kY).hit);
  EXPECT_FALSE(Line(hand.left, 0, -kY).hit);
  EXPECT_NEAR(Line(hand.left, 0, kX).range, 0.001, 1e-12);
  EXPECT_FALSE(Line(hand.right, Hand::kTip, -kY).hit);
  EXPECT_NEAR(1000 * Line(0, hand.beam(), kY).range, 60.7, 0.05);
}

TEST_F(BombInTheHand, OffCentreTouchesTheLeftHandFirst) {
  PlaceBomb(-0.025);
  const Hand hand{-0.08, 0.08};  // 5 mm deep on the left
  const double half_chord = std::sqrt(2 * kRadius * 0.005 - 0.005 * 0.005);
  EXPECT_NEAR(Line(hand.left, 0, kY).range, half_chord, 1e-12);
  EXPECT_NEAR(Line(hand.left, 0, -kY).range, half_chord, 1e-12);
  EXPECT_NEAR(1000 * half_chord, 24.0, 0.05);
  EXPECT_NEAR(Line(hand.left, 0, kX).range, 0.115, 1e-12);
  EXPECT_FALSE(Line(hand.right, Hand::kTip, -kY).hit);
}

}  // namespace
}  // namespace eod::sim
