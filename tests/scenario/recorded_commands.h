#pragma once

#include <vector>

#include "tests/scenario/mission.h"

namespace eod::lockstep {

/// What the simulator was given in one step.
struct CommandedStep {
  TimePoint now;
  sim::OperatorCommand command;
};

/// Plays a script to its end, at most 300 s, through box, bridge and simulator. A simulator of its
/// own that is given the same steps does the same mission, without anything else around it. Throws
/// std::runtime_error if the script does not end, or finds what it did not expect.
std::vector<CommandedStep> RecordCommands(const box::Script& script, const sim::Scenario& scenario);

}  // namespace eod::lockstep
