#include "sim/task/critical_watch.h"

#include "sim/task/task.h"

namespace eod::sim {
namespace {

std::vector<Eigen::Vector2d> AreaOf(const Scenario& scenario, const ModuleModel& module) {
  if (!scenario.area.empty()) return scenario.area;
  const double x = module.half_size.x(), y = module.half_size.y();
  if (x <= 0 || y <= 0) return {};
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

}  // namespace

/// By counting the edges that a ray towards +X crosses.
bool IsWithin(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point) {
  bool is_within = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double share = (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < a.x() + share * (b.x() - a.x())) is_within = !is_within;
  }
  return is_within;
}

CriticalWatch::CriticalWatch(const Scenario& scenario, const ModuleModel& module,
                             const CriticalRules& rules)
    : rules_(rules), critical_(scenario.critical), area_(AreaOf(scenario, module)) {
  for (size_t i = 0; i < module.movables.size(); ++i) {
    if (module.movables[i].explosive) charges_.push_back(static_cast<int>(i));
  }
  is_watched_.assign(charges_.size(), 0);
}

void CriticalWatch::Start(const TaskInputs& inputs) {
  for (size_t i = 0; i < charges_.size(); ++i) {
    const auto body = static_cast<size_t>(charges_[i]);
    const bool is_there =
        body < inputs.movables.size() && IsInArea(inputs.movables[body].translation());
    is_watched_[i] = is_there ? 1 : 0;
  }
}

bool CriticalWatch::HasExploded(const TaskInputs& inputs) const {
  return Contains(critical_, FailReason::kExploded) && inputs.disposal != nullptr &&
         inputs.disposal->detonation != DetonationCause::kNone;
}

FailReason CriticalWatch::Look(const TaskInputs& inputs) const {
  const struct {
    FailReason reason;
    bool holds;
  } failures[] = {{FailReason::kEstop, inputs.estopped},
                  {FailReason::kInstructor, inputs.ended_by_instructor},
                  {FailReason::kRollover, inputs.rolled_over},
                  {FailReason::kOutOfArea, !IsInArea(inputs.state->position)},
                  {FailReason::kBombLost, IsBombLost(inputs)},
                  {FailReason::kLinkLost, inputs.link_lost_s >= rules_.link_lost}};
  for (const auto& failure : failures) {
    if (failure.holds && Contains(critical_, failure.reason)) return failure.reason;
  }
  return FailReason::kNone;
}

bool CriticalWatch::IsInArea(const Eigen::Vector3d& p_M) const {
  return area_.empty() || IsWithin(area_, p_M.head<2>());
}

bool CriticalWatch::IsBombLost(const TaskInputs& inputs) const {
  for (size_t i = 0; i < charges_.size(); ++i) {
    if (is_watched_[i] == 0) continue;
    const Eigen::Vector3d p_M = inputs.movables[static_cast<size_t>(charges_[i])].translation();
    if (p_M.z() < rules_.bomb_below || !IsInArea(p_M)) return true;
  }
  return false;
}

}  // namespace eod::sim
