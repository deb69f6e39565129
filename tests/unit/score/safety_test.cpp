// Each way to lose points for safety.
#include <numbers>

#include <gtest/gtest.h>

#include "sim/robot/motion_id.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
enum Camera : int { kQuad, kDrive, kGripper, kMast, kRear };

Scenario OneStep(TaskStep::Kind kind, const std::string& object) {
  Scenario scenario = TwoSteps();
  scenario.steps = {StepTo(kind, object), StepTo(TaskStep::Kind::kReach)};
  return scenario;
}

/// Points lost when `object` is touched during that step.
double LossByContact(TaskStep::Kind kind, const std::string& asked, const char* object,
                     bool by_held = false) {
  Judged run(OneStep(kind, asked));
  run.sample.contact_parts = 1;
  run.sample.contact_object = object;
  run.sample.contact_by_held = by_held;
  run.Step();
  return kRubric.safety - run.safety();
}

TEST(Safety, EachNewCollisionCosts) {
  Judged run;
  for (const uint32_t parts : {1u, 1u, 3u, 0u, 1u}) {  // begins, goes on, one more, over, again
    run.sample.contact_parts = parts;
    run.Step();
  }
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety - 3 * ThePoints().collision_points);
  EXPECT_EQ(EventsOf(run.dut, ScoreMark::kCollision).size(), 3u);
}

TEST(Safety, CollisionsThatAStepAsksForAreFree) {
  using Kind = TaskStep::Kind;
  const double points = ThePoints().collision_points;
  EXPECT_EQ(LossByContact(Kind::kContact, "wall", "wall"), 0);
  EXPECT_EQ(LossByContact(Kind::kContact, "", "can"), 0);
  EXPECT_EQ(LossByContact(Kind::kContact, "wall", "can"), points);
  EXPECT_EQ(LossByContact(Kind::kGrasp, "charge", "charge"), 0);
  EXPECT_EQ(LossByContact(Kind::kGrasp, "charge", "cone"), points);
  EXPECT_EQ(LossByContact(Kind::kPlaceInVessel, "can", "can", true), 0);
  EXPECT_EQ(LossByContact(Kind::kPlaceInVessel, "can", "can", false), points);
  EXPECT_EQ(LossByContact(Kind::kClimb, "wall", "wall"), 0);
  EXPECT_EQ(LossByContact(Kind::kReach, "", "wall"), points);
}

TEST(Safety, ContactThatCompletesItsStepIsStillAskedFor) {
  Judged run(OneStep(TaskStep::Kind::kContact, "wall"));
  run.sample.contact_parts = 1;
  run.sample.contact_object = "wall";
  run.CompleteStep();
  EXPECT_EQ(run.safety(), kRubric.safety);
}

TEST(Safety, PushingOnCostsBySecondsBeyondTheGrace) {
  Judged run;
  run.sample.wanted_mask = SetOf(kDriveForward) | SetOf(kBigArmUp);
  run.sample.blocked_mask = SetOf(kDriveForward);
  run.Wait(ThePoints().push_grace);
  EXPECT_NEAR(run.safety(), kRubric.safety, 1e-9);
  run.Wait(2.5);
  EXPECT_NEAR(run.safety(), kRubric.safety - 2.5 * ThePoints().push_points, 1e-9);
  run.sample.wanted_mask = SetOf(kBigArmUp);  // another motion is free
  run.Wait(5);
  EXPECT_NEAR(run.safety(), kRubric.safety - 2.5 * ThePoints().push_points, 1e-9);
  const std::vector<ScoreEvent> events = EventsOf(run.dut, ScoreMark::kPushing);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].amount, 2.5, 1e-9);
  EXPECT_NEAR(events[0].points, -2.5 * ThePoints().push_points, 1e-9);
}

TEST(Safety, EachTimeBeyondTheTiltCosts) {
  Judged run;
  const double limit = TheRules().tilt.alarm / kDegree;
  const double again = limit - ThePoints().tilt_hysteresis / kDegree;
  for (const double pitch : {limit - 0.1, limit + 0.1, limit - 0.1, limit + 3, again - 0.1}) {
    run.sample.pitch_deg = pitch;
    run.Steps(3);
  }
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety - ThePoints().tilt_points);
  EXPECT_NEAR(EventsOf(run.dut, ScoreMark::kTilt).at(0).amount, limit + 3, 1e-9);
  run.sample.roll_deg = limit + 0.1;  // to the side counts as well
  run.sample.pitch_deg = 0;
  run.Step();
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety - 2 * ThePoints().tilt_points);
}

TEST(Safety, ExerciseMayAskForMoreTilt) {
  Scenario scenario = TwoSteps();
  scenario.rubric.tilt = 38 * kDegree;
  Judged run(scenario);
  run.sample.pitch_deg = 37;
  run.Step();
  EXPECT_EQ(run.safety(), kRubric.safety);
  run.sample.pitch_deg = 39;
  run.Step();
  EXPECT_EQ(run.safety(), kRubric.safety - ThePoints().tilt_points);
}

/// A charge in contact for half a second, and then left alone for longer than that is remembered.
void Touch(Judged& run, const char* held_then) {
  run.sample.charge_touched = true;
  run.Wait(0.5);
  run.sample.charge_touched = false;
  run.sample.held_object = held_then;
  run.Wait(ThePoints().touch_memory + 0.2);
}

TEST(Safety, TouchingAChargeWithoutGraspingItCostsEachTime) {
  Judged run;
  run.Wait(2);
  Touch(run, "");
  Touch(run, "");
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety - 2 * ThePoints().touch_points);
  EXPECT_NEAR(EventsOf(run.dut, ScoreMark::kTouch).at(0).time_s, 2 + Judged::kStep, 1e-9);
}

TEST(Safety, TouchesBeforeAndBehindAGraspBelongToIt) {
  Judged run;
  Touch(run, "charge");
  run.sample.held_object = "";
  Touch(run, "");  // it slides out of the hands that open
  EXPECT_EQ(run.safety(), kRubric.safety);
}

/// Points lost by driving 3 m with that picture, the mast camera turned by `pan` degrees.
double LossByDriving(double metres, int camera, double pan = 0) {
  Judged run;
  run.sample.camera_select = camera;
  run.sample.joint[kCameraPan] = pan;
  run.Drive(metres);
  return kRubric.safety - run.safety();
}

TEST(Safety, DrivingWithoutACameraOnTheWayCosts) {
  const double points = ThePoints().unseen_points;
  const double wide = ThePoints().view_pan / kDegree;
  ASSERT_LT(ThePoints().unseen_way, 3);
  EXPECT_EQ(LossByDriving(3, kDrive), 0);
  EXPECT_EQ(LossByDriving(3, kQuad), 0);
  EXPECT_EQ(LossByDriving(3, kGripper), points);
  EXPECT_EQ(LossByDriving(3, kRear), points);
  EXPECT_EQ(LossByDriving(3, kMast, wide - 1), 0);
  EXPECT_EQ(LossByDriving(3, kMast, -wide - 1), points);
  EXPECT_EQ(LossByDriving(-3, kRear), 0);
  EXPECT_EQ(LossByDriving(-3, kQuad), 0);
  EXPECT_EQ(LossByDriving(-3, kDrive), points);
  EXPECT_EQ(LossByDriving(-3, kMast, 0), points);
  EXPECT_EQ(LossByDriving(-3, kMast, 180 - wide + 1), 0);
}

TEST(Safety, ShortWayUnseenIsFreeAndALongOneCostsOnceUntilItWasSeen) {
  Judged run;
  run.sample.camera_select = kGripper;
  run.Drive(ThePoints().unseen_way - 0.1);
  EXPECT_EQ(run.safety(), kRubric.safety);
  run.Drive(5);
  run.Wait(5);
  run.Drive(5);
  EXPECT_EQ(run.safety(), kRubric.safety - ThePoints().unseen_points);
  run.sample.camera_select = kDrive;
  run.Drive(0.2);
  run.sample.camera_select = kGripper;
  run.Drive(5);
  EXPECT_EQ(run.safety(), kRubric.safety - 2 * ThePoints().unseen_points);
}

TEST(Safety, NeverFallsBelowZero) {
  Judged run;
  for (int i = 0; i < 40; ++i) {
    run.sample.contact_parts = i % 2;
    run.Step();
  }
  EXPECT_EQ(run.safety(), 0);
  EXPECT_EQ(EventsOf(run.dut, ScoreMark::kCollision).size(), 20u);
}

TEST(Safety, PointsCountEvenIfThereIsNoRoomToTellOfThem) {
  Scenario scenario = TwoSteps();
  scenario.rubric = {.steps = 0, .safety = 100, .precision = 0, .time = 0, .economy = 0, .pass = 0};
  Judged run(scenario);
  const int too_many = static_cast<int>(EventList::kRoom) + 10;
  for (int i = 0; i < 2 * too_many; ++i) {
    run.sample.contact_parts = i % 2 == 0;
    run.Step();
  }
  const ScoreSheet sheet = run.dut.Sheet();
  EXPECT_EQ(sheet.events.size(), EventList::kRoom);
  EXPECT_EQ(sheet.events_left_out, 10);
  EXPECT_EQ(sheet.parts[1].items[0].amount, too_many);
}

}  // namespace
}  // namespace eod::sim
