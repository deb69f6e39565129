#pragma once

#include <string>
#include <vector>

#include "sim/bodies/rigid_bodies.h"
#include "sim/geometry/object_class.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {

inline constexpr double kDt = 0.004;  // [s]

/// A trainer's cylinder: base radius, height, mass.
struct CylinderSize {
  const char* name;
  double radius, height, mass;
};
inline constexpr CylinderSize kSmallCharge{"S", 0.030, 0.160, 1.0};
inline constexpr CylinderSize kMiddleCharge{"M", 0.060, 0.240, 3.0};
inline constexpr CylinderSize kLargeCharge{"L", 0.075, 0.300, 6.0};
inline constexpr double kFriction = 0.6;

inline Eigen::Isometry3d At(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

inline ModuleModel GroundOf(double size, double cell = 2) {
  ModuleModel module;
  AddObject(module, "ground", kModuleBomb | kClampProxy | kBumpProxy, PlaneMesh(size, size, cell));
  return module;
}

/// Returns the number of the movable.
inline int AddMovable(ModuleModel& module, const Shape& shape, double mass,
                      const Eigen::Isometry3d& X_MO, double friction = kFriction) {
  MovableObject object;
  object.name = std::string("thing");
  object.object_class = kModuleBomb | kBumpProxy | kMovableObject;
  object.X_MO = X_MO;
  object.mass = mass;
  object.friction = friction;
  object.parts.push_back({.shape = shape});
  module.movables.push_back(object);
  return static_cast<int>(module.movables.size()) - 1;
}

inline int AddCharge(ModuleModel& module, const CylinderSize& size, const Eigen::Isometry3d& X_MO,
                     double friction = kFriction) {
  const int body =
      AddMovable(module, Shape::Cylinder(size.radius, size.height), size.mass, X_MO, friction);
  MovableObject& object = module.movables.back();
  object.name = std::string(size.name);
  object.object_class = kModuleBomb | kBumpProxy | kBombObject;
  object.explosive = ExplosiveSpec{size.radius, size.height / 2};
  return body;
}

/// Standing on z = 0.
inline int AddStandingCharge(ModuleModel& module, const CylinderSize& size, double x, double y) {
  return AddCharge(module, size, At(x, y, size.height / 2));
}

/// A robot of one link, a box, that a test moves as it likes.
inline RobotModel BoxRobot(const Eigen::Vector3d& size) {
  RobotModel robot;
  LinkSpec chassis;
  chassis.name = "chassis";
  chassis.solids.push_back({.shape = Shape::Box(size)});
  robot.links.push_back(chassis);
  return robot;
}

/// Where a robot is in nobody's way.
inline std::vector<Eigen::Isometry3d> FarAway(const RobotModel& robot) {
  return std::vector<Eigen::Isometry3d>(robot.links.size(), At(0, -40, 0));
}

/// Angle between the axis of a body and the vertical [rad].
inline double TiltOf(const BodyState& state) {
  return std::acos(std::clamp(state.X_MO.linear()(2, 2), -1.0, 1.0));
}

}  // namespace eod::sim
