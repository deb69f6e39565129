#pragma once

#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

#include "dbc/box_codec.h"
#include "lockstep/rig.h"
#include "sim/scenario/scenario.h"
#include "sim/state_csv.h"

namespace eod::lockstep {

inline const std::filesystem::path kData = EOD_DATA_DIR;

/// Robot, world and scenario as shipped; loaded once for all missions of a test program.
struct Shipped {
  sim::RobotModel robot = sim::LoadRobot(kData / "sim/robots/eod_robot.sdf");
  sim::WorldModel world = sim::LoadWorld(kData / "sim/worlds/training_ground.sdf");
  sim::Rules rules = sim::LoadRules(kData / "sim/rules/eod_rules.toml");
  sim::Scenario scenario = sim::LoadScenario(kData / "sim/scenarios/flat_first_drive.toml");
};
const Shipped& ShippedData();

/// A scenario as shipped, by the name of its file without ".toml".
sim::Scenario ShippedScenario(const std::string& name);

/// A whole mission in lock-step, driven by an operator script through the box, with everything that
/// was on the bus and every state kept as text.
class Mission {
 public:
  /// The first drive, by a script file.
  explicit Mission(const std::filesystem::path& script, const RigConfig& config = ShippedRig());
  Mission(const box::Script& script, const sim::Scenario& scenario,
          const RigConfig& config = ShippedRig());

  static RigConfig ShippedRig();

  /// Runs until the script has ended, but no longer than `limit`. True if it ended.
  bool Run(Duration limit);

  LockStepRig& rig() { return rig_; }
  box::BoxNode& box() { return *box_; }
  /// One millisecond.
  void Tick();

  std::string can_log() const { return can_log_.str(); }
  std::string states() const { return states_.str(); }

 private:
  LockStepRig rig_;
  box::BoxNode* box_;
  std::unique_ptr<CanBus> listener_;
  std::ostringstream can_log_;
  std::ostringstream states_;
  sim::StateCsv csv_{states_};
};

}  // namespace eod::lockstep
