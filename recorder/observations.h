#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "dbc/panel_state.h"
#include "platform/time.h"

namespace eod::recorder {

// What the recorder takes from each LCM message; the fields mean what lcmtypes/*.lcm says.

struct RobotStateSeen {
  TimePoint time{};  ///< scheduled time of the step
  int64_t step = 0;
  int64_t overruns = 0;  ///< steps that were not done in their own period so far
  int module = 0;
  std::array<double, 3> position_m{};
  std::array<double, 3> attitude_deg{};  ///< heading, pitch, roll
  std::array<double, dbc::kJointCount> joint{};
  double speed_mps = 0;
  uint32_t inhibit_mask = 0;
};

struct AlarmSeen {
  TimePoint time{};  ///< of the step that made the change
  int code = 0;
  bool raised = false;
  uint32_t parts = 0;
};

struct LinkSeen {
  int bus_state = 1;   ///< 0 up, 1 down, 2 bus-off
  double quality = 0;  ///< 0..1
  int64_t rx = 0;
  int64_t tx = 0;
  int64_t lost = 0;
  int64_t crc_errors = 0;
};

enum class MissionState : int { kIdle, kBrief, kRun, kSuccess, kFail, kAbort };

struct MissionSeen {
  MissionState state = MissionState::kIdle;
  int module = 0;
  int step = 0;
  int steps = 0;
  std::string step_text;
};

struct PanelSeen {
  std::string script_line;
  bool script_done = false;  ///< ended, well or not
  bool script_failed = false;
};

/// In the order of their worth to somebody who looks at a run.
enum class Camera : uint8_t { kDrive, kMast, kGripper, kRear, kQuad };
inline constexpr int kCameraCount = 5;

inline constexpr int kModuleCount = 5;
inline constexpr int kCollisionAlarm = 0x10;  ///< alarm_t.code

}  // namespace eod::recorder
