#pragma once

#include <cstdint>
#include <string>

namespace eod::sim {

/// What the instructor asks for; each one acts once, in the next step.
struct InstructorCommand {
  std::string scenario;     ///< name of the exercise to load; "": the one that is loaded
  uint64_t repetition = 0;  ///< of that exercise, see Vary
  int menu_command = 0;     ///< MenuCommand
  bool estop = false;       ///< the robot stands still as long as the last command says so
};

}  // namespace eod::sim
