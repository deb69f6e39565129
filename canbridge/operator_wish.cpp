#include "canbridge/operator_wish.h"

#include <algorithm>
#include <cmath>

namespace eod::bridge {
namespace {

constexpr uint32_t kFirstOfPairs = 0b01'0101'0101'0101'0101'0101;  // M01, M03, ..., M21

constexpr int kLastPreset = 7;  // stair down; 15 is "not available"

bool AreSticksNeutral(const dbc::ControlMap& map, const dbc::PanelState& panel) {
  for (std::size_t i = 0; i < panel.axis.size(); ++i) {
    // Written so that a NaN is not neutral.
    const bool is_at_rest = std::abs(panel.axis[i].value) <= map.axes[i].dead_zone;
    if (!panel.axis[i].valid || !is_at_rest) return false;
  }
  return true;
}

}  // namespace

OperatorWish ReadWish(const dbc::ControlMap& map, const dbc::PanelState& panel) {
  OperatorWish wish;
  wish.rate = dbc::WantedRates(map, panel);
  for (std::size_t i = 0; i < wish.rate.size(); ++i) {
    double& rate = wish.rate[i];
    rate = rate > 0 ? std::min(rate, 1.0) : 0.0;
    if (rate > 0 || panel.motion[i]) wish.wanted |= 1U << i;
  }
  const uint32_t both = wish.wanted & (wish.wanted >> 1) & kFirstOfPairs;
  wish.conflict = both | both << 1;
  for (std::size_t i = 0; i < wish.rate.size(); ++i) {
    if ((wish.conflict >> i & 1U) != 0) wish.rate[i] = 0;
  }
  const bool is_preset_wanted = panel.preset >= 1 && panel.preset <= kLastPreset;
  wish.are_sticks_neutral = AreSticksNeutral(map, panel);
  wish.is_neutral = wish.wanted == 0 && !is_preset_wanted && wish.are_sticks_neutral;
  return wish;
}

}  // namespace eod::bridge
