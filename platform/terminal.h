#pragma once

#include <string>
#include <string_view>

namespace eod {

/// Width of the terminal that standard output goes to [columns]; 0 if it goes elsewhere.
int TerminalColumns();

/// The user's terminal in raw mode, on its second screen with the cursor hidden, until destruction.
/// A crash restores it too. Ctrl-C still raises SIGINT; Ctrl-Z and Ctrl-\ are off.
class Terminal {
 public:
  /// Throws std::runtime_error if standard input or output is not a terminal.
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// What was typed since the last call; never blocks.
  std::string Read();
  /// Writes as much as the terminal takes without blocking for long; a lost picture comes again.
  void Write(std::string_view text);
};

}  // namespace eod
