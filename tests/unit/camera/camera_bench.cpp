// Processor milliseconds a picture, stage by stage, along a drive through the training ground.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/resource.h>

#include "sim/camera/jpeg_encoder.h"
#include "tests/unit/camera/conditions.h"
#include "tests/unit/camera/offline_camera.h"

namespace eod::sim {
namespace {

/// Processor time of the whole process, so that a busy machine does not count.
struct Clock {
  using duration = std::chrono::nanoseconds;
  using time_point = duration;
  static time_point now() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
  }
};

struct Options {
  std::string robot = EOD_DATA_DIR "/sim/robots/eod_robot.sdf";
  std::string world = EOD_DATA_DIR "/sim/worlds/training_ground.sdf";
  int width = 640;
  int height = 480;
  int pictures = 200;
};

/// Durations of one stage [ms].
class Stage {
 public:
  void Add(Clock::duration duration) {
    ms_.push_back(std::chrono::duration<double, std::milli>(duration).count());
  }
  std::string Summary() {
    std::sort(ms_.begin(), ms_.end());
    return fmt::format("{:6.2f} {:6.2f} {:6.2f}", ms_[ms_.size() / 10], ms_[ms_.size() / 2],
                       ms_[ms_.size() * 99 / 100]);
  }

 private:
  std::vector<double> ms_;
};

/// What one camera cost.
struct Measured {
  Stage render;
  Stage compress;
  size_t bytes = 0;
  DrawCounters most;
};

/// The worst plume: as many quads as there can be, so large that they reach the caps of the
/// renderer, in view of both cameras.
void AddPlume(SceneSnapshot& snapshot) {
  const Eigen::Matrix3d R_MB = ToRotation(snapshot.state.attitude);
  for (int i = 0; i < 32; ++i) {
    const Eigen::Vector3d p_BQ(0.02 * i - 0.32, 3 + 0.02 * i, 0.5);
    snapshot.quads.push_back({.p_M = (snapshot.state.position + R_MB * p_BQ).cast<float>(),
                              .half_size = 3,
                              .colour = {0.2F, 0.2F, 0.2F},
                              .alpha = 0.5F,
                              .angle = 0.2F * static_cast<float>(i),
                              .cover = 1});
  }
  // Its shadows are to be drawn anew, as they were for the picture without.
  snapshot.state.position.z() += 1e-6;
}

/// A circle of 6 m radius around the start pad, the head looking about.
SceneSnapshot OnTheWay(const RobotModel& robot, int picture, int pictures) {
  const double turn = 2 * std::numbers::pi * picture / pictures;
  SceneSnapshot snapshot;
  snapshot.state = HomeState(robot);
  snapshot.state.position = {6 * std::cos(turn), 6 * std::sin(turn), 0};
  snapshot.state.attitude.heading = turn;
  snapshot.state.joint[kCameraPan] = std::sin(3 * turn);
  return snapshot;
}

void Run(const Options& options) {
  const RobotModel robot = LoadRobot(options.robot);
  const WorldModel world = LoadWorld(options.world);
  const Clock::time_point begin = Clock::now();
  OfflineCamera camera(robot, world, options.width, options.height);
  camera.Take(OnTheWay(robot, 0, options.pictures), "drive");
  fmt::print("start, first picture included: {:.0f} ms\n",
             std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  JpegEncoder encoder(options.width, options.height, 80);
  std::map<std::string, Measured> measured;
  const auto measure = [&](const SceneSnapshot& snapshot, const char* name, const char* what) {
    Measured& one = measured[fmt::format("{} {}", name, what)];
    const Clock::time_point start = Clock::now();
    const auto& pixels = camera.Take(snapshot, name);
    const Clock::time_point rendered = Clock::now();
    one.bytes += encoder.Encode(pixels).size();
    one.render.Add(rendered - start);
    one.compress.Add(Clock::now() - rendered);
    one.most.triangles = std::max(one.most.triangles, camera.counters().triangles);
    one.most.draw_calls = std::max(one.most.draw_calls, camera.counters().draw_calls);
  };
  for (int picture = 0; picture < options.pictures; ++picture) {
    SceneSnapshot snapshot = OnTheWay(robot, picture, options.pictures);
    // As the simulator does: both cameras show one moment, the first one renders its shadow.
    for (const char* name : {"drive", "mast"}) measure(snapshot, name, "");
    for (const auto& [weather, lights] :
         {std::pair{"dusk", ""}, std::pair{"day,rain=20", ""}, std::pair{"night", "drive"}}) {
      snapshot.weather = ParseWeather(weather);
      snapshot.lights = ParseLights(lights);
      // What only a change of the light loads is not a picture's cost.
      camera.Take(snapshot, "rear");
      measure(snapshot, "drive", weather);
    }
    snapshot.weather = {};
    snapshot.lights = {};
    camera.Take(snapshot, "rear");
    AddPlume(snapshot);
    for (const char* name : {"drive", "mast"}) measure(snapshot, name, "with plume");
    snapshot.effects = {.noise = 1, .seed = static_cast<uint32_t>(picture)};
    measure(snapshot, "drive", "dead");
  }
  for (auto& [name, one] : measured) {
    fmt::print("{}: render and readback [ms: best tenth, median, p99] {}\n", name,
               one.render.Summary());
    fmt::print("{}: JPEG                [ms: best tenth, median, p99] {}, {} bytes\n", name,
               one.compress.Summary(), one.bytes / static_cast<size_t>(options.pictures));
    fmt::print("{}: at most {} triangles, {} draw calls\n", name, one.most.triangles,
               one.most.draw_calls);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("largest resident size: {} MB\n", usage.ru_maxrss / 1024);
}

}  // namespace
}  // namespace eod::sim

int main(int argc, char** argv) {
  eod::sim::Options options;
  CLI::App app(
      "Processor milliseconds a camera picture takes; set LP_NUM_THREADS as the simulator does "
      "(2)");
  app.add_option("--robot", options.robot);
  app.add_option("--world", options.world);
  app.add_option("--width", options.width);
  app.add_option("--height", options.height);
  app.add_option("--pictures", options.pictures);
  CLI11_PARSE(app, argc, argv);
  try {
    eod::sim::Run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
