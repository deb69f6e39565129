#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

namespace eod::sim {

/// What a camera or the sun sees: from the module's local frame M to clip space.
struct View {
  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();  ///< multiplies points of M
  Eigen::Vector3d p_ME = Eigen::Vector3d::Zero();      ///< the eye
};

/// Perspective of a camera that looks along +Y of C with Z up.
struct Lens {
  double horizontal_fov = 1.3;  ///< [rad]
  double aspect = 4.0 / 3.0;    ///< width / height
  double near = 0.06;           ///< [m]
  double far = 3000;            ///< [m]
};

/// Clip space of the camera: multiplies points of C.
Eigen::Matrix4d ClipFromCamera(const Lens& lens);

View MakeCameraView(const Eigen::Isometry3d& X_MC, const Lens& lens);

/// Parallel light onto a square of `half_side` [m] around its target `p_MT`, which is moved to
/// whole texels of a map of `texels` a side, so that shadow edges stay still while the robot
/// drives.
View MakeSunView(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& p_MT, double half_side,
                 int texels);

/// The six planes of a view, to leave out what cannot be seen.
class Frustum {
 public:
  explicit Frustum(const View& view);
  /// False only if the box is entirely outside.
  bool MaySee(const Eigen::AlignedBox3f& box) const;

 private:
  std::array<Eigen::Vector4f, 6> planes_;  // inside: plane . (p, 1) >= 0
};

}  // namespace eod::sim
