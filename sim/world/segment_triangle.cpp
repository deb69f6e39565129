#include "sim/world/segment_triangle.h"

#include <algorithm>
#include <utility>

namespace eod::sim {

PreparedSegment::PreparedSegment(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                                 double length, FaceRule face_rule)
    : start_(start), length_(length), front_only_(face_rule == FaceRule::kFrontOnly) {
  direction.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  // Keeps the winding of triangles when the segment runs towards the negative axis.
  if (direction[z_] < 0) std::swap(x_, y_);
  shear_x_ = direction[x_] / direction[z_];
  shear_y_ = direction[y_] / direction[z_];
  scale_z_ = 1 / direction[z_];
}

std::optional<double> PreparedSegment::Meet(const Triangle& triangle) const {
  const Eigen::Vector3d a = triangle[0] - start_;
  const Eigen::Vector3d b = triangle[1] - start_;
  const Eigen::Vector3d c = triangle[2] - start_;
  const double ax = a[x_] - shear_x_ * a[z_], ay = a[y_] - shear_y_ * a[z_];
  const double bx = b[x_] - shear_x_ * b[z_], by = b[y_] - shear_y_ * b[z_];
  const double cx = c[x_] - shear_x_ * c[z_], cy = c[y_] - shear_y_ * c[z_];
  // Signed areas against the three edges; the two triangles of an edge see exactly opposite values.
  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  const bool any_negative = u < 0 || v < 0 || w < 0;
  const bool any_positive = u > 0 || v > 0 || w > 0;
  if (any_negative && (any_positive || front_only_)) return std::nullopt;
  const double area = u + v + w;
  if (area == 0) return std::nullopt;
  const double range = (u * a[z_] + v * b[z_] + w * c[z_]) * scale_z_ / area;
  if (!(range >= -kEndTolerance && range <= length_ + kEndTolerance)) return std::nullopt;
  return std::clamp(range, 0.0, length_);
}

}  // namespace eod::sim
