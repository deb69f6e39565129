#include "batch/confidence.h"

#include <cmath>

namespace eod::batch {
namespace {

/// Probability of `successes` or more in `runs` at the share p, 0 < p < 1. Summed from the side of
/// the failures, which are few where it matters.
double AtLeast(int successes, int runs, double p) {
  double log_choose = 0, sum = 0;
  for (int failures = 0; failures <= runs - successes; ++failures) {
    if (failures > 0) {
      log_choose += std::log(static_cast<double>(runs - failures + 1) / failures);
    }
    sum += std::exp(log_choose + failures * std::log1p(-p) + (runs - failures) * std::log(p));
  }
  return sum;
}

}  // namespace

double LowerBound(int successes, int runs, double confidence) {
  if (successes <= 0) return 0;
  double low = 0, high = 1;
  // Halved until nothing lies in between: the same bits wherever it is asked.
  for (double middle = 0.5; low < middle && middle < high; middle = low + (high - low) / 2) {
    (AtLeast(successes, runs, middle) < 1 - confidence ? low : high) = middle;
  }
  return low;
}

bool AllowsClaim(int successes, int runs) {
  return LowerBound(successes, runs, kConfidence) >= kClaim;
}

}  // namespace eod::batch
