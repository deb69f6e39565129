#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace eod::sim {

/// How a surface looks. Textures are procedural, by name ("grass", "concrete", "brick", "asphalt",
/// "wood", "metal", "rubber", "hazard", "plaster", "carpet", "tile", "ceiling", "books", "rack",
/// "plain"); they are made by sim/camera.
struct Material {
  Eigen::Vector3f diffuse =
      Eigen::Vector3f::Constant(0.7F);  ///< linear 0..1, multiplies the texture
  std::string texture = "plain";
  float texture_scale_m = 1.0F;                        ///< size of one texture tile on the surface
  float specular = 0.05F;                              ///< 0..1
  Eigen::Vector3f emissive = Eigen::Vector3f::Zero();  ///< linear 0..1: light of its own
};

/// A shape to draw, posed in its owner's frame (link or world object).
struct Visual {
  enum class Shape : uint8_t { kBox, kCylinder, kSphere, kCone, kMesh };
  Shape shape = Shape::kBox;
  Eigen::Isometry3d X_OV = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< box: x y z; cylinder, cone: radius, -,
                                                   ///< length along Z; sphere: radius
  /// kMesh only: triangle corners in the visual's frame, three a triangle, counter-clockwise
  /// outside.
  std::vector<Eigen::Vector3f> triangles;
  Material material;
  bool casts_shadow = true;  ///< false: what stands under a roof, where the sun does not reach
};

}  // namespace eod::sim
