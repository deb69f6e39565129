#include "sim/isectors/isector_methods.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/geometry/pose.h"
#include "sim/isectors/isector_batch.h"
#include "sim/isectors/terrain_reading.h"
#include "sim/isectors/tripod_reading.h"
#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr uint32_t kGround = kModuleFlat | kClampProxy;
constexpr uint32_t kWall = kModuleFlat | kBumpProxy;

Attitude Degrees(double heading, double pitch, double roll) {
  return {heading * kDegree, pitch * kDegree, roll * kDegree};
}

Eigen::Isometry3d PoseOf(const Vector3d& position, const Attitude& attitude) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = ToRotation(attitude);
  X.translation() = position;
  return X;
}

class Methods : public ::testing::Test {
 protected:
  AnalyticWorld world_;
  IsectorBatch batch_;

  void Cast(Isector& dut, const Vector3d& position, const Attitude& attitude = {}) {
    dut.set_pose(PoseOf(position, attitude));
    batch_.CastIsectors({&dut, 1}, world_, 1);
  }
  /// A plane through `point` that a body of this attitude stands square on.
  void AddSlope(const Vector3d& point, const Attitude& attitude) {
    world_.AddPlane("slope", kGround, point, ToRotation(attitude).col(2));
  }
};

TEST_F(Methods, HatIsTheHeightAboveTheTerrainInsideItsExtent) {
  world_.AddPlane("floor", kGround, {0, 0, 1}, Vector3d::UnitZ());
  world_.AddPlane("roof", kGround, {0, 0, 4}, Vector3d::UnitZ());
  Isector dut = MakeHat("eye", {.z_min = -2, .z_max = 0.5});
  Cast(dut, {7, 8, 2.5});
  EXPECT_DOUBLE_EQ(ReadHat(dut, 1).value(), 1.5);  // not the roof
  Cast(dut, {7, 8, 0.7});
  EXPECT_NEAR(ReadHat(dut, 1).value(), -0.3, 1e-12);  // below the floor, within z_max
  Cast(dut, {7, 8, 0.4});
  EXPECT_FALSE(ReadHat(dut, 1).has_value());
}

TEST_F(Methods, VerticalSegmentsReachFromZMaxDownToZMin) {
  for (auto make : {MakeHat, MakeZ, MakeZpr, MakeXyzpr}) {
    Isector dut = make("vertical", {.z_min = -2, .z_max = 0.5});
    Cast(dut, {1, 2, 3}, Degrees(40, 30, -20));  // vertical whatever the attitude
    ASSERT_EQ(batch_.queries().size(), 1u);
    const SegmentQuery& query = batch_.queries()[0];
    EXPECT_EQ(query.start, Vector3d(1, 2, 3.5));
    EXPECT_EQ(query.direction, -Vector3d::UnitZ());
    EXPECT_DOUBLE_EQ(query.length, 2.5);
    EXPECT_EQ(query.hit_rule, HitRule::kHighest);
  }
}

TEST_F(Methods, ZIsTheTerrainAtTheOriginsPlace) {
  // Rises by tan 10 deg a metre to the north.
  AddSlope({0, 0, 0}, Degrees(0, 10, 0));
  Isector dut = MakeZ("z", {.z_min = -5, .z_max = 5});
  Cast(dut, {3, 2, 1}, Degrees(123, -15, 4));
  EXPECT_NEAR(ReadZ(dut, 1).value(), 2 * std::tan(10 * kDegree), 1e-12);
}

TEST_F(Methods, ZprAndXyzprReturnTheAttitudeThatTheSlopeWasMadeOf) {
  // Headings, pitches and rolls of the design's round trip.
  for (const Attitude& attitude : {Degrees(0, 10, 0), Degrees(25, -12, 8), Degrees(140, 15, -20)}) {
    world_ = AnalyticWorld();
    AddSlope({0, 0, 0.2}, attitude);
    std::vector<Isector> duts = {MakeZpr("zpr"), MakeXyzpr("xyzpr")};
    for (Isector& dut : duts) {
      dut.set_pose(PoseOf({0, 0, 1.2}, {attitude.heading, 0.3, -0.2}));  // its own does not matter
    }
    batch_.CastIsectors(duts, world_, 1);
    const TerrainPose terrain = ReadZpr(duts[0], 1).value();
    EXPECT_NEAR(terrain.z, 0.2, 1e-12);
    EXPECT_NEAR(terrain.pitch, attitude.pitch, 1e-12);
    EXPECT_NEAR(terrain.roll, attitude.roll, 1e-12);
    const FollowerPose follower = ReadXyzpr(duts[1], 1).value();
    EXPECT_NEAR(follower.height, 1.0, 1e-12);
    EXPECT_NEAR(follower.pitch, attitude.pitch, 1e-12);
    EXPECT_NEAR(follower.roll, attitude.roll, 1e-12);
  }
}

TEST_F(Methods, PitchAndRollSwapWhenTheHeadingTurnsByAQuarter) {
  AddSlope({0, 0, 0}, Degrees(0, 10, 0));
  Isector dut = MakeZpr("zpr");
  // Looking west on ground that rises to the north: the right side is the high one.
  Cast(dut, {0, 0, 0}, Degrees(90, 0, 0));
  EXPECT_NEAR(ReadZpr(dut, 1)->pitch, 0, 1e-12);
  EXPECT_NEAR(ReadZpr(dut, 1)->roll, -10 * kDegree, 1e-12);
}

TEST_F(Methods, PolygonSeenFromBehindGivesTheSameAttitude) {
  world_.AddPlane("turned", kGround, {0, 0, 0}, -ToRotation(Degrees(0, 10, 0)).col(2));
  Isector dut = MakeZpr("zpr");
  Cast(dut, {0, 0, 0});
  EXPECT_NEAR(ReadZpr(dut, 1)->pitch, 10 * kDegree, 1e-12);
}

TEST_F(Methods, NothingBelowGivesNoValue) {
  std::vector<Isector> duts = {MakeHat("hat"), MakeZ("z"), MakeZpr("zpr"), MakeXyzpr("xyzpr")};
  batch_.CastIsectors(duts, world_, 1);
  EXPECT_FALSE(ReadHat(duts[0], 1).has_value());
  EXPECT_FALSE(ReadZ(duts[1], 1).has_value());
  EXPECT_FALSE(ReadZpr(duts[2], 1).has_value());
  EXPECT_FALSE(ReadXyzpr(duts[3], 1).has_value());
}

TEST_F(Methods, LosLooksAlongTheForwardAxisOfItsWholeAttitude) {
  Isector dut = MakeLos("sight", 10);
  Cast(dut, {1, 2, 3}, Degrees(90, 30, 45));
  const SegmentQuery& query = batch_.queries()[0];
  EXPECT_EQ(query.start, Vector3d(1, 2, 3));
  // Heading 90 looks to -X, pitch 30 up; roll does not enter.
  const Vector3d forward(-std::cos(30 * kDegree), 0, std::sin(30 * kDegree));
  EXPECT_LT((query.direction - forward).norm(), 1e-12);
  EXPECT_EQ(query.length, 10);
}

TEST_F(Methods, BumpReachesAlongBothWaysOfEachAxisByItsOwnHalfLengths) {
  Isector dut = MakeBump("B", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
  const Attitude attitude = Degrees(30, 20, 10);
  Cast(dut, {1, 2, 3}, attitude);
  const Eigen::Matrix3d axes = ToRotation(attitude);
  for (int i = 0; i < 6; ++i) {
    const SegmentQuery& query = batch_.queries()[i];
    const Vector3d along = (i % 2 == 0 ? 1 : -1) * axes.col(i / 2);
    EXPECT_LT((query.direction - along).norm(), 1e-12) << i;
    EXPECT_DOUBLE_EQ(query.length, 0.1 * (i + 1));
    EXPECT_EQ(query.start, Vector3d(1, 2, 3));
  }
}

TEST_F(Methods, BumpMeasuresFromItsOrigin) {
  // A shaft of 0.5 m by 0.7 m round the origin.
  world_.AddBox("shaft", kWall, Eigen::Isometry3d::Identity(), {0.5, 0.7, 9});
  Isector dut = MakeBump("B", {1, 1, 1, 1, 1, 1});
  Cast(dut, {0.05, 0, 0});
  EXPECT_NEAR(dut.Hit(kPlusX, 1).range, 0.20, 1e-12);
  EXPECT_NEAR(dut.Hit(kMinusX, 1).range, 0.30, 1e-12);
  EXPECT_NEAR(dut.Hit(kPlusY, 1).range, 0.35, 1e-12);
  EXPECT_LT((dut.Hit(kMinusY, 1).point - Vector3d(0.05, -0.35, 0)).norm(), 1e-12);
  EXPECT_FALSE(dut.Hit(kPlusZ, 1).hit);
}

TEST_F(Methods, VolumeCastsEachSegmentOfTheUsers) {
  world_.AddPlane("wall", kWall, {0, 1, 0}, -Vector3d::UnitY());
  std::vector<IsectorSegment> fan;
  for (int i = 0; i < 32; ++i) {
    const double angle = i * 2 * kDegree;  // 0..62 deg off the wall's normal
    fan.push_back({.direction = {std::sin(angle), std::cos(angle), 0}, .length = 2});
  }
  Isector dut = MakeVolume("fan", fan);
  Cast(dut, {0, 0, 0});
  for (int i = 0; i < 32; ++i) {
    const double range = 1 / std::cos(i * 2 * kDegree);
    ASSERT_EQ(dut.Hit(i, 1).hit, range <= 2) << i;  // as far as 60 deg
    if (dut.Hit(i, 1).hit) {
      EXPECT_NEAR(dut.Hit(i, 1).range, range, 1e-12);
    }
  }
}

class TripodMethod : public Methods {
 protected:
  // Legs of the golden test.
  Isector dut_ =
      MakeTripod("T", {Vector3d(-0.30, 0.40, 0), {0.30, 0.40, 0}, {0, -0.40, 0}}, {-3, 0.45});
};

TEST_F(TripodMethod, MeetsTheGoldenPlane) {
  AddSlope({0, 0, 0}, Degrees(30, 20, 0));
  Cast(dut_, {0, 0, 0.1}, Degrees(30, 0, 0));
  const Vector3d golden[] = {
      {-0.45981, 0.19641, 0.14559}, {0.05981, 0.49641, 0.14559}, {0.20000, -0.34641, -0.14559}};
  for (int leg = 0; leg < 3; ++leg) {
    EXPECT_LT((dut_.Hit(leg, 1).point - golden[leg]).norm(), 1e-5);  // given to five places
  }
  const GroundFix ground = ReadTripod(dut_, 1);
  EXPECT_EQ(ground.legs, 3);
  const Footing footing = NextFooting(ground, {.z = 0.1}, 30 * kDegree);
  EXPECT_NEAR(footing.z, 0, 1e-12);
  EXPECT_NEAR(footing.attitude.pitch, 20 * kDegree, 1e-12);
  EXPECT_NEAR(footing.attitude.roll, 0, 1e-12);
}

TEST_F(TripodMethod, ReturnsTheAttitudeThatTheSlopeWasMadeOf) {
  for (const Attitude& attitude : {Degrees(0, 10, 0), Degrees(25, -12, 8), Degrees(140, 15, -20)}) {
    world_ = AnalyticWorld();
    AddSlope({0.3, -0.2, 0.1}, attitude);
    Cast(dut_, {0.3, -0.2, 0.2}, {attitude.heading, 0, 0});
    const Footing footing = NextFooting(ReadTripod(dut_, 1), {}, attitude.heading);
    EXPECT_NEAR(footing.z, 0.1, 1e-12);
    EXPECT_NEAR(footing.attitude.pitch, attitude.pitch, 1e-12);
    EXPECT_NEAR(footing.attitude.roll, attitude.roll, 1e-12);
  }
}

TEST_F(TripodMethod, DisabledLegMeetsNoGround) {
  world_.AddPlane("ground", kGround, Vector3d::Zero(), Vector3d::UnitZ());
  dut_.EnableSegment(1, false);
  Cast(dut_, {0, 0, 0.25});
  const GroundFix ground = ReadTripod(dut_, 1);
  EXPECT_EQ(ground.legs, 2);
  EXPECT_NEAR(ground.mean_offset, -0.25, 1e-12);
}

// Missing legs: the footing before stands on a slope of pitch 20 at heading 30.
class MissingLegs : public ::testing::Test {
 protected:
  const Footing last_{.z = 1, .attitude = Degrees(30, 20, 0)};
  static constexpr double kTurned = 120 * kDegree;  // a quarter to the left
};

TEST_F(MissingLegs, TwoKeepTheNormalAndMoveByTheirMean) {
  const Footing next = NextFooting({.legs = 2, .mean_offset = -0.02}, last_, kTurned);
  EXPECT_DOUBLE_EQ(next.z, 0.98);
  // The same plane seen from a quarter turn on: what rose ahead now rises on the right.
  EXPECT_NEAR(next.attitude.pitch, 0, 1e-12);
  EXPECT_NEAR(next.attitude.roll, -20 * kDegree, 1e-12);
  EXPECT_FALSE(next.falling);
}

TEST_F(MissingLegs, OneKeepsTheAttitude) {
  const Footing next = NextFooting({.legs = 1, .mean_offset = 0.03}, last_, kTurned);
  EXPECT_DOUBLE_EQ(next.z, 1.03);
  EXPECT_EQ(next.attitude, (Attitude{kTurned, last_.attitude.pitch, last_.attitude.roll}));
}

TEST_F(MissingLegs, NoneFalls) {
  const Footing next = NextFooting({}, last_, last_.attitude.heading);
  EXPECT_TRUE(next.falling);
  EXPECT_EQ(next.z, last_.z);
  EXPECT_EQ(next.attitude, last_.attitude);
}

TEST_F(MissingLegs, ThreeEndTheFall) {
  Footing falling = last_;
  falling.falling = true;
  EXPECT_FALSE(NextFooting({.legs = 3, .height = 0.5}, falling, 0).falling);
}

}  // namespace
}  // namespace eod::sim
