#include <memory>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "sim/stance/stance.h"
#include "sim/world/world_model.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStep = 0.004;  // [s]
constexpr double kSpeed = 0.3;   // [m/s] low
constexpr double kWay = 4.0;     // [m] along Y, to the platform of the stairs
constexpr int kSlopeModule = 2;

/// What a robot's stance is asked for on its way north, step by step, with flippers as on stairs.
struct Drive {
  struct Step {
    RobotState before, state;
    std::vector<Eigen::Isometry3d> X_ML;
  };
  RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  WorldModel world_model = LoadWorld(EOD_DATA_DIR "/sim/worlds/training_ground.sdf");
  const ModuleModel& slope = world_model.Module(kSlopeModule);
  std::unique_ptr<World> world = BuildWorld(slope);
  Stance stance{robot, slope.class_bit};
  std::vector<Step> steps;

  Drive(double x, double y) {
    RobotState state = HomeState(robot);
    state.position = {x, y, 0};
    state.joint[0] = 50 * kDegree;
    state.joint[1] = 0;
    std::vector<Eigen::Isometry3d> X_ML;
    state = stance.PutDown(*world, state, X_ML);
    for (const double end = y + kWay; state.position.y() < end;) {
      const RobotState before = state;
      state.position.y() += kSpeed * kStep;
      LinkPoses(robot, state, X_ML);
      steps.push_back({before, state, X_ML});
      state = stance.Stand(*world, X_ML, before, state, kStep);
    }
  }
};

/// One Stand of a driving robot, on average over the way.
void Stand(benchmark::State& state, double x, double y) {
  Drive drive(x, y);
  size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Drive::Step& step = drive.steps[i];
    benchmark::DoNotOptimize(
        drive.stance.Stand(*drive.world, step.X_ML, step.before, step.state, kStep));
    i = (i + 1) % drive.steps.size();
  }
}
BENCHMARK_CAPTURE(Stand, Level, 0.0, 0.0);
BENCHMARK_CAPTURE(Stand, Stairs150, -4.0, 7.0);
BENCHMARK_CAPTURE(Stand, CrossingRamps, 44.0, 7.0);
BENCHMARK_CAPTURE(Stand, Stepfield, -44.0, 7.0);

}  // namespace
}  // namespace eod::sim

BENCHMARK_MAIN();
