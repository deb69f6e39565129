#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <lcm/lcm-cpp.hpp>

#include "eod/panel_command_t.hpp"
#include "eod/panel_status_t.hpp"

#include "firmware_emu/control_box.h"
#include "firmware_emu/operator_hands.h"
#include "firmware_emu/panel_journal.h"
#include "firmware_emu/script_runner.h"
#include "firmware_emu/sight_node.h"
#include "platform/can_bus.h"
#include "platform/clock.h"

namespace eod::box {

struct BoxNodeConfig {
  std::filesystem::path dbc_file;
  std::filesystem::path map_file;
  std::string channel_prefix;
  ControlBoxConfig box;
  std::optional<Script> script;  ///< played from the first tick on
  /// Hears notes, and what changes on the panel, a line each; may be empty.
  std::function<void(TimePoint, const std::string&)> tell;
};

/// The emulated control box on CAN and LCM.
class BoxNode {
 public:
  /// Throws std::runtime_error for a DBC or map that does not load or does not fit.
  BoxNode(const BoxNodeConfig& config, CanBus& bus, lcm::LCM& lcm, const Clock& clock);
  ~BoxNode();
  BoxNode(const BoxNode&) = delete;
  BoxNode& operator=(const BoxNode&) = delete;

  void OnCan();
  void OnTick(TimePoint scheduled);
  Duration tick_period() const { return std::chrono::milliseconds(1); }

  /// True once the script has ended, well or not; false without a script.
  bool is_script_done() const { return runner_ && runner_->is_done(); }
  /// Why the script failed; empty if it did not.
  std::optional<std::string> script_failure() const;

  const PanelStatus& status() const { return box_.status(); }
  OperatorHands& hands() { return hands_; }
  /// What the map calls the alarm of that code; empty if it knows none.
  std::string_view alarm_name(int code) const;
  /// Panel commands' actions that could not be understood.
  uint64_t bad_actions() const { return bad_actions_; }
  /// Messages sent on LCM so far.
  uint64_t published() const { return published_; }

 private:
  void OnPanelCommand(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                      const panel_command_t* command);
  void CountBadAction(const std::string& why);
  void TellChanges(TimePoint now);
  void PublishStatus(TimePoint now);
  panel_status_t MakeStatus(TimePoint now) const;

  BoxNodeConfig config_;
  CanBus& bus_;
  lcm::LCM& lcm_;
  const Clock& clock_;
  dbc::ControlMap map_;
  ControlBox box_;
  OperatorHands hands_;
  std::optional<ScriptRunner> runner_;
  std::optional<SightNode> eyes_;  ///< of the script; the box itself is blind
  PanelJournal journal_;
  std::string status_channel_;
  lcm::Subscription* subscription_ = nullptr;
  panel_status_t last_status_{};
  TimePoint next_status_{};
  Duration max_late_{};
  uint64_t bad_actions_ = 0;
  uint64_t published_ = 0;
  bool has_told_end_ = false;
};

}  // namespace eod::box
