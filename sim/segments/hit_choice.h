#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/segments/cast_memory.h"

namespace eod::sim {

/// Whether `query` can be cast at all: within 1e6 m, its direction unit to 1e-6, its length 0 to
/// 1e6 m.
inline bool IsCastable(const SegmentQuery& query) {
  // NaN and infinity fail every comparison that they are in.
  constexpr double kFarthest = 1e6;
  const Eigen::Vector3d &start = query.start, &d = query.direction;
  return std::abs(d.x() * d.x() + d.y() * d.y() + d.z() * d.z() - 1) <= 2e-6 && query.length >= 0 &&
         query.length <= kFarthest && std::abs(start.x()) <= kFarthest &&
         std::abs(start.y()) <= kFarthest && std::abs(start.z()) <= kFarthest;
}

/// `range` within [0, length]; nothing if it lies beyond an end by more than kEndTolerance.
inline std::optional<double> OnSegment(double range, double length) {
  if (!(range >= -kEndTolerance && range <= length + kEndTolerance)) return std::nullopt;
  return std::min(std::max(0.0, range), length);  // and never -0
}

/// The highest point of a rising line is its farthest; of a level line all are equally high, and
/// the nearest is taken.
inline bool WantsFarthest(const SegmentQuery& query) {
  return query.hit_rule == HitRule::kHighest && query.direction.z() > 0;
}

/// The smaller, the better does a hit at `range` answer `query`.
inline double Rank(const SegmentQuery& query, double range) {
  return WantsFarthest(query) ? -range : range;
}

/// What decides between two hits: the smaller rank, then the lower object, then the lower triangle.
struct HitOrder {
  double rank;
  int object;
  int triangle;

  bool IsBefore(const HitOrder& other) const {
    if (rank != other.rank) return rank < other.rank;
    return object != other.object ? object < other.object : triangle < other.triangle;
  }
};

/// Which of two hits answers `query`.
inline bool IsPreferred(const SegmentQuery& query, const SegmentHit& hit, const SegmentHit& best) {
  if (!best.hit) return true;
  const HitOrder order{Rank(query, hit.range), hit.object, hit.triangle};
  return order.IsBefore({Rank(query, best.range), best.object, best.triangle});
}

/// Takes `hit` as an answer of query `index`: into the list if all are wanted, and as `best` if it
/// is preferred. `SortListed` must follow the last one.
inline void Offer(int index, const SegmentQuery& query, const SegmentHit& hit, SegmentHit& best,
                  CastMemory& memory) {
  if (query.hit_rule == HitRule::kAll) memory.all.push_back({index, hit});
  if (IsPreferred(query, hit, best)) best = hit;
}

/// Brings `memory.all` into its order: query, range, object, triangle.
inline void SortListed(CastMemory& memory) {
  std::sort(memory.all.begin(), memory.all.end(), [](const ListedHit& a, const ListedHit& b) {
    if (a.query != b.query) return a.query < b.query;
    const HitOrder order{a.hit.range, a.hit.object, a.hit.triangle};
    return order.IsBefore({b.hit.range, b.hit.object, b.hit.triangle});
  });
}

}  // namespace eod::sim
