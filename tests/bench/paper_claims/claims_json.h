#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tests/bench/paper_claims/dynamic_loading.h"
#include "tests/bench/paper_claims/module_masks.h"
#include "tests/bench/paper_claims/scene_cost.h"
#include "tests/bench/paper_claims/stop_gap.h"

namespace eod::claims {

/// Raw numbers; units are in the names where they are not metres or counts.
nlohmann::json ToJson(const MaskCounts& counts);
nlohmann::json ToJson(const LoadingCount& count);
nlohmann::json ToJson(const WholeCount& count);
nlohmann::json ToJson(const StopGaps& gaps);
nlohmann::json ToJson(const SceneCost& cost);

}  // namespace eod::claims
