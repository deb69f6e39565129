#include "tests/bench/isector_bench/verdict.h"

#include <algorithm>

namespace eod::bench {

std::vector<reference::Nearest> TrueAnswers(const reference::DoubleTree& tree, const Drive& drive) {
  std::vector<reference::Nearest> truth;
  truth.reserve(drive.lines.size());
  for (const sim::SegmentQuery& line : drive.lines) truth.push_back(tree.Cast(line));
  return truth;
}

Verdict Judge(const Drive& drive, std::span<const sim::SegmentHit> answers,
              std::span<const reference::Nearest> truth) {
  Verdict verdict;
  for (size_t i = 0; i < answers.size(); ++i) {
    if (static_cast<int>(i) % drive.per_frame >= drive.cast) continue;
    const bool is_true = truth[i].triangle >= 0, is_given = answers[i].hit;
    if (!is_true && !is_given) continue;
    const sim::SegmentQuery& line = drive.lines[i];
    const double farther = answers[i].range - truth[i].range;
    if (!is_given || (is_true && farther > kOtherSurface)) {
      ++verdict.missed;
    } else if (!is_true || farther < -kOtherSurface) {
      ++verdict.extra;
    } else {
      const Eigen::Vector3d there = line.start + truth[i].range * line.direction;
      verdict.worst_error_um =
          std::max(verdict.worst_error_um, (answers[i].point - there).norm() * 1e6);
    }
  }
  return verdict;
}

double HitShare(const Drive& drive, std::span<const reference::Nearest> truth, int first,
                int count) {
  int hits = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    const int in_frame = static_cast<int>(i) % drive.per_frame;
    if (in_frame >= first && in_frame < first + count && truth[i].triangle >= 0) ++hits;
  }
  return static_cast<double>(hits) / (static_cast<double>(drive.frames()) * count);
}

}  // namespace eod::bench
