#pragma once

#include <cstdint>

#include "platform/time.h"

namespace eod::sim {

/// Time limits of the robot's end of a link that can fail: rules 1 and 2 of the safety rules (6.3
/// of the design), as the bridge has them for the box.
struct LinkGuardLimits {
  Duration command_age = std::chrono::milliseconds(100);  ///< older: ramp to zero, SafeStop
  Duration ramp = std::chrono::milliseconds(200);         ///< from SafeStop to zero
  Duration latch_age = std::chrono::milliseconds(500);    ///< older: latched, needs Reset
};

/// Decides on the robot whether commands that come by radio may still move it. Pure; time never
/// runs backwards.
class LinkGuard {
 public:
  explicit LinkGuard(const LinkGuardLimits& limits = {}) : limits_(limits) {}

  /// A command has come in. `neutral`: it asks for no motion. `resets`: how many Resets the bridge
  /// has accepted; another number clears the latch.
  void Accept(TimePoint arrived, bool neutral, int32_t resets);
  /// Time passes.
  void Advance(TimePoint now);

  bool motion_permitted() const { return !stopped_ && !latched_; }
  /// Share 1..0 of the last rates, while the robot ramps to zero.
  double ramp_share() const { return share_; }
  bool is_latched() const { return latched_; }
  /// Commands come in time again, but none has been neutral yet.
  bool needs_neutral() const { return stopped_ && !latched_ && is_alive_; }
  /// Since the last command; 0 while they come in time, and before the first one.
  Duration silence() const { return silence_; }

 private:
  LinkGuardLimits limits_;
  bool heard_ = false;
  bool is_alive_ = true;
  bool stopped_ = false;  ///< SafeStop: until a neutral command
  bool latched_ = false;
  int32_t resets_ = 0;
  TimePoint last_{};
  TimePoint ramp_start_{};
  double share_ = 0;
  Duration silence_{};
};

}  // namespace eod::sim
