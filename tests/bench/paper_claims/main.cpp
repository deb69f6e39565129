#include <fstream>
#include <iostream>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tests/bench/isector_bench/machine.h"
#include "tests/bench/paper_claims/claim_options.h"
#include "tests/bench/paper_claims/claims_json.h"

namespace eod::claims {
namespace {

nlohmann::json Measure(const ClaimOptions& options) {
  const std::filesystem::path data = EOD_DATA_DIR;
  const sim::RobotModel robot = sim::LoadRobot(data / "sim/robots/eod_robot.sdf");
  const sim::WorldModel world = sim::LoadWorld(data / "sim/worlds/training_ground.sdf");
  nlohmann::json all;
  all["module_masks"] = ToJson(CountWithMasks(robot, world, options.mask_frames));
  all["dynamic_loading"] = {{"paper", ToJson(CountLoaded(robot, sim::Coverage::kPaper))},
                            {"extended", ToJson(CountLoaded(robot, sim::Coverage::kExtended))},
                            {"whole_isectors", ToJson(CountWholeIsectors(robot))}};
  std::vector<double> speeds;
  for (int i = 1; i <= 150; ++i) speeds.push_back(i / 100.0);
  for (const double dt_s : {1 / 25.0, 1 / 60.0, 0.004}) {
    all["stop_gap"].push_back(ToJson(MeasureStopGaps(robot, dt_s, speeds, options.starts)));
  }
  for (const int64_t triangles : options.triangles) {
    all["scene_cost"].push_back(
        ToJson(MeasureSceneCost(triangles, options.frames, options.rounds)));
  }
  const bench::Machine machine = bench::ThisMachine();
  all["machine"] = {{"processor", machine.processor}, {"compiler", machine.compiler}};
  return all;
}

}  // namespace
}  // namespace eod::claims

int main(int argc, char** argv) {
  CLI::App app{"Measures what the source paper claims, and writes the raw numbers as JSON."};
  eod::claims::ClaimOptions options;
  eod::claims::AddClaimOptions(app, options);
  try {
    app.parse(argc, argv);
    std::ofstream file(options.json_file);
    if (!file) throw std::runtime_error(options.json_file + " cannot be written");
    file << eod::claims::Measure(options).dump(1) << std::endl;
    return file ? 0 : 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "paper_claims: " << error.what() << "\n";
    return 1;
  }
}
