#include "sim/command_link.h"

namespace eod::sim {
void CommandLink::Send(TimePoint now, const OperatorCommand& command, double drop) {
  if (OperatorCommand* slot = line_.Send(now, drop)) *slot = command;
}

void CommandLink::Receive(TimePoint now, OperatorCommand& command) {
  while (const OperatorCommand* next = line_.Receive(now)) {
    received_ = *next;
    received_.heard = line_.arrived();
    heard_ = true;
    const bool neutral = AskedMotions(received_) == 0 && received_.preset == 0;
    guard_.Accept(received_.heard, neutral, received_.resets);
  }
  if (!heard_) return;
  guard_.Advance(now);
  command = received_;
  command.stamp = now;
  command.link_latched = guard_.is_latched();
  if (guard_.motion_permitted()) return;
  // What came in last may have been neutral or forbidden all the same.
  const double share = received_.motion_permitted || received_.safe_stop ? guard_.ramp_share() : 0;
  const MotionSet asked = AskedMotions(received_);
  for (double& rate : command.motion_rate) rate *= share;
  command.safe_stop = share > 0;
  command.motion_permitted = false;
  command.preset = 0;
  command.fire = {};
  command.inhibited |= asked;
  command.inhibit_reason = guard_.needs_neutral() ? kReasonNeutralNeeded : kReasonLinkLoss;
}

}  // namespace eod::sim
