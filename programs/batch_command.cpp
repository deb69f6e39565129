#include "programs/batch_command.h"

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "batch/batch_folder.h"
#include "programs/batch_display.h"

namespace eod::batch {

namespace fs = std::filesystem;

struct BatchCommands::Options {
  CLI::App* batch = nullptr;
  CLI::App* merge = nullptr;
  fs::path scenarios = EOD_DATA_DIR "/sim/scenarios";
  fs::path scripts = EOD_DATA_DIR "/firmware_emu/scripts";
  std::vector<std::string> only;
  uint64_t repetitions = 1;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::string shard = "0/1";
  double longest_s = 3600;
  GroundFiles files{.world = EOD_DATA_DIR "/sim/worlds/training_ground.sdf",
                    .robot = EOD_DATA_DIR "/sim/robots/eod_robot.sdf",
                    .rules = EOD_DATA_DIR "/sim/rules/eod_rules.toml",
                    .dbc = EOD_DATA_DIR "/dbc/control_box.dbc",
                    .map = EOD_DATA_DIR "/dbc/control_box.map.toml",
                    .program = "/proc/self/exe"};
  std::vector<fs::path> shards;
  fs::path out;
};

namespace {

void RequireExpected(const Summary& summary, size_t runs) {
  if (summary.unexpected == 0) return;
  throw std::runtime_error(
      fmt::format("{} of {} runs did not end as expected", summary.unexpected, runs));
}

size_t CountOf(const Summary& summary) {
  return static_cast<size_t>(summary.total.runs + summary.total.drills);
}

}  // namespace

BatchCommands::BatchCommands(CLI::App& app) : options_(std::make_unique<Options>()) {
  Options& options = *options_;
  CLI::App& batch = *app.add_subcommand(
      "batch", "drives scenarios by scripts, many times over, without pictures, in lock-step");
  options.batch = &batch;
  batch.add_option("--scenarios", options.scenarios, "folder of *.toml")->capture_default_str();
  batch.add_option("--scripts", options.scripts, "folder of *.boxscript, named by scenario")
      ->capture_default_str();
  batch.add_option("--only", options.only, "these scenarios alone, by name");
  batch.add_option("--repeat", options.repetitions, "runs of each script")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  batch.add_option("--jobs", options.jobs, "runs at a time; all processors by default")
      ->check(CLI::Range(1, 1024));
  batch.add_option("--shard", options.shard, "part I of N, I from 0")->type_name("I/N");
  batch.add_option("--longest-s", options.longest_s, "simulated time [s] that ends any run")
      ->check(CLI::Range(1.0, 86400.0))
      ->capture_default_str();
  batch.add_option("--world", options.files.world, "SDFormat file")->capture_default_str();
  batch.add_option("--robot", options.files.robot, "SDFormat file")->capture_default_str();
  batch.add_option("--rules", options.files.rules, "TOML file")->capture_default_str();
  batch.add_option("--dbc", options.files.dbc, "CAN data base of the box")->capture_default_str();
  batch.add_option("--map", options.files.map, "what its signals mean")->capture_default_str();
  batch
      .add_option("--out", options.out, "folder of the results; a batch goes on where it was left")
      ->required();

  CLI::App& merge = *app.add_subcommand("merge", "puts the shards of a batch together");
  options.merge = &merge;
  merge.add_option("shards", options.shards, "what --out was of each shard")->required();
  merge.add_option("--out", options.out, "folder of the results")->required();
}

BatchCommands::~BatchCommands() = default;

bool BatchCommands::is_asked() const {
  return options_->batch->parsed() || options_->merge->parsed();
}

void BatchCommands::Run() const {
  const Options& options = *options_;
  if (options.merge->parsed()) {
    const Summary merged = MergeFolders(options.shards, options.out);
    fmt::print("{}", ToTable(merged));
    return RequireExpected(merged, CountOf(merged));
  }
  const Shard shard = ParseShard(options.shard);
  const Plan plan = MakePlan(options.scenarios, options.scripts, options.only);
  for (const std::string& notice : plan.notices) fmt::print("{}\n", notice);
  const Ground ground = LoadGround(options.files);
  BeginFolder(options.out, ManifestOf(plan, ground.inputs, options.repetitions, shard));
  RunLimits limits;
  limits.longest = std::chrono::milliseconds(static_cast<int64_t>(1000 * options.longest_s));
  BatchRun run(ground, RunsOf(plan, options.repetitions, shard), RunsFolder(options.out), limits);
  Display(run, options.jobs);
  const Summary summary = FinishFolder(options.out, run.records());
  fmt::print("{}results in {}\n", ToTable(summary), (options.out / "results.csv").string());
  RequireExpected(summary, CountOf(summary));
}

}  // namespace eod::batch
