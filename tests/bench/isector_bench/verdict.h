#pragma once

#include <span>
#include <vector>

#include "tests/bench/isector_bench/measure.h"
#include "tests/reference/double_tree.h"

namespace eod::bench {

/// How the answers of an engine differ from the reference's.
struct Verdict {
  int missed = 0;             ///< hits of the reference that it has not, or has farther away
  int extra = 0;              ///< hits that the reference has not, or has farther away
  double worst_error_um = 0;  ///< of the position, over all other hits
};

/// Beyond this the engine met another surface: a leak, not an error of arithmetic.
inline constexpr double kOtherSurface = 0.010;  // [m]

/// The true answers of a drive, by line.
std::vector<reference::Nearest> TrueAnswers(const reference::DoubleTree& tree, const Drive& drive);

Verdict Judge(const Drive& drive, std::span<const sim::SegmentHit> answers,
              std::span<const reference::Nearest> truth);

/// Share of the selected lines that hit, 0..1: of each frame those from `first`, `count` of them.
double HitShare(const Drive& drive, std::span<const reference::Nearest> truth, int first,
                int count);

}  // namespace eod::bench
