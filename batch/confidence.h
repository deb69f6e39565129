#pragma once

namespace eod::batch {

/// How often a success is at least to be expected, given `successes` of `runs` independent runs:
/// the one-sided lower bound of Clopper and Pearson (1934) at `confidence`, 0..1. It is the share p
/// at which so many successes or more come with the probability 1 - confidence.
/// 0 <= successes <= runs; 0 without a success.
double LowerBound(int successes, int runs, double confidence);

/// What a scenario claims: so many successes, that surely [domain: reliability statement].
inline constexpr double kConfidence = 0.8;
inline constexpr double kClaim = 0.8;

/// Whether the runs allow the claim of kClaim at kConfidence: 0 failures in 8 runs, 1 in 14, ...
bool AllowsClaim(int successes, int runs);

}  // namespace eod::batch
