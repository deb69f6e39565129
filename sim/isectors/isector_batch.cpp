#include "sim/isectors/isector_batch.h"

namespace eod::sim {

void IsectorBatch::Reserve(size_t segments) {
  sources_.reserve(segments);
  queries_.reserve(segments);
  hits_.reserve(segments);
}

void IsectorBatch::CastIsectors(std::span<Isector> isectors, const World& world, int64_t step) {
  Collect(isectors);
  hits_.resize(queries_.size());
  memory_.counters = {};
  memory_.all.clear();
  world.Cast(queries_, hits_, memory_);
  HandOut(isectors, step);
}

void IsectorBatch::Collect(std::span<const Isector> isectors) {
  sources_.clear();
  queries_.clear();
  for (size_t i = 0; i < isectors.size(); ++i) {
    const Isector& isector = isectors[i];
    if (!isector.enabled()) continue;
    const Eigen::Isometry3d X_MS = isector.SegmentFrame();
    for (size_t s = 0; s < isector.segments().size(); ++s) {
      if (!isector.segments()[s].enabled) continue;
      SegmentQuery query = isector.QueryOf(isector.segments()[s], X_MS);
      query.group = static_cast<uint32_t>(i);
      sources_.push_back({static_cast<int>(i), static_cast<int>(s)});
      queries_.push_back(query);
    }
  }
}

void IsectorBatch::HandOut(std::span<Isector> isectors, int64_t step) {
  for (Isector& isector : isectors) {
    if (isector.enabled()) isector.BeginStep(step);
  }
  const std::span<const ListedHit> all = memory_.all;  // by query
  size_t first = 0;
  for (size_t i = 0; i < sources_.size(); ++i) {
    size_t end = first;
    while (end < all.size() && all[end].query == static_cast<int>(i)) ++end;
    isectors[sources_[i].isector].Take(sources_[i].segment, hits_[i],
                                       all.subspan(first, end - first));
    first = end;
  }
}

}  // namespace eod::sim
