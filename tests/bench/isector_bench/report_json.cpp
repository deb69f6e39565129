#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "tests/bench/isector_bench/report.h"

namespace eod::bench {

namespace {

using nlohmann::json;

constexpr std::array kPeers = {"bullet", "embree", "embree_robust", "osg"};

json ToJson(const EngineResult& result) {
  if (result.outcome != Outcome::kMeasured) return nullptr;
  const DriveTimes& lines = result.short_lines;
  json object = {
      {"ns_per_segment_best", lines.ns_per_line(lines.best_us())},
      {"ns_per_segment_median", lines.ns_per_line(lines.median_us())},
      {"us_per_frame_best", lines.best_us()},
      {"us_per_frame_median", lines.median_us()},
      {"worst_frame_us", lines.worst_frame_us},
      {"worst_frame_undisturbed_us", lines.worst_undisturbed_us()},
      {"build_s", result.build_s},
      {"bytes", result.bytes},
      {"missed", result.missed()},
      {"extra", result.extra()},
      {"missed_on_path", result.on_path.missed},
      {"extra_on_path", result.on_path.extra},
      {"missed_at_edges", result.at_edges.missed},
      {"extra_at_edges", result.at_edges.extra},
      {"worst_error_um", std::max(result.on_path.worst_error_um, result.at_edges.worst_error_um)},
  };
  const DriveTimes& sight = result.sight_lines;
  if (sight.round_us.empty()) return object;
  object["los_ns_best"] = sight.ns_per_line(sight.best_us());
  object["los_ns_median"] = sight.ns_per_line(sight.median_us());
  object["missed_los"] = result.in_sight.missed;
  object["extra_los"] = result.in_sight.extra;
  object["worst_error_los_um"] = result.in_sight.worst_error_um;
  return object;
}

json Ratio(const json& peer, const json& ours, const char* key) {
  if (peer.is_null() || ours.is_null()) return nullptr;
  return peer.at(key).get<double>() / ours.at(key).get<double>();
}

}  // namespace

json ToJson(std::span<const SizeResult> results) {
  json list = json::array();
  for (const SizeResult& result : results) {
    json engines = json::object();
    for (const EngineResult& engine : result.engines) engines[engine.spec.name] = ToJson(engine);
    json ratios = json::object(), los_ratios = json::object();
    for (const char* peer : kPeers) {
      ratios[peer] = Ratio(engines[peer], engines["ours"], "ns_per_segment_best");
      los_ratios[peer] = Ratio(engines[peer], engines["ours"], "los_ns_best");
    }
    list.push_back({{"triangles", result.triangles},
                    {"terrain_triangles_per_m2", result.terrain_density},
                    {"path_triangles_per_m2", result.path_density},
                    {"hit_share", result.short_hits},
                    {"hit_share_tripod", result.leg_hits},
                    {"hit_share_bump", result.bump_hits},
                    {"hit_share_los", result.sight_hits},
                    {"engines", engines},
                    {"ratios", ratios},
                    {"los_ratios", los_ratios}});
  }
  return list;
}

}  // namespace eod::bench
