#include "lockstep/rig.h"

#include <stdexcept>

#include <fmt/format.h>

namespace eod::lockstep {

LockStepRig::LockStepRig(const RigConfig& config, const sim::RobotModel& robot,
                         const sim::WorldModel& world, const sim::Scenario& scenario)
    : config_(config),
      clock_(config.start),
      hub_("lockstep"),
      lcm_("memq://"),
      bridge_bus_(hub_.Connect(clock_)),
      bridge_(config.bridge, *bridge_bus_, lcm_, clock_),
      sim_(config.sim, robot, world, scenario, lcm_, clock_),
      step_due_(config.start + sim_.tick_period()) {
  if (sim_.tick_period() % kTick != Duration::zero()) {
    throw std::runtime_error(
        fmt::format("step period {} ns: lock-step needs a whole number of milliseconds",
                    sim_.tick_period().count()));
  }
}

box::BoxNode& LockStepRig::AddBox(const box::BoxNodeConfig& config) {
  UnplugBox();
  box_bus_ = hub_.Connect(clock_);
  box_ = std::make_unique<box::BoxNode>(config, *box_bus_, lcm_, clock_);
  return *box_;
}

void LockStepRig::UnplugBox() {
  if (box_) published_before_ += box_->published();
  box_.reset();
  box_bus_.reset();
}

void LockStepRig::Tick() {
  clock_.Advance(kTick);
  if (box_) {
    box_->OnCan();
    box_->OnTick(now());
  }
  bridge_.OnCan();
  bridge_.OnTick(now());
  DeliverMessages();
  if (now() >= step_due_) {
    sim_.OnTick(step_due_);
    step_due_ += sim_.tick_period();
    if (step_sink_) step_sink_(simulator().last(), simulator().alarms());
    DeliverMessages();
  }
}

uint64_t LockStepRig::Published() const {
  return bridge_.published() + sim_.published() + published_before_ +
         (box_ ? box_->published() : 0);
}

/// Whether a message waits is a question to the kernel, so it is only asked if one can.
void LockStepRig::DeliverMessages() {
  if (delivered_ == Published()) return;
  while (lcm_.handleTimeout(0) > 0) {
  }
  delivered_ = Published();
}

void LockStepRig::RunFor(Duration duration) {
  const TimePoint end = now() + duration;
  while (now() < end) Tick();
}

bool LockStepRig::RunUntil(const std::function<bool()>& done, Duration limit) {
  const TimePoint end = now() + limit;
  while (!done()) {
    if (now() >= end) return false;
    Tick();
  }
  return true;
}

}  // namespace eod::lockstep
