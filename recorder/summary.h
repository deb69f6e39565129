#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recorder/percentiles.h"

namespace eod::recorder {

/// An alarm that was raised during the run.
struct RaisedAlarm {
  double t = 0;  ///< [s] since the first robot state
  int code = 0;  ///< alarm_t.code
  uint32_t parts = 0;
};

/// One run in numbers: summary.json.
struct Summary {
  std::string bus;
  std::string module;
  /// "success": mission and operator script ended well; "fail": the mission failed or was aborted,
  /// or the script met what it did not expect; "incomplete": neither.
  std::string result;
  double sim_seconds = 0;
  std::vector<RaisedAlarm> alarms;
  struct {
    int64_t rx = 0;  ///< frames that the bridge received
    int64_t tx = 0;  ///< frames that the bridge sent
    int64_t lost = 0;
    int64_t crc_errors = 0;
    double bus_load_percent = 0;
  } can;
  struct {
    int64_t frames = 0;
    double fps = 0;  ///< mean while it was shown
    int width = 0;
    int height = 0;
  } camera;  ///< the one that was shown most
  struct {
    Percentiles button_to_pose;
    Percentiles contact_to_lamp_frame;
  } latency_ms;
  struct {
    double period_ms = 0;
    int64_t overruns = 0;
  } step;
};

/// Text of summary.json: keys in a fixed order, percentiles null without a sample.
std::string ToJson(const Summary& summary);

/// The same for people: a few lines, each ending in a newline.
std::string ToText(const Summary& summary);

/// Name of robot_state_t.module; "none" for 0 and unknown numbers.
std::string ModuleName(int module);
/// Name of alarm_t.code; the number in hexadecimal if it has none.
std::string AlarmName(int code);
/// Names of the bits of robot_state_t.contact_parts, separated by ", ".
std::string PartNames(uint32_t parts);

}  // namespace eod::recorder
