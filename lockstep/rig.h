#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include <lcm/lcm-cpp.hpp>

#include "canbridge/bridge_node.h"
#include "firmware_emu/box_node.h"
#include "platform/clock.h"
#include "platform/inproc_can_bus.h"
#include "sim/sim_node.h"

namespace eod::lockstep {

struct RigConfig {
  bridge::BridgeNodeConfig bridge;
  sim::SimNodeConfig sim;
  TimePoint start{};  ///< virtual time before the first tick
};

/// Box, bridge and simulator in one thread and virtual time, on an in-process bus and `memq://`.
///
/// What a part sends in its tick, the others see by their next. Same inputs, same bits out, as fast
/// as the processor allows. A tick is 1 ms; the simulator steps at its own period, a whole number
/// of ticks. Within a tick: box, bridge, simulator, then whatever messages they left.
class LockStepRig {
 public:
  using StepSink = std::function<void(const sim::StepResult&, const sim::AlarmTable&)>;

  /// `robot` and `world` must outlive the rig. Throws what the nodes throw at start-up, and
  /// std::runtime_error for a period that is no whole number of milliseconds.
  LockStepRig(const RigConfig& config, const sim::RobotModel& robot, const sim::WorldModel& world,
              const sim::Scenario& scenario);

  /// Puts an emulated box on the bus.
  box::BoxNode& AddBox(const box::BoxNodeConfig& config);

  /// Pulls the box's cable: it is gone, in the middle of whatever it did.
  void UnplugBox();

  /// Puts one more node on the bus: a recorder, a stranger, a log to be replayed.
  std::unique_ptr<CanBus> Connect() { return hub_.Connect(clock_); }

  /// Hears of every step of the simulator.
  void SetStepSink(StepSink sink) { step_sink_ = std::move(sink); }

  /// Hears what cameras would be shown. Before the first tick.
  void SetSceneOutput(sim::SceneOutput output) { sim_.SetSceneOutput(std::move(output)); }

  /// Advances virtual time by one tick.
  void Tick();
  void RunFor(Duration duration);
  /// Until `done` holds after a tick, or `limit` has passed. True if it held.
  bool RunUntil(const std::function<bool()>& done, Duration limit);

  TimePoint now() const { return clock_.Now(); }
  /// What the parts say to each other; for whoever wants to listen too.
  lcm::LCM& lcm() { return lcm_; }
  const sim::Simulator& simulator() const { return sim_.simulator(); }
  /// For a StepSink: what the step obeyed.
  const sim::OperatorCommand& command() const { return sim_.command(); }
  const bridge::BridgeNode& bridge() const { return bridge_; }
  InprocCanHub& hub() { return hub_; }

 private:
  uint64_t Published() const;
  void DeliverMessages();

  RigConfig config_;
  ManualClock clock_;
  InprocCanHub hub_;
  lcm::LCM lcm_;
  std::unique_ptr<CanBus> bridge_bus_;
  std::unique_ptr<CanBus> box_bus_;
  bridge::BridgeNode bridge_;
  sim::SimNode sim_;
  std::unique_ptr<box::BoxNode> box_;
  StepSink step_sink_;
  TimePoint step_due_;
  uint64_t delivered_ = 0;         ///< of Published(): no other message waits
  uint64_t published_before_ = 0;  ///< by boxes that are gone
};

inline constexpr Duration kTick = std::chrono::milliseconds(1);

}  // namespace eod::lockstep
