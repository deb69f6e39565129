#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "dbc/box_codec.h"
#include "platform/can_bus.h"
#include "platform/clock.h"
#include "recorder/bus_load.h"
#include "recorder/recorder_config.h"
#include "recorder/run_folder.h"
#include "recorder/run_observer.h"
#include "recorder/status_line.h"
#include "recorder/typeface.h"

namespace eod::recorder {

/// Listens to the bus and to LCM, and writes the run down. Never sends.
class RecorderNode {
 public:
  /// Throws std::runtime_error with one line if the DBC, the map, a font or a file of `folder`
  /// cannot be used.
  RecorderNode(const RecorderConfig& config, const RunFolder& folder, CanBus& bus, lcm::LCM& lcm,
               const Clock& clock);

  void OnCan();
  void OnTick(TimePoint scheduled);
  Duration tick_period() const { return std::chrono::milliseconds(100); }

  /// The recording has reached its end.
  bool is_finished() const { return is_finished_; }

  /// Writes summary.json and, if there are pictures, contact_sheet.png; prints the summary. Throws
  /// std::runtime_error if a file cannot be written.
  void Finish();

 private:
  void OnMessage(const lcm::ReceiveBuffer* buffer, const std::string& channel);
  void Observe(const lcm::ReceiveBuffer& buffer, const std::string& channel);
  void OnImage(const lcm::ReceiveBuffer& buffer, Camera camera);
  void KeepPicture(Camera camera, TimePoint time, const Jpeg& jpeg);
  void ShowLine(TimePoint now);
  void ShowPlain(TimePoint now);

  RecorderConfig config_;
  const RunFolder& folder_;
  CanBus& bus_;
  const Clock& clock_;
  dbc::ControlMap map_;
  dbc::BoxCodec box_end_;
  dbc::BoxCodec robot_end_;
  dbc::PanelState panel_;
  dbc::RobotFeedback feedback_;
  Typefaces typefaces_;
  lcm::LogFile log_;
  RunObserver observer_;
  BusLoad load_;

  std::map<Camera, TimePoint> kept_;  ///< time of the last kept picture
  std::map<Camera, size_t> kept_alarms_;
  int64_t write_failures_ = 0;

  TimePoint started_{};
  std::optional<TimePoint> reached_;
  bool is_finished_ = false;
  std::string shown_;
  TimePoint next_line_{};
};

}  // namespace eod::recorder
