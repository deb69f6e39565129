#pragma once

#include <cstdint>

#include <Eigen/Geometry>

namespace eod::sim {

/// A simple solid as files name it, centred on its own frame, posed in its owner's.
struct Primitive {
  enum class Kind : uint8_t { kBox, kCylinder, kSphere, kCapsule };
  Kind kind = Kind::kBox;
  /// [m] box: x y z; cylinder and capsule: radius, -, length along Z (of a capsule without its half
  /// balls); sphere: radius.
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  Eigen::Isometry3d X_OP = Eigen::Isometry3d::Identity();
};

}  // namespace eod::sim
