#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/light_source.h"
#include "sim/geometry/pose.h"
#include "sim/geometry/visual.h"
#include "sim/segments/block_tree.h"
#include "sim/segments/kernels.h"
#include "sim/segments/shape.h"
#include "sim/world/world.h"

namespace eod::sim {

/// A model of the SDFormat file.
struct WorldObject {
  std::string name;
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();  ///< in the module's local frame
  bool is_static = true;
  std::vector<Visual> visuals;
};

/// A part of a movable object: a convex solid, posed in the object's frame.
struct MovablePart {
  Shape shape;
  Eigen::Isometry3d X_OS = Eigen::Isometry3d::Identity();
};

/// A charge in the shape of an upright cylinder, centred on its object's frame (Eq. 8).
struct ExplosiveSpec {
  double radius = 0;       ///< a [m]
  double half_height = 0;  ///< h [m]
};

/// A thing that moves by itself: it is pushed, topples, rolls, falls, can be carried.
struct MovableObject {
  std::string name;
  uint32_t object_class = 0;  ///< module bit, kBumpProxy, and kBombObject or kMovableObject
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();  ///< at the start, in the module's frame
  double mass = 0;                                         ///< [kg]
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();          ///< centre of mass [m]
  double friction = 0;      ///< Coulomb, against ground and robot; among movables the product
  double rolling = 0.0005;  ///< [m] lever of the rolling resistance [E]: 0.8 % at a 60 mm radius
  std::vector<MovablePart> parts;
  std::vector<Visual> visuals;
  std::optional<ExplosiveSpec> explosive;
};

/// A containment vessel [防爆罐] of a static model: where a charge is safe. In the model's frame,
/// which stands upright: a drum with a net in it, or a chamber with a door and a tray.
struct VesselSpec {
  std::string name;  ///< of the model
  Eigen::Isometry3d X_MV = Eigen::Isometry3d::Identity();
  double inner_radius = 0;                              ///< [m] of a drum; 0: a chamber
  Eigen::Vector3d half_size = Eigen::Vector3d::Zero();  ///< [m] x and y of a chamber's inside
  double net_z = 0;  ///< [m] what a charge comes to rest on: net or tray
  double rim_z = 0;  ///< [m] upper end of the drum, roof of the chamber
};

/// A lamp that stands fast: a street lamp, one on a ceiling.
struct Lamp {
  std::string name;
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();
  LampLight light;
};

/// One training area with a local origin of its own, so that millimetres survive 1.5 km away from
/// the world's origin.
struct ModuleModel {
  int id = 0;  ///< 1 flat .. 5 indoor, as ROB_STATUS.ModuleId
  std::string name;
  uint32_t class_bit = 0;
  Eigen::Vector3d p_WM = Eigen::Vector3d::Zero();  ///< local origin in W [m]
  Eigen::Vector2d half_size =
      Eigen::Vector2d::Zero();  ///< [m] the area reaches this far from the origin
  Attitude start_attitude;      ///< at the local origin
  std::vector<WorldObject> objects;
  std::vector<CollisionTriangle> triangles;
  std::vector<MovableObject> movables;
  std::vector<VesselSpec> vessels;
  std::vector<Lamp> lamps;
};

/// Light and air for the cameras.
struct Atmosphere {
  Eigen::Vector3f sun_direction = Eigen::Vector3f(0.4F, -0.5F, 0.77F);  ///< towards the sun, unit
  Eigen::Vector3f sun_colour = Eigen::Vector3f(1.0F, 0.96F, 0.88F);
  Eigen::Vector3f sky_colour = Eigen::Vector3f(0.45F, 0.62F, 0.85F);
  Eigen::Vector3f fog_colour = Eigen::Vector3f(0.74F, 0.79F, 0.84F);
  float fog_density = 0.006F;  ///< [1/m]
};

/// The whole world as its SDFormat file describes it. Plain data.
struct WorldModel {
  std::filesystem::path file;
  std::vector<ModuleModel> modules;
  Atmosphere atmosphere;

  /// Throws std::runtime_error that names the file and the modules there are.
  const ModuleModel& Module(int id) const;
};

/// Reads and checks a world. Throws std::runtime_error with one line "FILE:LINE: …".
WorldModel LoadWorld(const std::filesystem::path& file);

/// Builds what segments can meet in `module`. The model may be dropped afterwards.
/// Throws std::invalid_argument for triangles or an instruction set that cannot be, see
/// BuildBlockTree and KernelsFor.
std::unique_ptr<World> BuildWorld(const ModuleModel& module,
                                  InstructionSet instruction_set = BestInstructionSet());

}  // namespace eod::sim
