#include <iostream>

#include <CLI/CLI.hpp>

#include "platform/run_main.h"
#include "programs/batch_command.h"
#include "programs/score_command.h"
#include "programs/simulate.h"
#include "sim/scenario/catalogue.h"

int main(int argc, char** argv) {
  CLI::App app{"Simulates the robot in its world, and shows it to its cameras."};
  eod::StationOptions station;
  eod::sim::SimOptions options;
  eod::AddStationOptions(app, station);
  eod::sim::AddSimOptions(app, options);
  const eod::batch::BatchCommands batch(app);
  eod::sim::ScoreOptions score_options;
  const CLI::App& score = eod::sim::AddScoreCommand(app, score_options);
  return eod::RunMain(app, EOD_VERSION, argc, argv, [&] {
    options.node.channel_prefix = station.lcm.channel_prefix;
    if (batch.is_asked()) {
      batch.Run();
    } else if (score.parsed()) {
      eod::sim::RunScoreCommand(score_options);
    } else if (options.list) {
      std::cout << eod::sim::DescribeCatalogue(eod::sim::LoadCatalogue(options.scenarios));
    } else if (station.describe) {
      std::cout << eod::sim::Describe(options);
    } else if (options.lockstep) {
      eod::sim::SimulateLog(options);
    } else {
      eod::sim::SimulateLive(options, station);
    }
  });
}
