#pragma once

#include <cstdint>

#include "sim/disposal/disposal_status.h"
#include "sim/rules/disposal_rules.h"

namespace eod::sim {

/// The fire circuit of the box, as rule 7 of 6.3 of the design wants it. Inside the simulator only.
///
/// Safe until the key is turned to armed. Armed-wait for `arm`, and for as long as no circuit is
/// selected that has its cartridge, or the robot moves; then ready. Both buttons pressed while it
/// is ready, within `both_within` of each other, held for `hold` with the right nonce: fired, once;
/// the cartridge is gone. No shot for `time_out`: timed out. A contact of 0 or 3: fault. From
/// fired, timed out and fault only the key leads back to safe, with both buttons released. A panel
/// that has never said anything is safe, and so is a key that has not been seen in safe yet.
class FireCircuit {
 public:
  FireCircuit(const DisrupterRules& rules, uint64_t seed) : rules_(rules), seed_(seed) {}
  uint64_t seed() const { return seed_; }
  /// All cartridges are new.
  void Reset() { Reset(seed_); }
  /// With nonces of another seed.
  void Reset(uint64_t seed) { *this = FireCircuit(rules_, seed); }

  /// Whether a shot is fired in this step. `step` makes the nonce differ between armings.
  bool Advance(const FirePanel& panel, bool robot_is_still, int64_t step, double dt_s);

  FireState state() const { return state_; }
  /// 1..255 while armed, 0 otherwise.
  int nonce() const { return nonce_; }
  /// Bit c-1: circuit c has its cartridge.
  int continuity() const { return continuity_; }

 private:
  /// One of the two buttons: how long it has been held since it was pressed while ready.
  struct Button {
    bool was_released = false;  ///< since arming: one that is stuck never fires
    bool counts = false;
    double held_s = 0;
    void Update(bool pressed, bool ready, double dt_s);
  };
  void Arm(int64_t step);
  bool IsReady(const FirePanel& panel, bool robot_is_still) const;
  bool HoldsBoth(const FirePanel& panel, double dt_s);

  DisrupterRules rules_;
  uint64_t seed_;
  FireState state_ = FireState::kSafe;
  bool has_spoken_ = false;
  bool key_was_safe_ = false;
  double armed_s_ = 0;
  Button left_, right_;
  double held_s_ = 0;  ///< both, with everything right
  int nonce_ = 0;
  int last_nonce_ = 0;
  int continuity_ = 0b111;
};

}  // namespace eod::sim
