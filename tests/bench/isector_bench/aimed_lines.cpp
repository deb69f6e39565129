#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "tests/bench/isector_bench/indexed_mesh.h"
#include "tests/bench/isector_bench/site.h"
#include "tests/bench/isector_bench/workload.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::bench {

namespace {

using Eigen::Vector3d;
using sim::SegmentQuery;
using Corners = std::array<uint32_t, 3>;

constexpr double kReach = 1.2;                // [m] of a frame, round its place
constexpr double kLeastSlant = 0.2588190451;  // sin 15 degrees

/// The triangles near one place, and which of them share what.
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, const Vector3d& middle) : middle_(middle) {
    std::vector<sim::CollisionTriangle> near;
    // Twice the reach: what is aimed at has all its triangles in here, unless they are larger.
    const Eigen::AlignedBox3d box(middle.array() - 2 * kReach, middle.array() + 2 * kReach);
    for (const sim::CollisionTriangle& triangle : scene.module.triangles) {
      Eigen::AlignedBox3d bounds(triangle.corner[0]);
      bounds.extend(triangle.corner[1]).extend(triangle.corner[2]);
      if (bounds.intersects(box)) near.push_back(triangle);
    }
    mesh_ = MakeIndexed(near);
    for (const Corners& corners : mesh_.triangles) {
      for (const uint32_t corner : corners) users_[corner].push_back(corners);
    }
  }

  /// A line at an edge or a corner drawn by lot; nothing if the lot fell badly.
  std::optional<SegmentQuery> Aim(sim::SeededNumbers& numbers) const {
    const Corners& drawn = mesh_.triangles[numbers.Below(mesh_.triangles.size())];
    const size_t first = numbers.Below(3);
    const uint32_t a = drawn[first], b = drawn[(first + 1) % 3];
    const bool at_corner = numbers.Below(3) == 0;
    const double share = at_corner ? 0 : numbers.Between(0, 1);
    const Vector3d target = mesh_.corners[a] + share * (mesh_.corners[b] - mesh_.corners[a]);
    if ((target - middle_).norm() > kReach) return std::nullopt;
    const std::vector<Corners> round = at_corner ? Fan(a) : Sharing(a, b);
    if (round.empty()) return std::nullopt;
    Vector3d mean = Vector3d::Zero();
    for (const Corners& corners : round) mean += Normal(corners);
    const Vector3d direction = -(mean.normalized() + numbers.InBox(0.9)).normalized();
    for (const Corners& corners : round) {
      if (Normal(corners).dot(direction) > -kLeastSlant) return std::nullopt;
    }
    return SegmentQuery{.start = target - numbers.Between(0.05, 0.25) * direction,
                        .direction = direction,
                        .length = kBumpLength,
                        .class_mask = sim::kModuleOutdoor | sim::kBumpProxy};
  }

 private:
  Vector3d Normal(const Corners& corners) const {
    const Vector3d& a = mesh_.corners[corners[0]];
    return (mesh_.corners[corners[1]] - a).cross(mesh_.corners[corners[2]] - a).normalized();
  }

  /// The two triangles of an edge; none if it is a border.
  std::vector<Corners> Sharing(uint32_t a, uint32_t b) const {
    std::vector<Corners> sharing;
    for (const Corners& corners : users_.at(a)) {
      if (std::find(corners.begin(), corners.end(), b) != corners.end()) sharing.push_back(corners);
    }
    if (sharing.size() != 2) sharing.clear();
    return sharing;
  }

  /// The triangles all round a corner; none if it is on a border.
  std::vector<Corners> Fan(uint32_t corner) const {
    const std::vector<Corners>& fan = users_.at(corner);
    std::map<uint32_t, int> seen;
    for (const Corners& corners : fan) {
      for (const uint32_t other : corners) ++seen[other];
    }
    seen.erase(corner);
    const bool closed =
        std::all_of(seen.begin(), seen.end(), [](const auto& one) { return one.second == 2; });
    return closed ? fan : std::vector<Corners>();
  }

  Vector3d middle_;
  IndexedMesh mesh_;
  std::map<uint32_t, std::vector<Corners>> users_;
};

}  // namespace

std::vector<SegmentQuery> AimedLines(const Scene& scene, std::span<const RobotPose> path) {
  constexpr int kFrames = kAimedLines / kAimedLinesPerFrame;
  sim::SeededNumbers numbers(6000);
  std::vector<SegmentQuery> lines;
  lines.reserve(kAimedLines);
  for (size_t frame = 0; frame < kFrames; ++frame) {
    const Vector3d& place = path[frame * path.size() / kFrames].X_MR.translation();
    const Neighbourhood near(scene, place + 0.3 * Vector3d::UnitZ());
    for (uint32_t found = 0; found < kAimedLinesPerFrame;) {
      std::optional<SegmentQuery> line = near.Aim(numbers);
      if (!line) continue;
      line->group = 1 + found++ / kLinesPerBump;
      lines.push_back(*line);
    }
  }
  return lines;
}

}  // namespace eod::bench
