#include "sim/camera/view.h"

#include <cmath>

namespace eod::sim {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

Matrix4d ClipFromCamera(const Lens& lens) {
  const double zoom = 1.0 / std::tan(lens.horizontal_fov / 2);
  const double depth = lens.far - lens.near;
  Matrix4d clip = Matrix4d::Zero();
  // OpenGL looks along -Z with Y up; C looks along +Y with Z up.
  clip(0, 0) = zoom;
  clip(1, 2) = zoom * lens.aspect;
  clip(2, 1) = (lens.far + lens.near) / depth;
  clip(2, 3) = -2 * lens.far * lens.near / depth;
  clip(3, 1) = 1;
  return clip;
}

View MakeCameraView(const Eigen::Isometry3d& X_MC, const Lens& lens) {
  return {ClipFromCamera(lens) * X_MC.inverse().matrix(), X_MC.translation()};
}

View MakeSunView(const Vector3d& to_sun, const Vector3d& p_MT, double half_side, int texels) {
  constexpr double kDepth = 60;  // [m] half of it towards the sun
  const Vector3d back = to_sun.normalized();
  const Vector3d side =
      (std::abs(back.z()) < 0.99 ? Vector3d::UnitZ() : Vector3d::UnitY()).cross(back).normalized();
  Matrix3d R_SM;
  R_SM.row(0) = side;
  R_SM.row(1) = back.cross(side);
  R_SM.row(2) = back;
  const double texel = 2 * half_side / texels;
  Vector3d p_ST = R_SM * p_MT;
  for (int axis = 0; axis < 3; ++axis) {
    p_ST[axis] = std::round(p_ST[axis] / texel) * texel;
  }
  const Vector3d scale(1 / half_side, 1 / half_side, -1 / kDepth);
  Matrix4d clip = Matrix4d::Identity();
  clip.topLeftCorner<3, 3>() = scale.asDiagonal() * R_SM;
  clip.topRightCorner<3, 1>() = -scale.cwiseProduct(p_ST);
  return {clip, p_MT + back * kDepth};
}

Frustum::Frustum(const View& view) {
  for (size_t axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector4d w = view.clip.row(3);
    const Eigen::RowVector4d along = view.clip.row(static_cast<Eigen::Index>(axis));
    planes_[2 * axis] = (w + along).transpose().cast<float>();
    planes_[2 * axis + 1] = (w - along).transpose().cast<float>();
  }
}

bool Frustum::MaySee(const Eigen::AlignedBox3f& box) const {
  for (const Eigen::Vector4f& plane : planes_) {
    const Eigen::Vector3f normal = plane.head<3>();
    // The corner that reaches farthest inwards decides.
    const Eigen::Vector3f corner =
        (normal.array() >= 0).select(box.max().array(), box.min().array());
    if (normal.dot(corner) + plane.w() < 0) return false;
  }
  return true;
}

}  // namespace eod::sim
