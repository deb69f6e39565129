#pragma once

#include "sim/operator_command.h"
#include "sim/radio/delay_line.h"
#include "sim/radio/link_guard.h"

namespace eod::sim {

/// Commands on their way to the robot, and what the robot makes of their silence. Pure; no
/// allocation after construction.
class CommandLink {
 public:
  CommandLink(const TrafficSpec& spec, int64_t seed)
      : line_(spec, seed, LinkStream::kCommands, kMostUnderWay) {}

  /// The operator's side sends. `drop`, 0..1: chance that quality takes it, beside the line's own.
  void Send(TimePoint now, const OperatorCommand& command, double drop);

  /// What the robot obeys at `now`: the command that came in last, the ramp to zero of a SafeStop,
  /// or nothing at all. Before the first one came in, `command` stays as it is.
  void Receive(TimePoint now, OperatorCommand& command);

  const LinkGuard& guard() const { return guard_; }
  const DelayLine<OperatorCommand>& line() const { return line_; }

 private:
  /// A second of commands at ten times their usual rate.
  static constexpr size_t kMostUnderWay = 512;

  DelayLine<OperatorCommand> line_;
  LinkGuard guard_;
  OperatorCommand received_;
  bool heard_ = false;
};

}  // namespace eod::sim
