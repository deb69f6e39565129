#include "tests/bench/paper_claims/claims_json.h"

#include <nlohmann/json.hpp>

#include "tests/bench/isector_bench/workload.h"

namespace eod::claims {

using nlohmann::json;

namespace {

json ToJson(const sim::CastCounters& work) {
  return {{"segments", work.segments},
          {"blocks", work.blocks},
          {"candidates", work.candidates},
          {"exact", work.exact}};
}

json ToJson(const StopGap& gap) {
  return {{"speed_mps", gap.speed_mps},
          {"worst_mm", 1e3 * gap.worst},
          {"mean_mm", 1e3 * gap.mean},
          {"largest_mm", 1e3 * gap.largest}};
}

json ToJson(const std::vector<StopGap>& gaps) {
  json list = json::array();
  for (const StopGap& gap : gaps) list.push_back(ToJson(gap));
  return list;
}

}  // namespace

json ToJson(const MaskCounts& counts) {
  json list = json::array();
  for (const MaskCount& count : counts.counts) {
    list.push_back({{"layout", count.layout},
                    {"traversal", count.traversal},
                    {"masked", ToJson(count.masked)},
                    {"unmasked", ToJson(count.unmasked)},
                    {"same_answers", count.same_answers}});
  }
  return {{"triangles_each", counts.triangles_each},
          {"frames", counts.frames},
          {"spacing_m", counts.spacing_m},
          {"counts", list}};
}

json ToJson(const LoadingCount& count) {
  json motions = json::array();
  for (const LoadedSegments& motion : count.motions) {
    motions.push_back({{"always", motion.always}, {"loaded", motion.loaded}});
  }
  return {{"all", count.all}, {"all_always", count.all_always}, {"motions", motions}};
}

json ToJson(const WholeCount& count) { return {{"all", count.all}, {"motions", count.motions}}; }

json ToJson(const StopGaps& gaps) {
  return {{"dt_ms", 1e3 * gaps.dt_s},
          {"d0_mm", 1e3 * gaps.d0},
          {"v0_mps", gaps.v0_mps},
          {"fixed", ToJson(gaps.fixed)},
          {"eq2", ToJson(gaps.eq2)},
          {"below_v0", ToJson(gaps.below_v0)},
          {"above_v0", ToJson(gaps.above_v0)}};
}

json ToJson(const SceneCost& cost) {
  return {{"triangles", cost.triangles}, {"path_triangles_per_m2", cost.path_density},
          {"frames", cost.frames},       {"lines_per_frame", bench::kLinesPerFrame},
          {"drive", ToJson(cost.drive)}, {"round_ns_per_segment", cost.round_ns}};
}

}  // namespace eod::claims
