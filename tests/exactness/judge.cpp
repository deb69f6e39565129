#include "tests/exactness/judge.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {
namespace {

constexpr long double kEqual = 1e-6L;   // [m] ranges this near are one answer
constexpr double kAllowedError = 5e-6;  // [m]

const ReferenceHit* Find(std::span<const ReferenceHit> expected, int triangle) {
  const auto found =
      std::find_if(expected.begin(), expected.end(), [&](const ReferenceHit& candidate) {
        return candidate.triangle == static_cast<size_t>(triangle);
      });
  return found == expected.end() ? nullptr : &*found;
}

/// Counts one hit of the engine as right or extra.
void Check(const SegmentHit& hit, std::span<const ReferenceHit> expected, Verdict& verdict) {
  const ReferenceHit* same = Find(expected, hit.triangle);
  if (same == nullptr) {
    ++verdict.extra;
    return;
  }
  const auto error =
      static_cast<double>(std::abs(same->range - static_cast<long double>(hit.range)));
  verdict.worst_error = std::max(verdict.worst_error, error);
}

}  // namespace

void Verdict::Add(const Verdict& other) {
  segments += other.segments;
  refused += other.refused;
  hits += other.hits;
  missed += other.missed;
  extra += other.extra;
  different += other.different;
  worst_error = std::max(worst_error, other.worst_error);
}

bool Verdict::ok() const {
  return missed == 0 && extra == 0 && different == 0 && worst_error < kAllowedError;
}

void Judge(const SegmentQuery& query, const SegmentHit& hit, std::span<const ListedHit> listed,
           std::span<const ReferenceHit> expected, Verdict& verdict) {
  ++verdict.segments;
  if (!expected.empty()) ++verdict.hits;
  if (hit.hit) Check(hit, expected, verdict);
  const bool farthest = query.hit_rule == HitRule::kHighest && query.direction.z() > 0;
  for (const ReferenceHit& one : expected) {
    if (one.doubtful) continue;
    const long double better = static_cast<long double>(hit.range) - one.range;
    if (!hit.hit || (farthest ? -better : better) > kEqual) {
      ++verdict.missed;
      break;
    }
  }
  if (query.hit_rule != HitRule::kAll) return;
  for (const ListedHit& entry : listed) Check(entry.hit, expected, verdict);
  for (const ReferenceHit& one : expected) {
    const bool is_listed = std::any_of(listed.begin(), listed.end(), [&](const ListedHit& entry) {
      return static_cast<size_t>(entry.hit.triangle) == one.triangle;
    });
    if (!is_listed && !one.doubtful) ++verdict.missed;
  }
}

}  // namespace eod::sim
