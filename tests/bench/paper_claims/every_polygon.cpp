#include "tests/bench/paper_claims/every_polygon.h"

#include <optional>

#include "sim/geometry/object_class.h"
#include "sim/segments/exact_test.h"
#include "sim/segments/hit_choice.h"

namespace eod::claims {

void EveryPolygon::Cast(std::span<const sim::SegmentQuery> queries, std::span<sim::SegmentHit> hits,
                        sim::CastMemory& memory) const {
  memory.counters.segments += queries.size();
  memory.all.clear();
  for (size_t i = 0; i < queries.size(); ++i) {
    const sim::SegmentQuery& query = queries[i];
    hits[i] = {};
    for (size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [corner, class_mask, object] = triangles_[t];
      if (!sim::Accepts(query.class_mask, class_mask)) continue;
      ++memory.counters.candidates;
      ++memory.counters.exact;
      const std::optional<double> range = sim::Meet(query, corner[0], corner[1], corner[2]);
      if (!range) continue;
      const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      sim::Offer(static_cast<int>(i), query,
                 {.hit = true,
                  .point = query.start + *range * query.direction,
                  .normal = normal.normalized(),
                  .range = *range,
                  .object = object,
                  .object_class = class_mask,
                  .triangle = static_cast<int>(t)},
                 hits[i], memory);
    }
  }
  sim::SortListed(memory);
}

const std::string& EveryPolygon::ObjectName(int) const {
  static const std::string kNoName;
  return kNoName;
}

}  // namespace eod::claims
