// Writes one picture of a camera for a given robot state, to be looked at.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <png.h>

#include "sim/camera/jpeg_encoder.h"
#include "sim/isectors/isector_set.h"
#include "sim/plume/explosion.h"
#include "sim/rules/rules.h"
#include "tests/unit/camera/conditions.h"
#include "tests/unit/camera/fixture_scene.h"
#include "tests/unit/camera/offline_camera.h"

namespace eod::sim {
namespace {

struct Options {
  std::string robot = EOD_DATA_DIR "/sim/robots/eod_robot.sdf";
  std::string world = EOD_DATA_DIR "/sim/worlds/training_ground.sdf";
  bool fixture = false;
  int module = 1;
  std::string camera = "drive";
  std::string output = "still.png";  // or .jpg, as the simulator compresses it
  int width = 640;
  int height = 480;
  double x = 0, y = 0, heading_deg = 0;
  std::vector<double> view;  // x y z heading_deg pitch_deg: a free camera instead of the robot's
  std::vector<std::string> joints;  // J8=30
  std::vector<double> all_joints;   // J1 .. J9
  std::vector<double> charge;       // x y z radius height of a cylinder
  std::vector<double> blast;        // x y seconds
  bool is_destroyed = false;
  std::string rules = EOD_DATA_DIR "/sim/rules/eod_rules.toml";
  std::string weather = "day";
  std::string lights;
  std::vector<int> motions;  // 1 is M01: draw the isectors that these load
  bool is_bare = false;      // the scene alone
  bool no_osd = false;
  double zoom = 1;
  float link_quality = 1;
  double seconds = 51803.4;         // time of day
  std::vector<std::string> faults;  // mast=dead
  std::string gl = "osmesa";
};

constexpr double kDegree = std::numbers::pi / 180;

void SetJoint(int joint, double value, RobotState& state) {
  if (joint == kGripperOpening) state.left_opening = state.right_opening = value;
  state.joint.at(static_cast<size_t>(joint)) = joint == kGripperOpening ? value : value * kDegree;
}

void SetJoint(const std::string& text, RobotState& state) {
  const size_t equals = text.find('=');
  SetJoint(std::stoi(text.substr(1, equals - 1)) - 1, std::stod(text.substr(equals + 1)), state);
}

/// A charge that stands upright at the wanted place, as one more movable object.
void AddCharge(const std::vector<double>& charge, ModuleModel& module) {
  MovableObject object;
  object.name = "charge";
  object.X_MO = Eigen::Translation3d(charge.at(0), charge.at(1), charge.at(2));
  Visual visual;
  visual.shape = Visual::Shape::kCylinder;
  visual.size = {charge.at(3), charge.at(3), charge.at(4)};
  visual.material.diffuse = {0.55F, 0.06F, 0.04F};
  object.visuals = {visual};
  module.movables.push_back(object);
}

/// The explosion as it is some time after it went off.
void AddBlast(const Options& options, SceneSnapshot& snapshot) {
  Explosion explosion(LoadRules(options.rules).explosion);
  explosion.Ignite({options.blast.at(0), options.blast.at(1), 0}, 1, options.is_destroyed);
  for (double t = 0; t < options.blast.at(2); t += 0.004) explosion.Step(0.004);
  snapshot.quads.assign(explosion.quads().begin(), explosion.quads().end());
  snapshot.effects = explosion.effects();
}

/// A camera that hangs on the chassis so that it stands at the wanted place of the module.
void AddFreeCamera(const std::vector<double>& view, const RobotState& state, RobotModel& robot) {
  Eigen::Isometry3d X_MB = Eigen::Isometry3d::Identity();
  X_MB.linear() = ToRotation(state.attitude);
  X_MB.translation() = state.position;
  Eigen::Isometry3d X_MC = Eigen::Isometry3d::Identity();
  X_MC.linear() = ToRotation({view.at(3) * kDegree, view.at(4) * kDegree, 0});
  X_MC.translation() = Eigen::Vector3d(view.at(0), view.at(1), view.at(2));
  robot.cameras.push_back({.name = "free", .link = 0, .X_LC = X_MB.inverse() * X_MC});
}

/// What the motions load, cast from the state of the snapshot. A contact is a hit below D0, as of a
/// robot that stands still.
void AddIsectors(const std::vector<int>& motions, const RobotModel& robot,
                 const ModuleModel& module, SceneSnapshot& snapshot) {
  MotionSet commanded = 0;
  for (const int motion : motions) commanded |= SetOf(motion - 1);
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, snapshot.state, X_ML);
  IsectorSet isectors(robot, module.class_bit);
  isectors.Cast(*BuildWorld(module), X_ML, commanded);
  for (const CastSegment& cast : isectors.segments()) {
    const SegmentSpec& segment = robot.isectors[cast.isector].segments[cast.segment];
    snapshot.segments.push_back({.start = cast.query.start,
                                 .end = cast.query.start + cast.query.direction * segment.length,
                                 .hit = cast.hit.hit,
                                 .contact = cast.hit.hit && cast.hit.range < segment.d0,
                                 .point = cast.hit.point});
  }
}

void AddFaults(const std::vector<std::string>& faults, SceneSnapshot& snapshot) {
  for (const std::string& text : faults) {
    const size_t equals = text.find('=');
    const std::string kind = text.substr(equals + 1);
    CameraFault fault;
    fault.camera = text.substr(0, equals);
    if (kind == "frozen") fault.kind = CameraFault::Kind::kFrozen;
    if (kind == "noisy") fault.kind = CameraFault::Kind::kNoisy;
    if (kind == "light" || kind == "dark") fault.kind = CameraFault::Kind::kWrongLight;
    if (kind == "dark") fault.stops = -3;
    snapshot.faults.push_back(fault);
  }
}

void WritePng(const std::string& file, const OfflineCamera& camera,
              const std::vector<uint8_t>& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(camera.width());
  image.height = static_cast<png_uint_32>(camera.height());
  image.format = PNG_FORMAT_RGBA;
  // A negative stride: the bottom row comes first.
  if (png_image_write_to_file(&image, file.c_str(), 0, rgba.data(), -4 * camera.width(), nullptr) ==
      0) {
    throw std::runtime_error(fmt::format("{}: {}", file, image.message));
  }
}

void Run(const Options& options) {
  RobotModel robot = options.fixture ? FixtureRobot() : LoadRobot(options.robot);
  WorldModel world = options.fixture ? FixtureWorld() : LoadWorld(options.world);
  SceneSnapshot snapshot;
  snapshot.module = options.module;
  snapshot.weather = ParseWeather(options.weather);
  snapshot.lights = ParseLights(options.lights);
  snapshot.state = HomeState(robot);
  snapshot.state.position = {options.x, options.y, 0};
  snapshot.state.attitude.heading = options.heading_deg * kDegree;
  for (size_t joint = 0; joint < options.all_joints.size(); ++joint) {
    SetJoint(static_cast<int>(joint), options.all_joints[joint], snapshot.state);
  }
  for (const std::string& joint : options.joints) SetJoint(joint, snapshot.state);
  if (!options.charge.empty()) {
    const auto module = std::ranges::find(world.modules, options.module, &ModuleModel::id);
    if (module != world.modules.end()) AddCharge(options.charge, *module);
  }
  if (!options.blast.empty()) AddBlast(options, snapshot);
  if (!options.motions.empty()) {
    AddIsectors(options.motions, robot, world.Module(options.module), snapshot);
  }
  if (!options.view.empty()) AddFreeCamera(options.view, snapshot.state, robot);
  snapshot.zoom = options.zoom;
  snapshot.link_quality = options.link_quality;
  snapshot.time += std::chrono::milliseconds(std::lround(1000 * options.seconds));
  AddFaults(options.faults, snapshot);
  OfflineCamera camera(robot, world, options.width, options.height,
                       options.gl == "egl" ? GlBackend::kEgl : GlBackend::kOsMesa, !options.no_osd);
  JpegEncoder encoder(options.width, options.height,
                      PictureLink::JpegQuality(options.link_quality, 80));
  const std::string name = options.view.empty() ? options.camera : std::string("free");
  // What the link loses shows what came before.
  SceneSnapshot before = snapshot;
  before.time -= std::chrono::milliseconds(40);
  if (options.link_quality < 1) camera.TakeFinished(before, name);
  const auto& pixels =
      options.is_bare ? camera.Take(snapshot, name) : camera.TakeFinished(snapshot, name);
  const auto jpeg = encoder.Encode(pixels);
  if (options.output.ends_with(".png")) {
    WritePng(options.output, camera, pixels);
  } else {
    std::ofstream(options.output, std::ios::binary)
        .write(reinterpret_cast<const char*>(jpeg.data()),
               static_cast<std::streamsize>(jpeg.size()));
  }
  fmt::print("{}: {} bytes, quality {}, {} triangles, {} draw calls\n", options.output, jpeg.size(),
             encoder.last_quality(), camera.counters().triangles, camera.counters().draw_calls);
}

}  // namespace
}  // namespace eod::sim

int main(int argc, char** argv) {
  eod::sim::Options options;
  CLI::App app("Writes a picture of a camera for a given robot state");
  app.add_option("--robot", options.robot);
  app.add_option("--world", options.world);
  app.add_flag("--fixture", options.fixture, "robot and world of the tests instead of files");
  app.add_option("--module", options.module);
  app.add_option("--camera", options.camera);
  app.add_option("--output", options.output);
  app.add_option("--width", options.width);
  app.add_option("--height", options.height);
  app.add_option("--x", options.x, "[m]");
  app.add_option("--y", options.y, "[m]");
  app.add_option("--heading", options.heading_deg, "[deg] counter-clockwise from +Y");
  app.add_option("--joint", options.joints, "such as J8=30 [deg] or J7=0.05 [m]");
  app.add_option("--joints", options.all_joints, "J1 to J9 [deg], J7 [m]")
      ->expected(eod::sim::kJointCount);
  app.add_option("--charge", options.charge, "cylinder: x y z of its middle, radius, height [m]")
      ->expected(5);
  app.add_option("--blast", options.blast, "explosion: x y [m], seconds ago")->expected(3);
  app.add_flag("--destroyed", options.is_destroyed, "the explosion destroyed the robot");
  app.add_flag("--bare", options.is_bare, "the scene alone, without sensor, data and link");
  app.add_flag("--no-osd", options.no_osd, "no data in the picture");
  app.add_option("--zoom", options.zoom, "magnification of cameras that zoom");
  app.add_option("--link-quality", options.link_quality, "0..1");
  app.add_option("--seconds", options.seconds,
                 "time of day [s]: rain falls and noise changes with it");
  app.add_option("--fault", options.faults, "CAMERA=dead|frozen|noisy|light|dark");
  app.add_option("--gl", options.gl, "osmesa or egl");
  app.add_option("--motions", options.motions, "draw the isectors that these load: 1 is M01")
      ->check(CLI::Range(1, eod::sim::kMotionCount));
  app.add_option("--weather", options.weather, "day|dusk|night[,fog=METRES][,rain=MM_PER_H]");
  app.add_option("--lights", options.lights, "some of drive,gripper,infrared");
  app.add_option("--view", options.view, "free camera: x y z heading_deg pitch_deg")->expected(5);
  CLI11_PARSE(app, argc, argv);
  try {
    eod::sim::Run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
