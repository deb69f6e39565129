#pragma once

#include <string>

#include "batch/batch_folder.h"
#include "batch/batch_run.h"
#include "tests/unit/batch/scratch_folder.h"

namespace eod::batch {

/// Robot, world and rules as shipped; this test program in the place of eod-sim. Read once.
inline const Ground& ShippedGround() {
  static const std::filesystem::path data = EOD_DATA_DIR;
  static const Ground ground = LoadGround({.world = data / "sim/worlds/training_ground.sdf",
                                           .robot = data / "sim/robots/eod_robot.sdf",
                                           .rules = data / "sim/rules/eod_rules.toml",
                                           .dbc = data / "dbc/control_box.dbc",
                                           .map = data / "dbc/control_box.map.toml",
                                           .program = "/proc/self/exe"});
  return ground;
}

/// A folder with an exercise that takes seconds, and scripts that end it in several ways.
class ShortExercise {
 public:
  ShortExercise() {
    folder_.Put("scenarios/short.toml",
                "name = \"short\"\nmodule = 1\ntime_limit_s = 9\nseed = 7\n"
                "[start]\nspread_m = [0.2, 0.2]\n"
                "[[step]]\nkind = \"reach\"\nx_m = 0\ny_m = 1\ntolerance_m = 0.1\ntext = \"Go\"\n");
    folder_.Put("scripts/short.boxscript", kPowerUp + "drive to 0 1 within 30s\nwait 9s\n");
    folder_.Put("scripts/short.late.boxscript",
                "# expect: failure time_out\n" + kPowerUp + "wait mission fail within 60s\n");
    folder_.Put("scripts/short.lost.boxscript",
                "# expect: script\n" + kPowerUp + "approach ghost at 1\n");
    folder_.Put("scripts/short.hangs.boxscript",
                "# expect: unfinished\nwait mission success within 3600s\n");
    folder_.Put("scripts/short.idle.boxscript", "# expect: unfinished\n" + kPowerUp);
  }
  Plan MakePlan() const { return batch::MakePlan(folder_ / "scenarios", folder_ / "scripts", {}); }
  const ScratchFolder& folder() const { return folder_; }

  inline static const std::string kPowerUp =
      "wait state standby within 3s\nkey operate\ndeadman enabled\nwait link up within 5s\n"
      "reset\nstart\nwait robot operate within 3s\nmenu module flat\nmenu start\n"
      "wait mission run within 5s\n";

 private:
  ScratchFolder folder_;
};

/// Drives a shard of `plan` to its end in `out`, and leaves its results there.
inline BatchProgress Drive(const Plan& plan, uint64_t repetitions, const Shard& shard, int threads,
                           const std::filesystem::path& out) {
  const Ground& ground = ShippedGround();
  BeginFolder(out, ManifestOf(plan, ground.inputs, repetitions, shard));
  BatchRun run(ground, RunsOf(plan, repetitions, shard), RunsFolder(out), {});
  run.Start(threads);
  run.Join();
  FinishFolder(out, run.records());
  return run.progress();
}

}  // namespace eod::batch
