#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "sim/geometry/mesh.h"
#include "sim/simulator.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {

inline constexpr uint32_t kStoodOn = kModuleFlat | kClampProxy;
inline constexpr uint32_t kRunInto = kModuleFlat | kBumpProxy;
inline constexpr uint32_t kGround = kStoodOn | kBumpProxy;

/// A piece of ground made by hand; the robot starts at the origin, looking along +Y.
class Terrain {
 public:
  using Profile = std::vector<std::pair<double, double>>;  ///< y and z [m]

  Terrain() {
    module_.id = 1;
    module_.name = "yard";
    module_.class_bit = kModuleFlat;
    module_.half_size = {50, 50};
  }

  Terrain& Add(uint32_t mask, const Mesh& mesh,
               const Eigen::Isometry3d& X_MO = Eigen::Isometry3d::Identity()) {
    const int object = static_cast<int>(module_.objects.size());
    module_.objects.push_back({.name = "piece", .visuals = {}});
    for (const Triangle& triangle : Transformed(X_MO, mesh)) {
      module_.triangles.push_back({triangle, mask, object});
    }
    return *this;
  }

  /// A surface along a profile, from x = `left` to `right`.
  Terrain& AddStrip(uint32_t mask, const Profile& profile, double left = -3, double right = 3) {
    Mesh mesh;
    for (size_t i = 1; i < profile.size(); ++i) {
      const Eigen::Vector3d a(left, profile[i - 1].first, profile[i - 1].second);
      const Eigen::Vector3d b(right, a.y(), a.z());
      const Eigen::Vector3d c(right, profile[i].first, profile[i].second), d(left, c.y(), c.z());
      mesh.push_back({a, b, c});
      mesh.push_back({a, c, d});
    }
    return Add(mask, mesh);
  }

  /// Level ground, with `size` [m] in X and Y and its top at `z`.
  Terrain& AddBox(const Eigen::Vector3d& size, const Eigen::Vector3d& middle_of_base,
                  uint32_t mask = kGround) {
    return Add(mask, BoxMesh(size),
               Eigen::Isometry3d(Eigen::Translation3d(middle_of_base.x(), middle_of_base.y(),
                                                      middle_of_base.z() + size.z() / 2)));
  }

  /// A plane through the origin with this attitude's up axis.
  Terrain& AddSlope(double pitch_deg, double roll_deg) {
    Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();
    X_MO.linear() = ToRotation({0, pitch_deg * kDegree, roll_deg * kDegree});
    return Add(kGround, PlaneMesh(80, 80, 1), X_MO);
  }

  Terrain& StartAt(double pitch_deg, double roll_deg) {
    module_.start_attitude = {0, pitch_deg * kDegree, roll_deg * kDegree};
    return *this;
  }

  const ModuleModel& module() const { return module_; }

 private:
  ModuleModel module_;
};

/// `count` steps of `rise` x `run` [m] from y = `foot` on, with level ground before and a landing
/// behind: stood on is the line through the nosings with a lead-in, run into are treads and
/// risers.
inline Terrain Stairs(double rise, double run, int count, double foot, double lead_in = 0.1) {
  const double top = count * rise, last = foot + (count - 1) * run;
  Terrain::Profile steps = {{-5, 0}};
  for (int i = 0; i < count; ++i) {
    steps.emplace_back(foot + i * run, i * rise);
    steps.emplace_back(foot + i * run, (i + 1) * rise);
  }
  steps.emplace_back(last + 8, top);
  Terrain stairs;
  stairs.AddStrip(kRunInto, steps);
  stairs.AddStrip(kStoodOn,
                  {{-5, 0}, {foot - lead_in, 0}, {foot, rise}, {last, top}, {last + 8, top}});
  return stairs;
}

/// The shipped robot on a terrain, without accelerations, with somebody at the controls.
struct Driver {
  WorldModel world;
  Scenario free;
  Simulator dut;
  OperatorCommand command;
  TimePoint now{};
  std::function<void(const StepResult&)> watch = [](const StepResult&) {};

  explicit Driver(const Terrain& terrain, const SimulatorConfig& config = {})
      : world(WorldOf(terrain)), dut(TheSharpRobot(), world, free, WithRules(config)) {
    command.motion_permitted = true;
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  const StepResult& Step() {
    now += std::chrono::milliseconds(4);
    command.stamp = now;
    ++command.sequence;
    const StepResult& result = dut.Step(now, command);
    watch(result);
    return result;
  }

  static WorldModel WorldOf(const Terrain& terrain) {
    WorldModel world;
    world.modules.push_back(terrain.module());
    return world;
  }

  void Press(std::initializer_list<int> motions) {
    command.motion_rate = {};
    for (const int motion : motions) command.motion_rate[motion] = 1;
  }

  /// Holds `motions` for so long, or until `until`; then lets go. Whether `until` came about.
  bool Hold(std::initializer_list<int> motions, double seconds,
            const std::function<bool(const StepResult&)>& until = {}) {
    Press(motions);
    bool came = false;
    for (int i = 0; i < std::lround(seconds / 0.004) && !came; ++i) {
      came = until && until(Step());
      if (!until) Step();
    }
    Press({});
    return came;
  }
  /// Until the robot's origin has passed y.
  bool DriveTo(double y, int motion = kDriveForward, double at_most_s = 200) {
    const double sign = motion == kDriveForward ? 1 : -1;
    return Hold({motion}, at_most_s, [=](const StepResult& result) {
      return sign * (result.state.position.y() - y) > 0;
    });
  }
  /// Turns a flipper pair to an angle.
  void Flipper(int joint, double degrees) {
    const double now_deg = state().joint[joint] / kDegree;
    const JointSpec& spec = TheRobot().joints[joint];
    const int motion = degrees > now_deg ? spec.positive_motion : spec.negative_motion;
    Hold({motion}, std::abs(degrees - now_deg) / 20);
  }
  /// Both pairs out, level: as long as the robot gets.
  void LevelFlippers() {
    Flipper(kFrontFlipper, 0);
    Flipper(kRearFlipper, 0);
  }
  /// Both pairs down to the ground, short of the first touch.
  void LowerFlippers() {
    Flipper(kFrontFlipper, -14);
    Flipper(kRearFlipper, -14);
  }
  void Rest(double at_most_s = 10) {
    Hold({}, at_most_s, [](const StepResult& result) { return result.state.at_rest; });
  }

  const RobotState& state() const { return dut.last().state; }
  double pitch_deg() const { return state().attitude.pitch / kDegree; }
  double roll_deg() const { return state().attitude.roll / kDegree; }
};

}  // namespace eod::sim
