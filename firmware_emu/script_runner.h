#pragma once

#include <optional>
#include <string>
#include <vector>

#include "firmware_emu/odometer.h"
#include "firmware_emu/operator_hands.h"
#include "firmware_emu/panel_status.h"
#include "firmware_emu/script.h"
#include "firmware_emu/sight.h"
#include "firmware_emu/steering.h"
#include "platform/time.h"

namespace eod::box {

/// Plays an operator script: one call a tick, before the box's own tick.
class ScriptRunner {
 public:
  /// After a tap (reset, start, a menu key) the next line waits until it was let go for this long.
  static constexpr Duration kTapPause = std::chrono::milliseconds(100);

  explicit ScriptRunner(Script script);

  /// Does what is due at `now`, by what the box shows and what is seen. On failure all motions, the
  /// preset and the enabling switch are let go.
  void Tick(TimePoint now, const PanelStatus& status, const Sight& sight, OperatorHands& hands);

  bool is_done() const { return is_done_; }
  /// "FILE:LINE: why" once the script has failed.
  const std::optional<std::string>& failure() const { return failure_; }
  /// The line that runs now; empty when done.
  const std::string& current_line() const;
  /// Notes since the last call.
  std::vector<std::string> TakeNotes();

 private:
  /// What this tick has to go by.
  struct Evidence {
    TimePoint now;
    const PanelStatus& status;
    const Sight* sight;  ///< null: nothing is seen
  };

  bool HasEnded(const Statement& statement, const Evidence& evidence, OperatorHands& hands);
  bool HasCome(const Statement& statement, const Evidence& evidence);
  bool HasArrived(const Statement& statement, const Evidence& evidence, OperatorHands& hands);
  void Begin(const Statement& statement, TimePoint now, const PanelStatus& status,
             OperatorHands& hands);
  void Fail(const Statement& statement, const std::string& why);

  Script script_;
  size_t next_ = 0;
  bool has_begun_ = false;
  TimePoint begin_{};
  Odometer odometer_;
  Steering steering_;
  TimePoint seen_{};  ///< kManoeuvre: when it last saw its way, or began
  bool is_done_ = false;
  std::optional<std::string> failure_;
  std::vector<std::string> notes_;
};

}  // namespace eod::box
