#include "sim/radio/sight_line.h"

#include "sim/geometry/object_class.h"

namespace eod::sim {
namespace {

constexpr double kSameSurface = 1e-6;    // [m] a line through the edge of two triangles meets both
constexpr size_t kUsualSurfaces = 1024;  // of what a line of 500 m meets
constexpr double kGroundSearch = 5;      // [m]

}  // namespace

void SightLine::Reserve() {
  memory_.all.reserve(kUsualSurfaces);
  memory_.surroundings.Reserve();
}

int SightLine::Walls(const World& world, const Eigen::Vector3d& from_M,
                     const Eigen::Vector3d& to_M) {
  const Eigen::Vector3d way = to_M - from_M;
  const double length = way.norm();
  if (length == 0) return 0;
  const SegmentQuery query{.start = from_M,
                           .direction = way / length,
                           .length = length,
                           .class_mask = class_bit_ | kBumpProxy,
                           .hit_rule = HitRule::kAll};
  SegmentHit nearest;
  world.Cast({&query, 1}, {&nearest, 1}, memory_);
  int surfaces = 0;
  double last = -1;
  for (const ListedHit& listed : memory_.all) {
    const bool moves = (listed.hit.object_class & (kMovableObject | kBombObject)) != 0;
    if (moves || listed.hit.range - last < kSameSurface) continue;
    last = listed.hit.range;
    ++surfaces;
  }
  return (surfaces + 1) / 2;
}

double SightLine::GroundAt(const World& world, const Eigen::Vector3d& p_M) {
  const SegmentQuery query{.start = p_M + Eigen::Vector3d(0, 0, kGroundSearch / 2),
                           .direction = -Eigen::Vector3d::UnitZ(),
                           .length = 1.5 * kGroundSearch,
                           .class_mask = class_bit_ | kClampProxy};
  SegmentHit ground;
  world.Cast({&query, 1}, {&ground, 1}, memory_);
  return ground.hit ? ground.point.z() : p_M.z();
}

}  // namespace eod::sim
