#include <gtest/gtest.h>

#include "sim/disposal/disposal_status.h"
#include "sim/score/procedure_watch.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

using Kind = ProcedureSpec::Kind;

struct Listed : Judged {
  explicit Listed(const std::vector<ProcedureSpec>& list) : Judged(Make(list)) {}
  static Scenario Make(const std::vector<ProcedureSpec>& list) {
    Scenario scenario = TwoSteps();
    scenario.procedure = list;
    return scenario;
  }
  std::string Result(size_t item = 0) const { return dut.Sheet().procedure.at(item).result; }
  int failed() const {
    return static_cast<int>((kRubric.safety - safety()) / ThePoints().procedure_points + 0.5);
  }
  void Carry(const char* held, double reach) {
    sample.held_object = held;
    sample.charge_position = sample.position + Eigen::Vector3d(0, reach, 0.5);
  }
  void Fire() {
    sample.fire_state = static_cast<int>(FireState::kFired);
    Step();
  }
};

ProcedureSpec Item(Kind kind, int before_step = 0, double distance = 0) {
  return {.kind = kind, .text = "", .before_step = before_step, .distance = distance};
}

TEST(Procedure, WhatIsDoneInTheOrderOfTheListCostsNothing) {
  Listed run({Item(Kind::kEstopTest), Item(Kind::kLampTest), Item(Kind::kCameraTour)});
  EXPECT_EQ(run.Result(), "open");
  uint32_t checks = 0;
  for (const uint32_t check : {uint32_t{kEstopTested}, uint32_t{kLampsTested}, kAllCamerasSeen}) {
    run.sample.checks = checks |= check;
    run.Step();
  }
  run.Succeed();
  EXPECT_EQ(run.failed(), 0);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(run.Result(i), "done");
  EXPECT_NEAR(run.dut.Sheet().procedure[2].time_s, 3 * Judged::kStep, 1e-9);
}

TEST(Procedure, ChecksBeforeTheMissionCount) {
  Listed run({Item(Kind::kLampTest), Item(Kind::kEstopTest)});
  run.sample.mission_s = 0;
  run.sample.checks = kEstopTested | kLampsTested;
  run.Tell();
  run.Succeed();
  EXPECT_EQ(run.failed(), 0);
}

TEST(Procedure, MissingItemsCostAtTheEnd) {
  Listed run({Item(Kind::kEstopTest), Item(Kind::kCameraTour)});
  run.sample.checks = kEstopTested | kDriveCameraSeen | kMastCameraSeen;
  run.Step();
  EXPECT_EQ(run.failed(), 0);
  run.Succeed();
  EXPECT_EQ(run.failed(), 1);
  EXPECT_EQ(run.Result(1), "missing");
}

TEST(Procedure, ItemDoneBeforeTheOneAboveItIsOutOfOrder) {
  Listed run({Item(Kind::kEstopTest), Item(Kind::kLampTest)});
  run.sample.checks = kLampsTested;
  run.Step();
  EXPECT_EQ(run.failed(), 0);  // the one above may never come
  run.sample.checks |= kEstopTested;
  run.Step();
  EXPECT_EQ(run.failed(), 1);
  run.Succeed();
  EXPECT_EQ(run.failed(), 1);
  EXPECT_EQ(run.Result(0), "done");
  EXPECT_EQ(run.Result(1), "out of order");
}

TEST(Procedure, ItemHasToBeDoneBeforeItsStepIsComplete) {
  Listed run({Item(Kind::kLampTest, 1)});
  run.CompleteStep();
  EXPECT_EQ(run.failed(), 1);
  run.sample.checks = kLampsTested;  // too late
  run.Succeed();
  EXPECT_EQ(run.failed(), 1);
  EXPECT_EQ(run.Result(), "missing");
}

TEST(Procedure, ReconWantsTwoCamerasBeforeTheFirstGrasp) {
  const auto result = [](const std::vector<int>& cameras) {
    Listed run({Item(Kind::kTwoCameraRecon)});
    for (const int camera : cameras) {
      run.sample.camera_select = camera;
      run.Step();
    }
    run.Carry("charge", 0.5);
    run.Step();
    run.sample.camera_select = 4;  // afterwards it is no recon
    run.Step();
    run.Succeed();
    return run.Result();
  };
  EXPECT_EQ(result({1}), "missing");
  EXPECT_EQ(result({1, 3}), "done");
  EXPECT_EQ(result({0}), "done");  // all four in one picture
}

TEST(Procedure, HornAndDistanceComeBeforeTheShot) {
  const auto results = [](bool honks, double distance) {
    Listed run({Item(Kind::kHornBeforeFire), Item(Kind::kRetreatBeforeFire, 0, 1.5)});
    run.sample.horn = honks;
    run.Step();
    run.sample.horn = false;
    run.sample.charge_position = run.sample.position + Eigen::Vector3d(0, distance, 0);
    run.Fire();
    run.sample.horn = true;
    run.Step();
    run.Succeed();
    return run.Result(0) + ", " + run.Result(1);
  };
  EXPECT_EQ(results(true, 1.6), "done, done");
  EXPECT_EQ(results(false, 1.4), "missing, missing");
}

TEST(Procedure, CarryingAtHighSpeedBreaksTheRule) {
  const auto result = [](const char* held, int range) {
    Listed run({Item(Kind::kLowSpeedWhileCarrying)});
    run.Carry(held, 0.5);
    run.sample.speed_range = range;
    run.Drive(0.5);
    run.Succeed();
    return run.Result();
  };
  EXPECT_EQ(result("charge", 1), "kept");
  EXPECT_EQ(result("", 2), "kept");
  EXPECT_EQ(result("charge", 2), "broken");
}

TEST(Procedure, ChargeHasToBeDrawnInBeforeALongWay) {
  const auto result = [](double reach, double way) {
    Listed run({Item(Kind::kTravelPoseBeforeDriving)});
    run.sample.speed_mps = 1;
    for (double y = 0; y < way; y += 0.1) {
      run.sample.position.y() += 0.1;
      run.Carry("charge", reach);
      run.Step();
    }
    run.Succeed();
    return run.Result();
  };
  const double reach = ThePoints().travel_reach, slack = ThePoints().travel_slack;
  EXPECT_EQ(result(reach - 0.05, 3 * slack), "kept");
  EXPECT_EQ(result(reach + 0.05, slack - 0.15), "kept");
  EXPECT_EQ(result(reach + 0.05, slack + 0.15), "broken");
}

TEST(Procedure, ArmingOnTheMoveBreaksTheRule) {
  Listed run({Item(Kind::kArmKeySafeUntilStill)});
  run.sample.arm_key = 2;
  run.Step();
  EXPECT_EQ(run.Result(), "open");
  run.sample.turn_rate_dps = 1;
  run.Step();
  EXPECT_EQ(run.Result(), "broken");
  EXPECT_EQ(EventsOf(run.dut, ScoreMark::kProcedure).size(), 1u);
}

}  // namespace
}  // namespace eod::sim
