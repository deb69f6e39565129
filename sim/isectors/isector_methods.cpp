#include "sim/isectors/isector_methods.h"

#include <utility>

namespace eod::sim {

namespace {

using Eigen::Vector3d;

IsectorSegment DownThrough(const Vector3d& foot, const VerticalExtent& extent) {
  return {.start = foot + extent.z_max * Vector3d::UnitZ(),
          .direction = -Vector3d::UnitZ(),
          .length = extent.z_max - extent.z_min};
}

Isector MakeVertical(std::string name, IsectorMethod method, const VerticalExtent& extent) {
  return {std::move(name), method, {DownThrough(Vector3d::Zero(), extent)}};
}

}  // namespace

Isector MakeVolume(std::string name, std::vector<IsectorSegment> segments) {
  return {std::move(name), IsectorMethod::kVolume, std::move(segments)};
}

Isector MakeHat(std::string name, const VerticalExtent& extent) {
  return MakeVertical(std::move(name), IsectorMethod::kHat, extent);
}

Isector MakeZ(std::string name, const VerticalExtent& extent) {
  return MakeVertical(std::move(name), IsectorMethod::kZ, extent);
}

Isector MakeZpr(std::string name, const VerticalExtent& extent) {
  return MakeVertical(std::move(name), IsectorMethod::kZpr, extent);
}

Isector MakeXyzpr(std::string name, const VerticalExtent& extent) {
  return MakeVertical(std::move(name), IsectorMethod::kXyzpr, extent);
}

Isector MakeLos(std::string name, double range) {
  return {std::move(name), IsectorMethod::kLos, {{.length = range}}};
}

Isector MakeTripod(std::string name, const std::array<Vector3d, 3>& feet,
                   const VerticalExtent& extent) {
  return {
      std::move(name),
      IsectorMethod::kTripod,
      {DownThrough(feet[0], extent), DownThrough(feet[1], extent), DownThrough(feet[2], extent)}};
}

Isector MakeBump(std::string name, const std::array<double, 6>& half_length) {
  std::vector<IsectorSegment> segments;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      segments.push_back(
          {.direction = side * Vector3d::Unit(axis), .length = half_length[segments.size()]});
    }
  }
  return {std::move(name), IsectorMethod::kBump, std::move(segments)};
}

}  // namespace eod::sim
