#include "recorder/percentiles.h"

#include <algorithm>

namespace eod::recorder {

Percentiles ComputePercentiles(std::vector<double> samples) {
  Percentiles result;
  result.n = samples.size();
  if (samples.empty()) return result;
  std::sort(samples.begin(), samples.end());
  // Rank ceil(percent / 100 * n), in integers: no rounding at exact ranks.
  const auto at = [&samples](size_t percent) {
    return samples[(percent * samples.size() + 99) / 100 - 1];
  };
  result.p50 = at(50);
  result.p99 = at(99);
  return result;
}

}  // namespace eod::recorder
