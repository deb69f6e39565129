#include "tests/bench/isector_bench/run_options.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "tests/bench/isector_bench/engine.h"

namespace eod::bench {

void AddRunOptions(CLI::App& app, RunOptions& options) {
  std::vector<std::string> names;
  for (const EngineSpec& spec : KnownEngines()) names.push_back(spec.name);
  app.add_option("--triangles", options.triangles, "sizes of the scenes")
      ->delimiter(',')
      ->check(CLI::Range(10000, 100000000))
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "rounds of each engine")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--frames", options.frames, "frames of the drive; 2000 are once round")
      ->check(CLI::Range(100, 100000))
      ->capture_default_str();
  app.add_option("--engines", options.engines, "only these; all, if not given")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
}

}  // namespace eod::bench
