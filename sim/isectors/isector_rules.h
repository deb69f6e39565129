#pragma once

namespace eod::sim {

/// What keeps the work of isectors small and their distances safe. Each can be left out, so that
/// what the source paper claims for it can be measured.
struct IsectorRules {
  /// Segments are offered to objects of the robot's own module alone; off: to those of all modules
  /// that the world holds.
  bool module_masks = true;
  /// Isectors and segments are cast only while one of their motions is commanded; off: all are
  /// cast, but each can block the same motions as before.
  bool dynamic_loading = true;
  /// D grows with the speed of the isector's own origin beyond V0 (Eq. 2); off: always D0.
  bool distance_factor = true;
};

}  // namespace eod::sim
