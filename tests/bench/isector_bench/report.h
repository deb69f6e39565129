#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tests/bench/isector_bench/machine.h"
#include "tests/bench/isector_bench/size_run.h"

namespace eod::bench {

/// What is measured, and where.
std::string Introduction(const Machine& machine, const RunOptions& options);

/// Tables of one scene: short lines, lines of sight, wrong answers.
std::string Tables(const SizeResult& result);

/// A list, one object a scene. Engines that were not measured are null, and so are their ratios; a
/// ratio is the other's best time over ours.
nlohmann::json ToJson(std::span<const SizeResult> results);

}  // namespace eod::bench
