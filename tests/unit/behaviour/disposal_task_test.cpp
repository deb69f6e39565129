// Steps and failures of missions with charges, and of those on slopes.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/mission_under_way.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kSmall = 0, kLarge = 1;  // of the movables

/// Two charges, and a can at (0, 18) with its net at 0.50 and its rim at 0.85.
ModuleModel BombYard() {
  ModuleModel module;
  module.id = 3;
  module.name = "bomb";
  WorldObject can;
  can.name = "can";
  can.X_MO.translation() = Eigen::Vector3d(0, 18, 0);
  module.objects.push_back(can);
  module.vessels.push_back(
      {.name = "can", .X_MV = can.X_MO, .inner_radius = 0.25, .net_z = 0.50, .rim_z = 0.85});
  for (const char* name : {"small", "large"}) {
    MovableObject charge;
    charge.name = name;
    charge.explosive = ExplosiveSpec{.radius = 0.06, .half_height = 0.12};
    module.movables.push_back(charge);
  }
  module.movables[kSmall].X_MO.translation() = Eigen::Vector3d(0, 6, 0.12);
  module.movables[kLarge].X_MO.translation() = Eigen::Vector3d(4, 6, 0.12);
  return module;
}

/// A mission in that yard, with the charges where they stood.
struct Disposal : Mission {
  DisposalStatus disposal;
  std::vector<Eigen::Isometry3d> X_MO;

  explicit Disposal(std::vector<TaskStep> steps) : Mission(std::move(steps), 0, BombYard()) {
    for (const MovableObject& charge : BombYard().movables) X_MO.push_back(charge.X_MO);
    inputs.disposal = &disposal;
    inputs.movables = X_MO;
  }
  Disposal(const Disposal&) = delete;
  Disposal& operator=(const Disposal&) = delete;

  MissionState StepWith(int held, double height) {
    disposal.held_body = held;
    if (held >= 0) X_MO[held].translation().z() = height;
    return Step().state;
  }
};

TEST(DisposalTask, GraspWantsTheNamedCharge) {
  Disposal dut({StepOf(TaskStep::Kind::kGrasp, "large")});
  EXPECT_EQ(dut.StepWith(kSmall, 0.12), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kLarge, 0.12), MissionState::kSuccess);
}

TEST(DisposalTask, LiftCountsFromWhereTheChargeWasGrasped) {
  Disposal dut({StepOf(TaskStep::Kind::kLift, "small", 0.2)});
  dut.X_MO[kSmall].translation().z() = 0.83;  // on a table
  EXPECT_EQ(dut.StepWith(-1, 0), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 0.83), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 1.02), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 1.04), MissionState::kSuccess);
}

TEST(DisposalTask, LiftBeginsAnewWithEveryGrasp) {
  Disposal dut({StepOf(TaskStep::Kind::kLift, "", 0.2)});
  EXPECT_EQ(dut.StepWith(kSmall, 0.12), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(-1, 0), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 0.25), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 0.40), MissionState::kRun);
  EXPECT_EQ(dut.StepWith(kSmall, 0.46), MissionState::kSuccess);
}

TEST(DisposalTask, VesselHoldsTheChargeThatRestsWithinItsWallAndAboveItsNet) {
  const auto place = [](const Eigen::Vector3d& p_M, BombState bomb) {
    Disposal dut({StepOf(TaskStep::Kind::kPlaceInVessel, "can")});
    dut.disposal.bomb_body = kLarge;
    dut.disposal.bomb = bomb;
    dut.X_MO[kLarge].translation() = p_M;
    return dut.Step().state;
  };
  EXPECT_EQ(place({0.1, 18.1, 0.62}, BombState::kInCan), MissionState::kSuccess);
  EXPECT_EQ(place({0.1, 18.1, 0.62}, BombState::kCarried), MissionState::kRun);
  EXPECT_EQ(place({0.26, 18, 0.62}, BombState::kInCan), MissionState::kRun);
  EXPECT_EQ(place({0, 18, 0.49}, BombState::kInCan), MissionState::kRun);
  EXPECT_EQ(place({0, 18, 0.86}, BombState::kInCan), MissionState::kRun);
}

TEST(DisposalTask, ShotCountsForTheNamedChargeOrForAny) {
  for (const auto& [object, body, done] :
       {std::tuple("small", kSmall, true), {"small", kLarge, false}, {"", kLarge, true}}) {
    Disposal dut({StepOf(TaskStep::Kind::kDisrupt, object)});
    EXPECT_EQ(dut.Step().state, MissionState::kRun);
    dut.disposal.bomb = BombState::kDisrupted;
    dut.disposal.bomb_body = body;
    EXPECT_EQ(dut.Step().state == MissionState::kSuccess, done) << object << body;
  }
}

TEST(DisposalTask, RetreatIsMeasuredOnTheMapFromWhereTheThingIsNow) {
  Disposal from_charge({StepOf(TaskStep::Kind::kRetreat, "small", 10)});
  from_charge.X_MO[kSmall].translation() = Eigen::Vector3d(0, 9, 5);
  from_charge.state.position = {0, -0.9, 0};
  EXPECT_EQ(from_charge.Step().state, MissionState::kRun);
  from_charge.state.position = {0, -1.1, 0};
  EXPECT_EQ(from_charge.Step().state, MissionState::kSuccess);

  Disposal from_can({StepOf(TaskStep::Kind::kRetreat, "can", 20)});
  from_can.state.position = {12, 2.1, 0};
  EXPECT_EQ(from_can.Step().state, MissionState::kRun);
  from_can.state.position = {12, 1.9, 0};
  EXPECT_EQ(from_can.Step().state, MissionState::kSuccess);
}

TEST(DisposalTask, DetonationFailsEvenTheLastStep) {
  Disposal dut({StepOf(TaskStep::Kind::kGrasp, "small")});
  dut.disposal.detonation = DetonationCause::kSqueezed;
  EXPECT_EQ(dut.StepWith(kSmall, 0.12), MissionState::kFail);
  EXPECT_EQ(dut.task.status().fail_reason, FailReason::kExploded);
}

TEST(DisposalTask, FallingChargeIsNotJudgedBeforeItLands) {
  Disposal dut({StepOf(TaskStep::Kind::kGrasp, "small")});
  dut.disposal.bomb = BombState::kDropped;
  EXPECT_EQ(dut.Step().state, MissionState::kRun);
}

TEST(DisposalTask, WithoutChargesItsStepsAreNeverDone) {
  for (const TaskStep::Kind kind : {TaskStep::Kind::kGrasp, TaskStep::Kind::kDisrupt}) {
    Mission dut({StepOf(kind, "small")}, 0, BombYard());
    EXPECT_EQ(dut.Step().state, MissionState::kRun);
  }
}

TEST(DisposalTask, ObjectOfTheWrongSortIsRefused) {
  const auto refusal = [](TaskStep::Kind kind, const std::string& object) -> std::string {
    Scenario scenario = Mission::Make({StepOf(kind, object)}, 0);
    scenario.file = "x.toml";
    try {
      Task dut(scenario, BombYard());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal(TaskStep::Kind::kGrasp, "can"),
            "x.toml: object 'can' is no movable of module 3 (bomb)");
  EXPECT_EQ(refusal(TaskStep::Kind::kPlaceInVessel, "small"),
            "x.toml: object 'small' is no vessel of module 3 (bomb)");
  EXPECT_EQ(refusal(TaskStep::Kind::kLift, "smal"),
            "x.toml: object 'smal' is not in module 3 (bomb)");
  EXPECT_EQ(refusal(TaskStep::Kind::kContact, "small"), "accepted");
}

TEST(SlopeTask, ClimbWantsTheHeightAtThePlace) {
  TaskStep top = StepOf(TaskStep::Kind::kClimb, "", 1.5, 0.5);
  top.x = 4;
  top.y = 11;
  Mission dut({top});
  dut.state.position = {4, 11.4, 1.49};
  EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.state.position = {4, 11.6, 1.51};
  EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.state.position = {4, 11.4, 1.51};
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
}

TEST(SlopeTask, HoldStillWantsItsTimeTiltedAndWithoutAMove) {
  TaskStep hold = StepOf(TaskStep::Kind::kHoldStill, "");
  hold.time = 1.0;
  hold.tilt = 18 * kDegree;
  Mission dut({hold});  // 0.1 s a step
  dut.state.attitude.pitch = 20 * kDegree;
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.state.attitude.pitch = 17 * kDegree;  // too flat: counts anew
  EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.state.attitude.roll = 10 * kDegree;  // together 19.6 degrees
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.inputs.turn_rate = 0.01;
  EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.inputs.turn_rate = 0;
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
}

}  // namespace
}  // namespace eod::sim
