#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <lcm/lcm-cpp.hpp>

#include "eod/alarm_t.hpp"
#include "eod/box_command_t.hpp"
#include "eod/fault_event_t.hpp"
#include "eod/instructor_command_t.hpp"
#include "eod/isector_hits_t.hpp"
#include "eod/mission_status_t.hpp"
#include "eod/robot_state_t.hpp"
#include "eod/scene_t.hpp"

#include "platform/clock.h"
#include "sim/camera/camera_thread.h"
#include "sim/command_link.h"
#include "sim/simulator.h"
#include "sim/telemetry_node.h"

namespace eod::sim {

struct SimNodeConfig {
  std::string channel_prefix;
  SimulatorConfig simulator = {};
  bool publish_isectors = false;  ///< EOD_ISECTOR_HITS every step
  Duration alarm_repeat = std::chrono::milliseconds(100);
  Duration mission_repeat = std::chrono::milliseconds(200);
  Duration scene_repeat = std::chrono::milliseconds(100);
};

/// What is to be shown to cameras, if there are any.
struct SceneOutput {
  std::function<void(const SceneSnapshot&)> show;  ///< called from OnTick; empty: no cameras
  Duration period = std::chrono::milliseconds(33);
  bool draw_isectors = false;
};

/// The simulator on LCM: commands of box and instructor in; robot state, alarms and mission out.
///
/// With a link that takes time or loses messages, commands come late, what the operator's side
/// hears goes out on the telemetry channels when it arrives there, and pictures are shown late.
class SimNode {
 public:
  /// `robot` and `world` must outlive the node. Throws as Simulator does.
  SimNode(const SimNodeConfig& config, const RobotModel& robot, const WorldModel& world,
          const Scenario& scenario, lcm::LCM& lcm, const Clock& clock);
  ~SimNode();
  SimNode(const SimNode&) = delete;
  SimNode& operator=(const SimNode&) = delete;

  /// Before the first tick.
  void SetSceneOutput(SceneOutput output) { scene_output_ = std::move(output); }

  void OnCan() {}  ///< has no bus
  /// The step that is due at `scheduled`, which is the utime of all it publishes. Behind a pause,
  /// one missed step a tick is made up for, so that distances stay true to the clock and nothing
  /// bursts; beyond `kLongestDebt` the missed steps are left out.
  void OnTick(TimePoint scheduled);
  Duration tick_period() const { return config_.simulator.period; }

  const Simulator& simulator() const { return simulator_; }
  /// What the box asked for last; what the last step obeyed, until a message arrives.
  const OperatorCommand& command() const { return command_; }
  /// Messages sent on LCM so far.
  uint64_t published() const { return published_; }
  /// Steps that were not done in their own period, but later or never.
  int64_t overruns() const { return state_message_.overruns; }

  static constexpr Duration kLongestDebt = std::chrono::milliseconds(200);

 private:
  void OnCommand(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                 const box_command_t* message);
  void OnInstructor(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                    const instructor_command_t* message);
  void Connect();
  void Step(TimePoint scheduled);
  template <typename Message>
  void Publish(const std::string& channel, const Message& message);
  template <typename Message>
  void Relay(const Message& message);
  void PublishState();
  void PublishFaults(const StepResult& result);
  void PublishAlarms(const StepResult& result);
  void PublishAlarm(TimePoint time);
  void PublishMission(const StepResult& result);
  void PublishScene(const StepResult& result);
  void ShowScene(const StepResult& result);
  void TakeScene(const StepResult& result);
  void FillScene(const StepResult& result, SceneSnapshot& snapshot) const;

  SimNodeConfig config_;
  const RobotModel& robot_;
  Simulator simulator_;
  lcm::LCM& lcm_;
  const Clock& clock_;
  lcm::Subscription* subscription_ = nullptr;
  lcm::Subscription* instructor_ = nullptr;
  std::optional<int32_t> instructed_;  ///< sequence of the last command
  OperatorCommand command_;
  /// The link to the operator's side; none of them if it is as if both were one.
  struct Link {
    CommandLink commands;
    TelemetryNode telemetry;
    DelayLine<SceneSnapshot> pictures;
  };
  std::unique_ptr<Link> link_;
  int connected_ = 0;  ///< exercise that link_ was made for
  SceneOutput scene_output_;
  SceneSnapshot snapshot_;
  uint64_t published_ = 0;
  TimePoint stepped_{};  ///< moment of the last step
  TimePoint last_tick_{};
  TimePoint scene_due_{};
  TimePoint alarms_due_{};
  TimePoint mission_due_{};
  TimePoint scene_message_due_{};
  // Messages and names keep their memory from step to step.
  robot_state_t state_message_{};
  robot_state_t shown_message_{};
  fault_event_t fault_message_{};
  alarm_t alarm_message_{};
  mission_status_t mission_message_{};
  isector_hits_t isectors_message_{};
  scene_t scene_message_{};
  std::string state_channel_;
  std::string fault_channel_;
  std::string alarm_channel_;
  std::string mission_channel_;
  std::string isectors_channel_;
  std::string scene_channel_;
};

}  // namespace eod::sim
