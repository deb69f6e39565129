#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/rules/critical_rules.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world_model.h"

namespace eod::sim {

struct TaskInputs;

/// Whether a point lies within a polygon, which may be concave but must not cross itself.
bool IsWithin(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point);

/// Looks for what ends an exercise at once, whatever was achieved so far, as far as the scenario
/// calls it critical. Pure; no allocation after construction.
class CriticalWatch {
 public:
  CriticalWatch(const Scenario& scenario, const ModuleModel& module, const CriticalRules& rules);

  /// The mission starts: charges that are outside of the area now are no one's business.
  void Start(const TaskInputs& inputs);

  /// A charge went off.
  bool HasExploded(const TaskInputs& inputs) const;
  /// Everything else, the gravest first; kNone if all is well.
  FailReason Look(const TaskInputs& inputs) const;

 private:
  bool IsInArea(const Eigen::Vector3d& p_M) const;
  bool IsBombLost(const TaskInputs& inputs) const;

  CriticalRules rules_;
  FailReasons critical_;
  std::vector<Eigen::Vector2d> area_;  ///< empty: everywhere
  std::vector<int> charges_;           ///< movables of the module that are charges
  std::vector<char> is_watched_;       ///< one a charge
};

}  // namespace eod::sim
