#include "sim/segments/level_ground.h"

#include <algorithm>

namespace eod::sim {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kSlack = 1e-6;  // [m] more than any rounding

/// Twice the area of a, b, p in plan view: positive with p to the left of a b.
double Left(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool Overlaps(const Node& node, size_t child, const AlignedBox3d& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (static_cast<double>(node.low[axis][child]) > box.max()[axis]) return false;
    if (static_cast<double>(node.high[axis][child]) < box.min()[axis]) return false;
  }
  return true;
}

}  // namespace

void LevelGround::Survey(const BlockTree& tree, const AlignedBox3d& box, uint32_t class_mask,
                         uint64_t revision) {
  region_ = AlignedBox3d(box.min().array() - kMargin, box.max().array() + kMargin);
  class_mask_ = class_mask;
  revision_ = revision;
  z_.reset();
  count_ = 0;
  const bool is_level = Collect(tree) && IsUnderCentre() && HasNoBorder();
  if (is_level) z_ = triangles_[0][0].z();
}

/// False as soon as there is one that is not of the plane.
bool LevelGround::Collect(const BlockTree& tree) {
  if (tree.nodes.empty()) return false;
  std::array<int32_t, kMaxWaiting> waiting{};
  size_t count = 1;
  while (count > 0) {
    const Node& node = tree.nodes[static_cast<size_t>(waiting[--count])];
    for (size_t i = 0; i < kFanOut; ++i) {
      if (!Overlaps(node, i, region_) || !Accepts(class_mask_, node.classes[i])) continue;
      if (node.child[i] >= 0) {
        waiting[count++] = node.child[i];
      } else if (!Add(tree, static_cast<size_t>(~node.child[i]))) {
        return false;
      }
    }
  }
  return count_ > 0;
}

bool LevelGround::Add(const BlockTree& tree, size_t block) {
  const BlockPlace& place = tree.places[block];
  const Vector3d slack = Vector3d::Constant(kSlack);
  for (size_t i = 0; i < static_cast<size_t>(place.count); ++i) {
    const ExactTriangle& exact = tree.triangles[block * kBlockSize + i];
    Corners corners;
    AlignedBox3d around;
    for (size_t corner = 0; corner < 3; ++corner) {
      corners[corner] = tree.vertices[place.first_vertex + exact.vertex[corner]];
      around.extend(Vector3d(corners[corner] - slack));
      around.extend(Vector3d(corners[corner] + slack));
    }
    if (!around.intersects(region_)) continue;
    const double z = count_ > 0 ? triangles_[0][0].z() : corners[0].z();
    const bool is_level = std::all_of(corners.begin(), corners.end(),
                                      [z](const Vector3d& corner) { return corner.z() == z; });
    const bool looks_up = Left(corners[0], corners[1], corners[2]) > 0;
    if (!is_level || !looks_up || count_ == triangles_.size()) return false;
    triangles_[count_++] = corners;
  }
  return true;
}

/// Whether one of them is below the middle of the region, or next to it.
bool LevelGround::IsUnderCentre() const {
  const Vector3d centre = region_.center();
  return std::any_of(triangles_.begin(), triangles_.begin() + count_, [&](const Corners& corner) {
    return Left(corner[0], corner[1], centre) >= 0 && Left(corner[1], corner[2], centre) >= 0 &&
           Left(corner[2], corner[0], centre) >= 0;
  });
}

/// Where every edge has a triangle on its other side too, the plane ends nowhere.
bool LevelGround::HasNoBorder() const {
  for (size_t i = 0; i < count_; ++i) {
    for (size_t from = 0; from < 3; ++from) {
      const Vector3d &a = triangles_[i][from], &b = triangles_[i][(from + 1) % 3];
      if (IsCrossedBy(a, b) && !HasNeighbour(b, a)) return false;
    }
  }
  return true;
}

bool LevelGround::HasNeighbour(const Vector3d& from, const Vector3d& to) const {
  for (size_t i = 0; i < count_; ++i) {
    const Corners& corner = triangles_[i];
    for (size_t k = 0; k < 3; ++k) {
      if (corner[k] == from && corner[(k + 1) % 3] == to) return true;
    }
  }
  return false;
}

/// Whether an edge runs through the region, or near it, in plan view.
bool LevelGround::IsCrossedBy(const Vector3d& from, const Vector3d& to) const {
  const Vector3d low = from.cwiseMin(to), high = from.cwiseMax(to);
  for (int axis = 0; axis < 2; ++axis) {
    if (low[axis] > region_.max()[axis] + kSlack) return false;
    if (high[axis] < region_.min()[axis] - kSlack) return false;
  }
  const double slack = kSlack * (to - from).norm();
  int left = 0, right = 0;
  for (const auto corner : {AlignedBox3d::BottomLeftFloor, AlignedBox3d::BottomRightFloor,
                            AlignedBox3d::TopLeftFloor, AlignedBox3d::TopRightFloor}) {
    const double side = Left(from, to, region_.corner(corner));
    left += side > slack ? 1 : 0;
    right += side < -slack ? 1 : 0;
  }
  return left < 4 && right < 4;
}

}  // namespace eod::sim
