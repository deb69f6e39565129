#include "tests/scenario/mission.h"

#include "platform/candump_log.h"

namespace eod::lockstep {

const Shipped& ShippedData() {
  static const Shipped shipped;
  return shipped;
}

RigConfig Mission::ShippedRig() {
  RigConfig config;
  config.bridge.dbc_file = kData / "dbc/control_box.dbc";
  config.bridge.map_file = kData / "dbc/control_box.map.toml";
  config.sim.simulator.exercise = ShippedData().rules;
  return config;
}

sim::Scenario ShippedScenario(const std::string& name) {
  return sim::LoadScenario(kData / "sim/scenarios" / (name + ".toml"));
}

Mission::Mission(const std::filesystem::path& script, const RigConfig& config)
    : Mission(box::LoadScript(script), ShippedData().scenario, config) {}

Mission::Mission(const box::Script& script, const sim::Scenario& scenario, const RigConfig& config)
    : rig_(config, ShippedData().robot, ShippedData().world, scenario) {
  box::BoxNodeConfig box;
  box.dbc_file = config.bridge.dbc_file;
  box.map_file = config.bridge.map_file;
  box.script = script;
  box_ = &rig_.AddBox(box);
  listener_ = rig_.Connect();
  rig_.SetStepSink([this](const sim::StepResult& step, const sim::AlarmTable& alarms) {
    csv_.Write(step, alarms);
  });
}

bool Mission::Run(Duration limit) {
  const TimePoint end = rig_.now() + limit;
  while (!box_->is_script_done() && rig_.now() < end) Tick();
  return box_->is_script_done();
}

void Mission::Tick() {
  rig_.Tick();
  while (const std::optional<CanFrame> frame = listener_->Receive()) {
    can_log_ << FormatCandumpLine(*frame, "lockstep") << '\n';
  }
}

}  // namespace eod::lockstep
