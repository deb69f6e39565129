#include "dbc/control_map.h"

#include <algorithm>
#include <cmath>

namespace eod::dbc {
namespace {

constexpr int kDriveMotions = 4;  // M01..M04

/// Finite and within 0..1, else 0: a doubtful rate is no motion.
double Share(double value) { return value > 0 ? std::min(value, 1.0) : 0.0; }

/// Deflection beyond the dead zone, rescaled so that it begins at 0 and ends at 1.
double BeyondDeadZone(double deflection, double dead_zone) {
  return Share((Share(std::abs(deflection)) - dead_zone) / (1 - dead_zone));
}

const AxisMap::Pair* PairOf(const AxisMap& axis, ControlMode mode) {
  const auto found = std::find_if(axis.motions.begin(), axis.motions.end(),
                                  [&](const AxisMap::Pair& pair) { return pair.mode == mode; });
  return found == axis.motions.end() ? nullptr : &*found;
}

}  // namespace

const AlarmMap* ControlMap::FindAlarm(int code) const {
  const auto found = std::find_if(alarms.begin(), alarms.end(),
                                  [&](const AlarmMap& alarm) { return alarm.code == code; });
  return found == alarms.end() ? nullptr : &*found;
}

std::array<double, kMotionCount> WantedRates(const ControlMap& map, const PanelState& panel) {
  std::array<double, kMotionCount> rates{};
  for (size_t m = 0; m < rates.size(); ++m) {
    if (!panel.motion[m] || panel.button_channel_fault) continue;
    rates[m] = m < kDriveMotions ? 1.0 : Share(panel.joint_rate);
  }
  for (size_t a = 0; a < map.axes.size(); ++a) {
    const Axis& axis = panel.axis[a];
    const AxisMap::Pair* pair = PairOf(map.axes[a], panel.mode);
    if (pair == nullptr || !axis.valid) continue;
    const int motion = axis.value > 0 ? pair->positive : pair->negative;
    if (motion < 1 || motion > kMotionCount) continue;
    double& rate = rates[static_cast<size_t>(motion - 1)];
    rate = std::max(rate, BeyondDeadZone(axis.value, map.axes[a].dead_zone));
  }
  for (double& rate : rates) rate *= Share(panel.speed_limit);
  return rates;
}

}  // namespace eod::dbc
