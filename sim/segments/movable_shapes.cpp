#include "sim/segments/movable_shapes.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "sim/segments/hit_choice.h"

namespace eod::sim {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kBoundsMargin = 1e-6;  // [m] more than any touch and rounding

AlignedBox3d BoundsOf(const SegmentQuery& query) {
  AlignedBox3d box(query.start);
  box.extend(query.start + query.length * query.direction);
  return box;
}

/// Of all that can be cast.
AlignedBox3d BoundsOf(std::span<const SegmentQuery> queries) {
  AlignedBox3d box;
  for (const SegmentQuery& query : queries) {
    if (IsCastable(query)) box.extend(BoundsOf(query));
  }
  return box;
}

/// How many queries, from the first on, are culled together.
size_t GroupLength(std::span<const SegmentQuery> queries) {
  const SegmentQuery& first = queries.front();
  const auto end = std::find_if(queries.begin(), queries.end(), [&](const SegmentQuery& query) {
    return query.group != first.group || query.class_mask != first.class_mask;
  });
  return static_cast<size_t>(end - queries.begin());
}

/// How far the span [low, high] is from each of a batch of spans, where that is farther than what
/// another axis has found. Plain pointers and no branch: so g++ compares several at once.
template <size_t kCount>
void WidenGaps(const double* lows, const double* highs, double low, double high,
               std::array<double, kCount>& apart) {
  double* const gap = apart.data();
  for (size_t i = 0; i < kCount; ++i) {
    const double above = lows[i] - high, below = low - highs[i];
    const double one = above > below ? above : below;
    gap[i] = one > gap[i] ? one : gap[i];
  }
}

}  // namespace

void MovableShapes::BoxList::Resize(size_t count) {
  const size_t padded = (count + kBatch - 1) / kBatch * kBatch;
  for (auto& list : low) list.resize(padded);
  for (auto& list : high) list.resize(padded);
  for (size_t i = count; i < padded; ++i) Set(i, AlignedBox3d());
}

void MovableShapes::BoxList::Set(size_t index, const AlignedBox3d& box) {
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    low[axis][index] = box.isEmpty() ? kInfinity : box.min()[a] - kBoundsMargin;
    high[axis][index] = box.isEmpty() ? -kInfinity : box.max()[a] + kBoundsMargin;
  }
}

bool MovableShapes::BoxList::Overlaps(size_t index, const AlignedBox3d& box) const {
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    if (low[axis][index] > box.max()[a] || high[axis][index] < box.min()[a]) return false;
  }
  return true;
}

uint32_t MovableShapes::BoxList::OverlappingBatch(size_t first, const AlignedBox3d& box) const {
  std::array<double, kBatch> apart;
  apart.fill(-kInfinity);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    WidenGaps(low[axis].data() + first, high[axis].data() + first, box.min()[a], box.max()[a],
              apart);
  }
  uint32_t overlapping = 0;
  for (size_t i = 0; i < kBatch; ++i) overlapping |= static_cast<uint32_t>(apart[i] <= 0) << i;
  return overlapping;
}

void MovableShapes::Place(size_t index, const Eigen::Isometry3d& X_MO) {
  Placed& placed = placed_[index];
  placed.X_MS = X_MO * placed.X_OS;
  placed.hidden = false;
  bounds_.Set(index, placed.shape.Bounds(placed.X_MS));
}

void MovableShapes::Add(int object, uint32_t class_mask, Shape shape, const Eigen::Isometry3d& X_MO,
                        const Eigen::Isometry3d& X_OS) {
  placed_.push_back({object, class_mask, std::move(shape), X_OS, X_OS});
  bounds_.Resize(placed_.size());
  Place(placed_.size() - 1, X_MO);
}

bool MovableShapes::Move(int object, const Eigen::Isometry3d& X_MO) {
  bool found = false;
  for (size_t i = 0; i < placed_.size(); ++i) {
    if (placed_[i].object != object) continue;
    Place(i, X_MO);
    found = true;
  }
  return found;
}

bool MovableShapes::Hide(int object) {
  bool found = false;
  for (size_t i = 0; i < placed_.size(); ++i) {
    if (placed_[i].object != object) continue;
    placed_[i].hidden = true;
    bounds_.Set(i, AlignedBox3d());
    found = true;
  }
  return found;
}

bool MovableShapes::Remove(int object) {
  const auto of_object = [object](const Placed& placed) { return placed.object == object; };
  if (std::erase_if(placed_, of_object) == 0) return false;
  bounds_.Resize(placed_.size());
  for (size_t i = 0; i < placed_.size(); ++i) {
    bounds_.Set(i, placed_[i].hidden ? AlignedBox3d() : placed_[i].shape.Bounds(placed_[i].X_MS));
  }
  return true;
}

bool MovableShapes::IsNear(const AlignedBox3d& box, uint32_t class_mask) const {
  for (size_t batch = 0; batch < placed_.size(); batch += kBatch) {
    for (uint32_t near = bounds_.OverlappingBatch(batch, box); near != 0; near &= near - 1) {
      const size_t one = batch + static_cast<size_t>(std::countr_zero(near));
      if (Accepts(class_mask, placed_[one].class_mask)) return true;
    }
  }
  return false;
}

void MovableShapes::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                         CastMemory& memory) const {
  const NearShapes near = ShapesNear(queries);
  if (near.are_few && near.count == 0) return;
  const size_t listed = memory.all.size();
  for (size_t first = 0; first < queries.size();) {
    const size_t count = GroupLength(queries.subspan(first));
    CastGroup(queries.subspan(first, count), first, near, hits.subspan(first, count), memory);
    first += count;
  }
  if (memory.all.size() != listed) SortListed(memory);
}

MovableShapes::NearShapes MovableShapes::ShapesNear(std::span<const SegmentQuery> queries) const {
  const AlignedBox3d around = BoundsOf(queries);
  NearShapes result;
  if (around.isEmpty()) return result;
  for (size_t batch = 0; batch < placed_.size(); batch += kBatch) {
    for (uint32_t near = bounds_.OverlappingBatch(batch, around); near != 0; near &= near - 1) {
      result.are_few = result.count < NearShapes::kMost;
      if (!result.are_few) return result;
      result.index[result.count++] = batch + static_cast<size_t>(std::countr_zero(near));
    }
  }
  return result;
}

void MovableShapes::CastGroup(std::span<const SegmentQuery> group, size_t first,
                              const NearShapes& near, std::span<SegmentHit> hits,
                              CastMemory& memory) const {
  const AlignedBox3d around = BoundsOf(group);
  if (around.isEmpty()) return;
  if (near.are_few) {
    for (size_t i = 0; i < near.count; ++i) {
      if (bounds_.Overlaps(near.index[i], around)) {
        CastAt(near.index[i], group, first, hits, memory);
      }
    }
    return;
  }
  for (size_t batch = 0; batch < placed_.size(); batch += kBatch) {
    for (uint32_t bits = bounds_.OverlappingBatch(batch, around); bits != 0; bits &= bits - 1) {
      CastAt(batch + static_cast<size_t>(std::countr_zero(bits)), group, first, hits, memory);
    }
  }
}

void MovableShapes::CastAt(size_t shape, std::span<const SegmentQuery> group, size_t first,
                           std::span<SegmentHit> hits, CastMemory& memory) const {
  if (!Accepts(group.front().class_mask, placed_[shape].class_mask)) return;
  for (size_t i = 0; i < group.size(); ++i) {
    if (!IsCastable(group[i]) || !bounds_.Overlaps(shape, BoundsOf(group[i]))) continue;
    Meet(placed_[shape], first + i, group[i], hits[i], memory);
  }
}

void MovableShapes::Meet(const Placed& placed, size_t index, const SegmentQuery& query,
                         SegmentHit& best, CastMemory& memory) {
  ++memory.counters.candidates;
  const Eigen::Matrix3d& R_MS = placed.X_MS.linear();
  const Vector3d start = R_MS.transpose() * (query.start - placed.X_MS.translation());
  const Vector3d direction = R_MS.transpose() * query.direction;
  const Crossings crossings = placed.shape.Cross(start, direction, query.length);
  for (const Crossing& crossing : crossings.all()) {
    if (query.face_rule == FaceRule::kFrontOnly && !crossing.entry) continue;
    Offer(static_cast<int>(index), query,
          {.hit = true,
           .point = query.start + crossing.range * query.direction,
           .normal = R_MS * crossing.normal,
           .range = crossing.range,
           .object = placed.object,
           .object_class = placed.class_mask},
          best, memory);
  }
}

}  // namespace eod::sim
