#pragma once

#include <optional>

#include "firmware_emu/box_node.h"
#include "firmware_emu/key_parser.h"
#include "platform/terminal.h"

namespace eod::box {

/// A box node with a person or a script in front of it: to be run in place of the node.
class BoxConsole {
 public:
  struct Options {
    bool keyboard = false;  ///< raw terminal and screen
    bool stay = false;      ///< go on after the script has ended
  };

  /// Throws std::runtime_error if a keyboard is wanted and there is no terminal.
  BoxConsole(BoxNode& node, const Options& options);

  void OnCan() { node_.OnCan(); }
  void OnTick(TimePoint scheduled);
  Duration tick_period() const { return node_.tick_period(); }
  bool is_finished() const;

 private:
  void ReadKeys(TimePoint now);

  BoxNode& node_;
  Options options_;
  std::optional<Terminal> terminal_;
  KeyParser keys_;
  TimePoint last_typed_{};
  Key last_key_;
  TimePoint last_press_{};
  TimePoint next_picture_{};
  bool has_quit_ = false;
};

}  // namespace eod::box
