#include "programs/recorder_options.h"

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace eod::recorder {

void AddRecorderOptions(CLI::App& app, RecorderConfig& config) {
  static const std::map<std::string, Until> kEnds{{"mission-end", Until::kMissionEnd},
                                                  {"script-done", Until::kScriptDone}};
  app.add_option("--out", config.out, "folder for the recording")->capture_default_str();
  app.add_option("--dbc", config.dbc_file, "CAN data base of the box")->capture_default_str();
  app.add_option("--map", config.map_file, "what its signals mean")->capture_default_str();
  app.add_option("--bit-rate", config.bit_rate, "of the bus [bit/s], to tell its load")
      ->check(CLI::Range(10'000, 1'000'000))
      ->capture_default_str();
  app.add_option("--picture-period", config.picture_period_s, "between two kept pictures [s]")
      ->check(CLI::Range(0.05, 3600.0))
      ->capture_default_str();
  app.add_option("--until", config.until, "end by itself: mission-end, script-done")
      ->transform(CLI::CheckedTransformer(kEnds));
  app.add_option("--seconds", config.seconds, "end after so long at the latest [s]")
      ->check(CLI::Range(0.1, 1e6));
  app.add_flag("--plain", config.plain, "print lines instead of one live line");
}

}  // namespace eod::recorder
