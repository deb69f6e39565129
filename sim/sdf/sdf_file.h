#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/light_source.h"
#include "sim/geometry/mesh.h"
#include "sim/geometry/primitive.h"
#include "sim/geometry/visual.h"
#include "sim/sdf/custom_element.h"

namespace eod::sim {

/// What stands in an SDFormat file, as plain data: poses resolved, shapes cut into triangles. The
/// only folder that includes libsdformat hides behind these structs.

struct SdfVisual {
  std::string name;
  Visual visual;  ///< posed in the link's frame
};

struct SdfCollision {
  std::string name;
  int line = 0;
  Mesh triangles;  ///< in the link's frame
  /// What the triangles were cut from, in the link's frame; none of plane, mesh and cone.
  std::optional<Primitive> solid;
  bool clamp = true;  ///< TRIPOD and HAT stand on it
  bool bump = true;   ///< BUMP and LOS run into it
};

/// A camera sensor; it looks along +X of its own frame, Z up.
struct SdfCamera {
  std::string name;
  int line = 0;
  Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
  double horizontal_fov = 0;  ///< [rad]
  double near = 0;            ///< [m] what is nearer is not seen
  int width = 0;
  int height = 0;
  std::vector<CustomElement> customs;
};

/// A point or spot light of a link or of the world.
struct SdfLight {
  std::string name;
  int line = 0;
  bool is_spot = false;
  std::string relative_to;  ///< of a light of the world: frame that X_FS is given in
  Eigen::Isometry3d X_FS = Eigen::Isometry3d::Identity();  ///< a link's light: in the link's frame
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();   ///< of a spot, in S, unit
  LampLight light;
  double inner_angle = 0;  ///< [rad] full angle of a spot's bright cone, and ...
  double outer_angle = 0;  ///< [rad] ... of the cone beyond which it is dark
  std::vector<CustomElement> customs;
};

struct SdfLink {
  std::string name;
  int line = 0;
  Eigen::Isometry3d X_ML = Eigen::Isometry3d::Identity();  ///< in the model's frame
  double mass = 0;                                         ///< [kg] 0 without <inertial>
  Eigen::Vector3d p_LC = Eigen::Vector3d::Zero();          ///< centre of mass [m]
  std::vector<SdfVisual> visuals;
  std::vector<SdfCollision> collisions;
  std::vector<SdfCamera> cameras;
  std::vector<SdfLight> lights;
  std::vector<CustomElement> customs;
};

struct SdfJoint {
  std::string name;
  int line = 0;
  std::string type;  ///< "revolute", "prismatic", "fixed", ...
  std::string parent;
  std::string child;
  Eigen::Isometry3d X_LJ = Eigen::Isometry3d::Identity();  ///< in the child link's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();         ///< in the child link's frame
  double lower = 0;
  double upper = 0;
  double velocity = 0;
  std::vector<CustomElement> customs;
};

struct SdfModel {
  std::string name;
  int line = 0;
  bool is_static = false;
  std::string relative_to;  ///< frame that X_FM is given in, "" for the world
  Eigen::Isometry3d X_FM = Eigen::Isometry3d::Identity();
  std::vector<SdfLink> links;
  std::vector<SdfJoint> joints;
  std::vector<CustomElement> customs;
};

struct SdfFrame {
  std::string name;
  Eigen::Isometry3d X_WF = Eigen::Isometry3d::Identity();
};

struct SdfSun {
  Eigen::Vector3f direction = -Eigen::Vector3f::UnitZ();  ///< that the light travels, unit
  Eigen::Vector3f colour = Eigen::Vector3f::Ones();
};

struct SdfFog {
  Eigen::Vector3f colour = Eigen::Vector3f::Ones();
  float density = 0;  ///< [1/m]
};

struct SdfWorld {
  std::string name;
  int line = 0;
  std::vector<SdfFrame> frames;
  std::vector<SdfModel> models;
  std::optional<SdfSun> sun;     ///< first directional light
  std::vector<SdfLight> lights;  ///< all but directional ones
  std::optional<Eigen::Vector3f> background;
  std::optional<SdfFog> fog;
  std::vector<CustomElement> customs;
};

/// Reads the one model of a file. libsdformat's warnings count as errors.
/// Throws std::runtime_error with the first error as "FILE:LINE: TEXT".
SdfModel ReadSdfModel(const std::filesystem::path& file);

/// Reads the one world of a file, some models at a time (WorldPieces), so that a large world needs
/// little more memory than its result; so a frame or a pose must not refer to another model. Throws
/// like ReadSdfModel.
SdfWorld ReadSdfWorld(const std::filesystem::path& file);

}  // namespace eod::sim
