#pragma once

namespace eod::sim {

class TomlTable;

/// How an exercise is scored: shares of 100 points, and what passes.
struct Rubric {
  double steps = 40;      ///< completed steps by their weights
  double safety = 30;     ///< collisions, pushing on, tilt, touches, fire rules, unseen driving
  double precision = 15;  ///< the exercise's own measures
  double time = 10;       ///< full at par, none at twice par
  double economy = 5;     ///< reversals, limits hit, needless motions
  double pass = 70;       ///< points that pass, without a critical failure
  /// [rad] tilt that costs points; 0: where the alarm is. For slopes that ask for more.
  double tilt = 0;
  bool operator==(const Rubric&) const = default;
};

/// Reads [score]. Throws "FILE:LINE: …".
Rubric ReadRubric(const TomlTable& table);

}  // namespace eod::sim
