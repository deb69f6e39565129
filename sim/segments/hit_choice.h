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

/// Which of two hits answers `query`; of equals the lower object, then the lower triangle.
inline bool IsPreferred(const SegmentQuery& query, const SegmentHit& hit, const SegmentHit& best) {
  if (!best.hit) return true;
  const double rank = Rank(query, hit.range), best_rank = Rank(query, best.range);
  if (rank != best_rank) return rank < best_rank;
  if (hit.object != best.object) return hit.object < best.object;
  return hit.triangle < best.triangle;
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
    if (a.hit.range != b.hit.range) return a.hit.range < b.hit.range;
    if (a.hit.object != b.hit.object) return a.hit.object < b.hit.object;
    return a.hit.triangle < b.hit.triangle;
  });
}

}  // namespace eod::sim
