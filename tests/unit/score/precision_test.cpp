#include <numbers>

#include <gtest/gtest.h>

#include "sim/score/precision_watch.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

using Kind = PrecisionSpec::Kind;
constexpr double kDegree = std::numbers::pi / 180;

PrecisionSpec Measure(Kind kind, double best, double worst) {
  PrecisionSpec spec;
  spec.kind = kind;
  spec.best = best;
  spec.worst = worst;
  return spec;
}

/// A mission of two steps that measures one thing.
struct Measured : Judged {
  explicit Measured(const PrecisionSpec& spec, TaskStep::Kind step = TaskStep::Kind::kReach)
      : Judged(Make({spec}, step)) {}
  static Scenario Make(std::vector<PrecisionSpec> specs, TaskStep::Kind step) {
    Scenario scenario = TwoSteps();
    scenario.steps[0].kind = step;
    scenario.steps[0].distance = 0.3;
    scenario.precision = std::move(specs);
    return scenario;
  }
  ScoreItem Item() const { return dut.Sheet().parts[2].items.at(0); }
  void Hold(const char* held, const Eigen::Vector3d& charge_M) {
    sample.held_object = held;
    sample.charge = "charge";
    sample.charge_position = Yard().p_WM + charge_M;
    Step();
  }
};

TEST(Precision, GoesAlongAStraightLineFromBestToWorst) {
  const auto points_for = [](double stop) {
    Measured run(Measure(Kind::kStopError, 0.01, 0.05), TaskStep::Kind::kStopAt);
    run.sample.ahead_m = stop;
    run.CompleteStep();
    return run.precision();
  };
  EXPECT_NEAR(points_for(0.30), kRubric.precision, 1e-9);
  EXPECT_NEAR(points_for(0.29), kRubric.precision, 1e-9);
  EXPECT_NEAR(points_for(0.27), kRubric.precision / 2, 1e-9);
  EXPECT_NEAR(points_for(0.33), kRubric.precision / 2, 1e-9);
  EXPECT_NEAR(points_for(0.36), 0, 1e-9);
}

TEST(Precision, MoreMayBeBetter) {
  PrecisionSpec spec = Measure(Kind::kRimClearance, 0.10, 0.0);
  spec.objects = {"can"};
  Measured run(spec);
  run.sample.charge_low_m = 0.85 + 0.04;
  run.Hold("charge", {0, 9, 1});
  EXPECT_FALSE(run.Item().is_taken);
  run.Hold("charge", {0, 9.9, 1});
  EXPECT_NEAR(run.Item().amount, 0.04, 1e-9);
  EXPECT_NEAR(run.precision(), 0.4 * kRubric.precision, 1e-9);
  run.sample.charge_low_m = 0.6;  // lowered into it: the moment is over
  run.Hold("charge", {0, 10, 0.8});
  EXPECT_NEAR(run.Item().amount, 0.04, 1e-9);
}

TEST(Precision, MeasuresShareThePartByTheirWeights) {
  PrecisionSpec stop = Measure(Kind::kStopError, 0, 0.1);
  stop.weight = 2;
  Judged run(
      Measured::Make({stop, Measure(Kind::kCentringError, 0, 0.1)}, TaskStep::Kind::kStopAt));
  run.sample.ahead_m = 0.3;
  run.CompleteStep();
  EXPECT_NEAR(run.precision(), kRubric.precision * 2 / 3, 1e-9);
  run.Succeed();  // what was never measured has no points
  EXPECT_NEAR(run.precision(), kRubric.precision * 2 / 3, 1e-9);
}

TEST(Precision, WithoutMeasuresItFollowsTheSteps) {
  Judged run;
  EXPECT_EQ(run.precision(), 0);
  run.CompleteStep();
  EXPECT_DOUBLE_EQ(run.precision(), kRubric.precision / 2);
}

TEST(Precision, StopErrorIsTheMeanOfAllStops) {
  Scenario scenario = Measured::Make({Measure(Kind::kStopError, 0, 0.1)}, TaskStep::Kind::kStopAt);
  scenario.steps[1] = scenario.steps[0];
  Judged run(scenario);
  for (const double stop : {0.32, 0.26}) {
    run.sample.ahead_m = stop;
    run.CompleteStep();
  }
  EXPECT_NEAR(run.dut.Sheet().parts[2].items[0].amount, 0.03, 1e-9);
}

TEST(Precision, PathErrorIsTheMeanOverTheWay) {
  PrecisionSpec spec = Measure(Kind::kPathError, 0, 1);
  spec.points = {{0.5, 0}, {0.5, 10}};
  Measured run(spec);
  run.Drive(4);
  run.sample.position.x() += 0.3;  // sideways, at once
  run.Step();
  run.Wait(60);  // standing does not count
  run.Drive(4);
  run.Succeed();
  // 4 m at 0.5, 0.3 m at 0.2 where it arrived, 4 m at 0.2.
  EXPECT_NEAR(run.Item().amount, (4 * 0.5 + 4.3 * 0.2) / 8.3, 1e-9);
}

TEST(Precision, BoxAndStepLimitWhatCounts) {
  PrecisionSpec spec = Measure(Kind::kHeadingError, 0, 10 * kDegree);
  spec.heading = 350 * kDegree;
  spec.box = Eigen::Vector4d(-1, 0.95, 1, 2.05);
  spec.step = 2;
  Measured run(spec);
  run.sample.heading_deg = 90;
  run.Drive(1.5);
  run.CompleteStep();
  run.sample.heading_deg = 2;  // 12 degrees off, to be taken the short way round
  run.Drive(1.5);
  EXPECT_FALSE(run.Item().is_taken);
  run.Succeed();
  EXPECT_TRUE(run.Item().is_taken);
  EXPECT_NEAR(run.Item().amount, 12, 1e-9);
}

TEST(Precision, TiltPeakIsTheLargest) {
  Measured run(Measure(Kind::kTiltPeak, 10 * kDegree, 20 * kDegree));
  for (const double pitch : {5.0, -15.0, 2.0}) {
    run.sample.pitch_deg = pitch;
    run.Step();
  }
  EXPECT_FALSE(run.Item().is_taken);
  run.Succeed();
  EXPECT_NEAR(run.Item().amount, 15, 1e-9);
  EXPECT_NEAR(run.precision(), kRubric.precision / 2, 1e-9);
}

TEST(Precision, CentringIsAlongTheFingersAtTheGrasp) {
  Measured run(Measure(Kind::kCentringError, 0, 0.04));
  run.sample.charge_in_hand = {0.02, -0.01, 0.05};
  run.Hold("charge", {0, 1, 0});
  run.sample.charge_in_hand.y() = 0.03;  // later it may slip
  run.Hold("charge", {0, 1, 0});
  EXPECT_NEAR(run.Item().amount, 0.01, 1e-12);
}

TEST(Precision, ReleaseOffsetIsWhereTheChargeWasLetGoOf) {
  PrecisionSpec spec = Measure(Kind::kReleaseOffset, 0, 0.1);
  spec.objects = {"can"};
  Measured run(spec);
  run.Hold("charge", {0.3, 10.4, 1});
  EXPECT_FALSE(run.Item().is_taken);
  run.Hold("", {0.03, 10.04, 0.9});
  EXPECT_NEAR(run.Item().amount, 0.05, 1e-9);
}

TEST(Precision, PlacementIsMeasuredAtTheEnd) {
  PrecisionSpec spec = Measure(Kind::kPlacementError, 0, 1);
  spec.points = {{3, 4}};
  Measured run(spec);
  run.Hold("", {3, 4.5, 0});
  run.Succeed();
  EXPECT_NEAR(run.Item().amount, 0.5, 1e-9);
}

TEST(Precision, ContactsWithWhatIsNamedAreCounted) {
  PrecisionSpec spec = Measure(Kind::kContacts, 0, 4);
  spec.objects = {"wall"};
  Measured run(spec);
  for (const char* object : {"wall", "can", "wall"}) {
    run.sample.contact_object = object;
    run.sample.contact_parts = 1;
    run.Steps(2);
    run.sample.contact_parts = 0;
    run.Step();
  }
  run.Succeed();
  EXPECT_EQ(run.Item().amount, 2);
  EXPECT_NEAR(run.precision(), kRubric.precision / 2, 1e-9);
}

TEST(Precision, WallClearanceIsTheSmallestDistance) {
  PrecisionSpec spec = Measure(Kind::kWallClearance, 0.6, 0.4);
  spec.points = {{-1, 2}, {1, 2}};
  Measured run(spec);
  run.Drive(1.5);
  run.Drive(-1);
  run.Succeed();
  EXPECT_NEAR(run.Item().amount, 0.5, 1e-9);
}

TEST(Precision, TurnsAreCountedWhenTheyBegin) {
  Measured run(Measure(Kind::kTurnCount, 1, 5));
  for (const double rate : {0.0, 10.0, 10.0, 0.0, -10.0, 0.0}) {
    run.sample.turn_rate_dps = rate;
    run.Step();
  }
  run.Succeed();
  EXPECT_EQ(run.Item().amount, 2);
}

TEST(Precision, MovedIsTheFarthestOfWhatIsNamed) {
  PrecisionSpec spec = Measure(Kind::kMoved, 0, 0.1);
  spec.objects = {"cone"};
  Measured run(spec);
  const std::array<double, 2> moved{0.7, 0.04};  // charge, cone
  run.sample.moved_m = moved;
  run.Succeed();
  EXPECT_DOUBLE_EQ(run.Item().amount, 0.04);
}

TEST(Precision, DistanceFromALineIsToItsNearestPoint) {
  const std::vector<Eigen::Vector2d> corner{{0, 0}, {2, 0}, {2, 2}};
  EXPECT_DOUBLE_EQ(DistanceFrom(corner, {1, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(DistanceFrom(corner, {-3, 4}), 5);
  EXPECT_DOUBLE_EQ(DistanceFrom(corner, {2.25, 1}), 0.25);
  EXPECT_DOUBLE_EQ(DistanceFrom({{1, 1}}, {1, 3}), 2);
}

std::string Refusal(const PrecisionSpec& spec) {
  Scenario scenario = TwoSteps();
  scenario.precision = {spec};
  try {
    Scorer dut(scenario, Yard(), TheRules());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Precision, WhatTheModuleLacksIsRefused) {
  PrecisionSpec spec = Measure(Kind::kReleaseOffset, 0, 1);
  spec.objects = {"pan"};
  EXPECT_EQ(Refusal(spec),
            "x.toml: precision 'release_offset': object 'pan' is not in module 3 (yard)");
  spec.objects = {"wall"};
  EXPECT_EQ(Refusal(spec), "x.toml: precision 'release_offset': object 'wall' is no drum");
  spec = Measure(Kind::kMoved, 0, 1);
  spec.objects = {"wall"};
  EXPECT_EQ(Refusal(spec), "x.toml: precision 'moved': object 'wall' is no movable");
  spec = Measure(Kind::kTiltPeak, 0, 1);
  spec.step = 3;
  EXPECT_EQ(Refusal(spec), "x.toml: precision 'tilt_peak': step = 3, but there are 2");
}

}  // namespace
}  // namespace eod::sim
