#include "sim/disposal/grasp.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kClosing =
    0.27 * 0.15 * kStep;  // [m] a hand and step: 0.27 units of 0.15 m a second
constexpr double kPad = 0.005;

TEST(Grasp, CentredChargeIsGraspedAfterThreeSteps) {
  Bench bench;
  bench.Open(0.08);
  bench.PlaceInHand(0, 0);
  ASSERT_TRUE(bench.CloseUntilGrasped());
  EXPECT_EQ(bench.dut.status().grasp, GraspState::kGrasped);
  EXPECT_EQ(bench.dut.status().bomb, BombState::kGrasped);
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kNone);
  // The left hand stops just inside of the surface, the right one has two steps more.
  EXPECT_NEAR(bench.state.left_opening, 0.06, kClosing + 1e-9);
  EXPECT_GE(bench.state.right_opening, 0.06 - 4 * kClosing);
}

TEST(Grasp, TwentyFiveMillimetresLeftTheLeftHandStopsAndTheRightOneGoesOnUntilItGrasps) {
  Bench bench;
  bench.Open(0.10);
  bench.PlaceInHand(-0.025, 0);
  bool left_stood = false;
  for (int i = 0; i < 2000 && bench.dut.status().held_body < 0; ++i) {
    const RobotState before = bench.state;
    bench.Step(DemandFor({kGripperClose}));
    if (before.left_opening == bench.state.left_opening &&
        before.right_opening > bench.state.right_opening) {
      left_stood = true;
      EXPECT_EQ(bench.dut.status().grasp, bench.state.right_opening > 0.035 - kClosing
                                              ? GraspState::kContactLeft
                                              : bench.dut.status().grasp);
    }
  }
  EXPECT_TRUE(left_stood);
  EXPECT_EQ(bench.dut.status().held_body, 0);
  EXPECT_NEAR(bench.state.left_opening, 0.085, kClosing + 1e-9);
  EXPECT_NEAR(bench.state.right_opening, 0.035, 5 * kClosing);
}

TEST(Grasp, TwentyFiveMillimetresRightTheRightPadYieldsByItsThicknessAndStops) {
  Bench bench;
  bench.Open(0.10);
  bench.PlaceInHand(0.025, 0);
  double right_stood_at = 0;
  for (int i = 0; i < 2000 && bench.dut.status().held_body < 0; ++i) {
    const RobotState before = bench.state;
    bench.Step(DemandFor({kGripperClose}));
    if (before.right_opening == bench.state.right_opening) right_stood_at = before.right_opening;
  }
  EXPECT_EQ(bench.dut.status().held_body, 0);
  EXPECT_NEAR(right_stood_at, 0.085 - kPad, kClosing + 1e-9);
  EXPECT_NEAR(bench.state.left_opening, 0.035, 5 * kClosing);
}

TEST(Grasp, BeyondTheWindowOfThePadsBothHandsStopAndNothingIsGrasped) {
  // At 5 mm the window of a = 60 mm is 23 mm.
  for (const double ahead : {-0.022, 0.022}) {
    Bench bench;
    bench.Open(0.07);
    bench.PlaceInHand(0, ahead);
    EXPECT_TRUE(bench.CloseUntilGrasped()) << ahead;
  }
  for (const double ahead : {-0.027, 0.027}) {
    Bench bench;
    bench.Open(0.07);
    bench.PlaceInHand(0, ahead);
    EXPECT_FALSE(bench.CloseUntilGrasped(100)) << ahead;
    EXPECT_EQ(bench.dut.status().grasp, GraspState::kContactBoth);
    EXPECT_NEAR(bench.state.left_opening, 0.06 - kPad, kClosing + 1e-9);
    EXPECT_NEAR(bench.state.right_opening, 0.06 - kPad, kClosing + 1e-9);
    EXPECT_TRUE(Contains(bench.response.blocked, kGripperClose));
    EXPECT_TRUE(bench.dut.status().touched);
  }
}

TEST(Grasp, SqueezedForMoreThanASecondItGoesOff) {
  Bench bench;
  bench.Open(0.0551);
  bench.PlaceInHand(0, 0.027);
  // One step to 54.9 mm, where both pads are pressed through.
  const int second = static_cast<int>(TheRules().grasp.squeeze / kStep);
  bench.Step(DemandFor({kGripperClose}), second + 1);
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kNone);
  bench.Step({});  // letting go starts a new second
  bench.Step(DemandFor({kGripperClose}), second);
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kNone);
  bench.Step(DemandFor({kGripperClose}), 2);
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kSqueezed);
  EXPECT_EQ(bench.dut.status().bomb, BombState::kExploded);
  EXPECT_TRUE(bench.dut.status().robot_destroyed);
  EXPECT_EQ(bench.removed, 0);
}

/// A charge that fulfils all guards; each test breaks one.
Grip GoodGrip() {
  Grip grip;
  grip.charge = {0.06, 0.12};
  const double half_chord = std::sqrt(2 * 0.06 * 0.003 - 0.003 * 0.003), x = 0.057;
  const auto see = [&](int line, const Vector3d& point) {
    grip.lines[line] = {.charge = 0, .point = point, .normal = Vector3d(point / 0.06)};
  };
  see(kL1, {-x, half_chord, 0});
  see(kL2, {-x, -half_chord, 0});
  see(kL3, {0.06, 0, 0});
  see(kL5, {x, half_chord, 0});
  see(kL9, {0, -0.06, 0});
  grip.gap = 2 * x;
  grip.mass = 3;
  grip.payload = 8;
  return grip;
}

TEST(GraspGuards, HoldForAGoodGrip) { EXPECT_TRUE(GuardsHold(GoodGrip(), TheRules().grasp)); }

TEST(GraspGuards, RefuseEachByItself) {
  const GraspRules& rules = TheRules().grasp;
  const auto refuses = [&](auto change) {
    Grip grip = GoodGrip();
    change(grip);
    return !GuardsHold(grip, rules);
  };
  EXPECT_TRUE(refuses([](Grip& grip) { grip.closing_age = 0.21; }));
  EXPECT_FALSE(refuses([](Grip& grip) { grip.closing_age = 0.19; }));
  EXPECT_TRUE(refuses([](Grip& grip) { grip.lines[kL4].charge = 0; }));
  EXPECT_TRUE(refuses([](Grip& grip) { grip.relative_speed = 0.051; }));
  EXPECT_TRUE(refuses([](Grip& grip) { grip.tilt = 15.1 * kDegree; }));
  EXPECT_TRUE(refuses([](Grip& grip) { grip.mass = 8.001; }));
  // Twice the pad of 5 mm, either way.
  EXPECT_TRUE(refuses([](Grip& grip) { grip.gap = 0.12 - 0.0101; }));
  EXPECT_TRUE(refuses([](Grip& grip) { grip.gap = 0.12 + 0.0101; }));
  EXPECT_FALSE(refuses([](Grip& grip) { grip.gap = 0.12 - 0.0099; }));
  // l5 enters through an end cap: the pads press on sides that are not opposed.
  EXPECT_TRUE(refuses([](Grip& grip) { grip.lines[kL5].normal = Vector3d::UnitY(); }));
  // A hit beside the surface is none of this charge (Eq. 8).
  EXPECT_TRUE(refuses([](Grip& grip) { grip.lines[kL9].point.y() -= 0.003; }));
}

TEST(GraspGuards, RefuseACylinderThatLeansAcrossTheJawsByMoreThan20Degrees) {
  for (const double lean : {-21.0, -19.0, 19.0, 21.0}) {
    Grip grip = GoodGrip();
    grip.closing_M = AngleAxisd(lean * kDegree, Vector3d::UnitY()) * Vector3d::UnitX();
    EXPECT_EQ(IsHeldWell(grip, TheRules().grasp), std::abs(lean) < 20) << lean;
  }
}

TEST(Grasp, AChargeThatIsTooHeavyIsNotGraspedInGuardedMode) {
  Bench bench;
  bench.payload = 2.9;
  bench.Open(0.065);
  bench.PlaceInHand(0, 0);
  EXPECT_FALSE(bench.CloseUntilGrasped(200));
}

TEST(Grasp, InPaperModeTheLinesAloneDecideAndALeaningChargeSlipsOut) {
  const Quaterniond lean(AngleAxisd(24 * kDegree, Vector3d::UnitY()));
  Bench guarded;
  guarded.Open(0.08);
  guarded.PlaceInHand(0, 0, lean);
  EXPECT_FALSE(guarded.CloseUntilGrasped(200));

  Bench paper(BombModule({CylinderM()}), GraspMode::kPaper);
  paper.Open(0.08);
  paper.PlaceInHand(0, 0, lean);
  ASSERT_TRUE(paper.CloseUntilGrasped());
  EXPECT_EQ(paper.dut.status().grasp, GraspState::kSlipping);
  const double height = paper.bodies[0].X_MO.translation().z();
  paper.Step({}, 250);  // a second
  EXPECT_NEAR(height - paper.bodies[0].X_MO.translation().z(), TheRules().grasp.slip_speed, 1e-9);
  paper.Step({}, 510);  // three altogether
  EXPECT_EQ(paper.released, 0);
  EXPECT_EQ(paper.dut.status().held_body, -1);
  EXPECT_EQ(paper.dut.status().grasp, GraspState::kReleased);
}

/// A bench that holds its charge, off centre by 15 mm and turned round its axis.
std::unique_ptr<Bench> Holding() {
  auto bench = std::make_unique<Bench>();
  bench->Open(0.08);
  bench->PlaceInHand(0, 0.015, Quaterniond(AngleAxisd(0.7, Vector3d::UnitZ())));
  EXPECT_TRUE(bench->CloseUntilGrasped());
  return bench;
}

TEST(Grasp, DoesNotMoveTheChargeWhenItIsTaken) {
  Bench bench;
  bench.Open(0.08);
  bench.PlaceInHand(-0.01, 0.015);
  const Isometry3d X_MO = bench.bodies[0].X_MO;
  ASSERT_TRUE(bench.CloseUntilGrasped());
  EXPECT_TRUE(bench.bodies[0].X_MO.isApprox(X_MO, 1e-12));
}

TEST(Grasp, CarriesRigidlyThroughAllMotions) {
  const auto bench = Holding();
  const Isometry3d X_GO = bench->X_MG().inverse() * bench->bodies[0].X_MO;
  for (const int motion : {kBigArmUp, kSmallArmUp, kWristDown, kGripperCcw, kDriveForward,
                           kTurnLeft, kDriveReverse, kSmallArmDown}) {
    bench->Step(DemandFor({motion}), 100);
    const Isometry3d now = bench->X_MG().inverse() * bench->bodies[0].X_MO;
    EXPECT_TRUE(now.isApprox(X_GO, 1e-12)) << "M" << motion + 1;
  }
  EXPECT_EQ(bench->dut.status().bomb, BombState::kCarried);
  EXPECT_FALSE(bench->dut.status().touched);
}

TEST(Grasp, HeldChargeIsSeenByNoLineAndStopsNothing) {
  const auto bench = Holding();
  EXPECT_TRUE(bench->dut.Ignores(0));
  bench->Step(DemandFor({kDriveForward, kBigArmUp}), 5);
  EXPECT_EQ(bench->response.blocked, 0u);
  for (const HandLine& line : bench->Lines()) EXPECT_EQ(line.charge, -1);
}

TEST(Grasp, ClosingOnPressesNoDeeper) {
  const auto bench = Holding();
  const RobotState held = bench->state;
  bench->Step(DemandFor({kGripperClose}), 500);
  EXPECT_EQ(bench->state, held);
  EXPECT_EQ(bench->dut.status().detonation, DetonationCause::kNone);
}

TEST(Grasp, OpensByFourMillimetresBeforeItLetsGo) {
  const auto bench = Holding();
  const double held_at = bench->state.joint[kGripperOpening];
  // The crossbeam slides back by two thirds meanwhile; the charge does not follow it.
  const Isometry3d X_MO = bench->bodies[0].X_MO;
  const int steps = static_cast<int>(std::ceil(0.004 / kClosing));
  bench->Step(DemandFor({kGripperOpen}), steps - 1);
  EXPECT_EQ(bench->released, -1);
  EXPECT_TRUE(bench->bodies[0].X_MO.isApprox(X_MO, 1e-12));
  bench->Step(DemandFor({kGripperOpen}));
  EXPECT_EQ(bench->released, 0);
  EXPECT_GE(bench->state.joint[kGripperOpening] - held_at, 0.004 - 1e-9);
  EXPECT_EQ(bench->dut.status().grasp, GraspState::kReleased);
  EXPECT_EQ(bench->dut.status().bomb, BombState::kDropped);
  EXPECT_FALSE(bench->dut.Ignores(0));
  // It is not taken again by hands that open.
  bench->Step(DemandFor({kGripperOpen}), 100);
  EXPECT_EQ(bench->dut.status().held_body, -1);
}

TEST(Grasp, OverloadedByAFartherReachItSlipsAndHoldsAgainWhenTheReachIsLess) {
  const auto bench = Holding();
  bench->payload = 2;
  bench->Step({}, 250);
  EXPECT_EQ(bench->dut.status().grasp, GraspState::kSlipping);
  bench->payload = 10;
  bench->Step({}, 2000);
  EXPECT_EQ(bench->dut.status().grasp, GraspState::kGrasped);
  EXPECT_EQ(bench->released, -1);
}

TEST(Grasp, RollingOverWithItSetsItOff) {
  const auto bench = Holding();
  bench->rolled_over = true;
  bench->Step({});
  EXPECT_EQ(bench->dut.status().detonation, DetonationCause::kCrushed);
  EXPECT_EQ(bench->released, 0);
  EXPECT_EQ(bench->removed, 0);
}

TEST(Grasp, ANewStartForgetsEverything) {
  const auto bench = Holding();
  bench->rolled_over = true;
  bench->Step({});
  bench->dut.Reset();
  const Bench fresh;
  EXPECT_EQ(bench->dut.status(), fresh.dut.status());
}

TEST(Disposal, AModuleWithoutChargesIsAtPeace) {
  Bench bench(BombModule({}));
  bench.Step(DemandFor({kGripperClose, kDriveForward}), 100);
  EXPECT_EQ(bench.dut.status().bomb, BombState::kNone);
  EXPECT_EQ(bench.dut.status().bomb_body, -1);
  EXPECT_EQ(bench.dut.status().grasp, GraspState::kClosing);
}

TEST(HandLines, AChargeBetweenTheHandsStopsNoApproachUntilItTouches) {
  // 3.4: l3, l6 and l9 alone are nearness. A charge of which the beam is 60 mm away may come
  // nearer.
  Bench bench;
  bench.Open(0.12);
  bench.PlaceInHand(0, 0.02);
  const double before = bench.Range("l9");
  for (const int motion : {kDriveForward, kTurnLeft, kTurnRight}) {
    bench.Step(DemandFor({motion}), 5);
    EXPECT_EQ(bench.response.blocked, 0u) << "M" << motion + 1;
    EXPECT_GE(bench.Lines()[kL9].charge, 0);
  }
  EXPECT_NE(bench.Range("l9"), before);
  // The beam's own skin is 20 mm.
  bench.Step(DemandFor({kDriveForward}), 200);
  EXPECT_TRUE(Contains(bench.response.blocked, kDriveForward));
  EXPECT_NEAR(bench.Range("l9"), 0.02, 0.30 * kStep + 1e-9);
}

}  // namespace
}  // namespace eod::sim
