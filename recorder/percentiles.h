#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace eod::recorder {

/// Exact percentiles of all samples, by nearest rank: the smallest sample that at least the given
/// share of the samples does not exceed. Empty without a sample.
struct Percentiles {
  std::optional<double> p50;
  std::optional<double> p99;
  size_t n = 0;
};

Percentiles ComputePercentiles(std::vector<double> samples);

}  // namespace eod::recorder
