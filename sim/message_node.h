#pragma once

#include "eod/box_command_t.hpp"
#include "eod/fault_event_t.hpp"
#include "eod/instructor_command_t.hpp"
#include "eod/isector_hits_t.hpp"
#include "eod/mission_status_t.hpp"
#include "eod/robot_state_t.hpp"
#include "eod/scene_t.hpp"

#include "sim/simulator.h"

namespace eod::sim {

/// What a message tells a judge: the sample that the simulator made it of, to the last bit. It
/// points into the message.
ScoreSample ToSample(const robot_state_t& message);

/// The command in a message that was received at `received`.
OperatorCommand ToCommand(const box_command_t& message, TimePoint received);

InstructorCommand ToCommand(const instructor_command_t& message);

// These fill a message with what the last step found. Poses leave the module's local frame for the
// world's (not in scene_t), radians become degrees. What the simulator does not know is left as it
// was.

void Fill(const Simulator& simulator, robot_state_t& message);
void Fill(const Simulator& simulator, mission_status_t& message);
void Fill(const FaultInjector& faults, const FaultChange& change, fault_event_t& message);
void Fill(const RobotModel& robot, const Simulator& simulator, isector_hits_t& message);
void Fill(const Simulator& simulator, scene_t& message);

/// Makes of the truth what broken sensors show of it.
void ShowOffsets(const ActiveFaults& faults, robot_state_t& message);

}  // namespace eod::sim
