#include "sim/disposal/charge_watch.h"

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kHalf = 0.12, kRadius = 0.06;  // of the charge M

Isometry3d Standing(double bottom, double tilt_deg = 0, const Vector3d& at = {0, 5, 0}) {
  Isometry3d X_MO(Eigen::Translation3d(at.x(), at.y(), 0));
  X_MO.rotate(AngleAxisd(tilt_deg * kDegree, Vector3d::UnitX()));
  X_MO.translation().z() = bottom - LowestPoint({kRadius, kHalf}, X_MO);
  return X_MO;
}

/// The drum of the bomb module: rim 0.85 m, net 0.35 m below it, 0.50 m wide.
VesselSpec Drum() {
  VesselSpec drum;
  drum.X_MV = Eigen::Translation3d(4, 4, 0) * Isometry3d::Identity();
  drum.inner_radius = 0.25;
  drum.rim_z = 0.85;
  drum.net_z = 0.50;
  return drum;
}

class Watching : public ::testing::Test {
 protected:
  explicit Watching(const Isometry3d& start = Standing(0)) : module_(Yard(start)) {
    body_.X_MO = start;
    body_.touches_ground = true;
  }

  static ModuleModel Yard(const Isometry3d& start) {
    ModuleModel module = BombModule({CylinderM()});
    module.movables[0].X_MO = start;
    module.vessels.push_back(Drum());
    return module;
  }
  DetonationCause Step(bool held = false, bool touched = false) {
    const char touch = touched ? 1 : 0;
    const auto found = dut_.Update({&body_, 1}, {&touch, 1}, held ? 0 : -1);
    return found ? found->cause : DetonationCause::kNone;
  }
  void Place(const Isometry3d& X_MO, bool on_ground) {
    body_.X_MO = X_MO;
    body_.touches_ground = on_ground;
    body_.is_moving = !on_ground;
  }
  const ChargeState& charge() const { return dut_.charges()[0]; }

  ModuleModel module_;
  BodyState body_;
  ChargeWatch dut_{module_, TheRules().charge, TheRules().vessel};
};

TEST_F(Watching, StandsUntouched) {
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_EQ(charge().state, BombState::kPlaced);
  EXPECT_EQ(charge().tilt, 0);
  EXPECT_FALSE(charge().touched || charge().disturbed || charge().unstable || charge().in_vessel);
}

TEST_F(Watching, TouchedByLinesOrByABodyWhileItLasts) {
  Step(false, true);
  EXPECT_TRUE(charge().touched);
  EXPECT_EQ(charge().state, BombState::kTouched);
  Step();
  EXPECT_FALSE(charge().touched);
  body_.touched_by = 1u << static_cast<int>(Part::kFrontLeftWheel);
  Step();
  EXPECT_TRUE(charge().touched);
}

TEST_F(Watching, DisturbedBeyondFiveUnstableBeyondFifteenFallingBeyondTheBalance) {
  struct Case {
    double tilt;
    bool disturbed, unstable;
  };
  // atan(60 / 120) is 26.57 degrees.
  for (const Case& c : {Case{4.9, false, false},
                        {5.1, true, false},
                        {14.9, true, false},
                        {15.1, true, true},
                        {26.5, true, true}}) {
    Place(Standing(0, c.tilt), true);
    EXPECT_EQ(Step(), DetonationCause::kNone) << c.tilt;
    EXPECT_NEAR(charge().tilt, c.tilt * kDegree, 1e-12);
    EXPECT_EQ(charge().disturbed, c.disturbed) << c.tilt;
    EXPECT_EQ(charge().unstable, c.unstable) << c.tilt;
    EXPECT_EQ(charge().state, c.disturbed ? BombState::kTilted : BombState::kPlaced);
  }
  Place(Standing(0, 26.6), true);
  EXPECT_EQ(Step(), DetonationCause::kTipped);
}

TEST_F(Watching, FallsOfMoreThanFifteenCentimetresSetItOff) {
  for (const auto& [height, cause] :
       {std::pair{0.149, DetonationCause::kNone}, {0.151, DetonationCause::kDropped}}) {
    dut_.Reset();
    Place(Standing(height), false);
    EXPECT_EQ(Step(true), DetonationCause::kNone);
    EXPECT_EQ(Step(), DetonationCause::kNone);  // let go
    EXPECT_EQ(charge().state, BombState::kDropped);
    Place(Standing(height / 2), false);
    EXPECT_EQ(Step(), DetonationCause::kNone);
    Place(Standing(0), true);
    EXPECT_EQ(Step(), cause) << height;
  }
}

TEST_F(Watching, PutDownGentlyItStandsAgain) {
  Place(Standing(0.3), false);
  Step(true);
  Place(Standing(0.02, 3), false);
  Step(true);
  EXPECT_EQ(charge().state, BombState::kCarried);
  Step();
  Place(Standing(0), true);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_EQ(charge().state, BombState::kPlaced);
}

TEST_F(Watching, ASlideDownARampIsNoFall) {
  Place(Standing(1), false);
  Step(true);
  for (double height = 1; height > 0; height -= 0.01) {
    Place(Standing(height), true);
    EXPECT_EQ(Step(), DetonationCause::kNone);
  }
}

TEST_F(Watching, LetGoLeaningInTheAirItIsNoTippedCharge) {
  Place(Standing(0.1, 40), false);
  Step(true);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_FALSE(charge().disturbed || charge().unstable);
  // On the ground it is one.
  Place(Standing(0, 40), true);
  EXPECT_EQ(Step(), DetonationCause::kTipped);
}

TEST_F(Watching, FallsIntoTheCanAndRestsOnTheNetInAnyAttitude) {
  const Vector3d over(4, 4.1, 0);
  Place(Standing(0.85 + 0.25, 40, over), false);
  Step(true);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_EQ(charge().state, BombState::kDropped);
  Place(Standing(0.7, 60, over), false);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_TRUE(charge().in_vessel);
  EXPECT_EQ(charge().state, BombState::kDropped);
  Place(Standing(0.50, 90, over), true);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_EQ(charge().state, BombState::kInCan);
}

TEST_F(Watching, LetGoInTheCanItIsNotInItBeforeItMeetsTheNet) {
  Place(Standing(0.52, 0, {4, 4, 0}), false);
  Step(true);
  body_.is_moving = false;  // as in the step that lets it go
  Step();
  EXPECT_EQ(charge().state, BombState::kDropped);
  Place(Standing(0.50, 0, {4, 4, 0}), true);
  Step();
  EXPECT_EQ(charge().state, BombState::kInCan);
}

TEST_F(Watching, BesideTheCanTheDropRuleDecides) {
  const Vector3d beside(4, 4.3, 0);
  Place(Standing(1.0, 0, beside), false);
  Step(true);
  Step();
  Place(Standing(0, 0, beside), true);
  EXPECT_EQ(Step(), DetonationCause::kDropped);
  EXPECT_FALSE(charge().in_vessel);
}

TEST_F(Watching, DisruptedItIsSafeWhateverHappens) {
  dut_.Disrupt(0);
  EXPECT_EQ(charge().state, BombState::kDisrupted);
  Place(Standing(0, 80), true);
  EXPECT_EQ(Step(false, true), DetonationCause::kNone);
  EXPECT_FALSE(charge().touched || charge().disturbed);
}

class WatchingOneThatLies : public Watching {
 protected:
  WatchingOneThatLies() : Watching(Standing(0, 90)) {}
};

TEST_F(WatchingOneThatLies, IsNotTippedForThatAndMayRoll) {
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_NEAR(charge().tilt, 0, 1e-12);
  body_.X_MO = body_.X_MO * AngleAxisd(1.0, Vector3d::UnitZ());
  EXPECT_EQ(Step(), DetonationCause::kNone);
  EXPECT_FALSE(charge().disturbed);
}

TEST_F(WatchingOneThatLies, IsDisturbedWhenAnEndIsLifted) {
  Place(Standing(0, 90 - 6), true);
  Step();
  EXPECT_TRUE(charge().disturbed);
  // atan(120 / 60) is 63.4 degrees: upright from there.
  Place(Standing(0, 90 - 63), true);
  EXPECT_EQ(Step(), DetonationCause::kNone);
  Place(Standing(0, 90 - 64), true);
  EXPECT_EQ(Step(), DetonationCause::kTipped);
}

TEST(ChargeWatch, TheOneThatMattersIsHeldElseLastTouchedElseTheFirst) {
  ModuleModel module = BombModule({CylinderM(), CylinderM(), CylinderM()});
  for (int i = 0; i < 3; ++i) module.movables[i].X_MO = Standing(0, 0, {1.0 * i, 5, 0});
  std::vector<BodyState> bodies(3);
  for (int i = 0; i < 3; ++i) bodies[i].X_MO = module.movables[i].X_MO;
  ChargeWatch dut(module, TheRules().charge, TheRules().vessel);
  std::vector<char> touched(3);
  dut.Update(bodies, touched, -1);
  EXPECT_EQ(dut.main()->body, 0);
  touched[2] = 1;
  dut.Update(bodies, touched, -1);
  touched[2] = 0;
  dut.Update(bodies, touched, -1);
  EXPECT_EQ(dut.main()->body, 2);
  dut.Update(bodies, touched, 1);
  EXPECT_EQ(dut.main()->body, 1);
}

TEST(Vessel, AChamberHoldsWhatIsBetweenItsWallsAboveItsTray) {
  VesselSpec chamber;
  chamber.X_MV = Eigen::Translation3d(1, 2, 0.3) * AngleAxisd(0.5, Vector3d::UnitZ());
  chamber.half_size = {0.4, 0.2, 0};
  chamber.net_z = 0.6;
  chamber.rim_z = 1.2;
  const double sag = TheRules().vessel.net_sag;
  const auto holds = [&](double x, double y, double lowest) {
    return IsInside(chamber, chamber.X_MV * Vector3d(x, y, lowest), 0.3 + lowest, sag);
  };
  EXPECT_TRUE(holds(0.39, 0.19, 0.6));
  EXPECT_FALSE(holds(0.41, 0, 0.6));
  EXPECT_FALSE(holds(0, 0.21, 0.6));
  EXPECT_FALSE(holds(0, 0, 1.2));
  EXPECT_TRUE(holds(0, 0, 0.6 - 0.04));
  EXPECT_FALSE(holds(0, 0, 0.6 - 0.06));
}

}  // namespace
}  // namespace eod::sim
