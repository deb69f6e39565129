#include "tests/bench/paper_claims/claim_options.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

namespace eod::claims {

void AddClaimOptions(CLI::App& app, ClaimOptions& options) {
  app.add_option("--json", options.json_file, "file to write")->capture_default_str();
  app.add_option("--triangles", options.triangles, "sizes of the scenes")
      ->delimiter(',')
      ->check(CLI::Range(10000, 100000000))
      ->capture_default_str();
  const auto add_count = [&](const char* name, int& count, int least, const char* what) {
    app.add_option(name, count, what)->check(CLI::Range(least, 100000))->capture_default_str();
  };
  add_count("--rounds", options.rounds, 0, "rounds of timing in each scene; 0: no times");
  add_count("--frames", options.frames, 100, "frames of the drive through a scene");
  add_count("--starts", options.starts, 1, "starts towards the wall at each speed");
  add_count("--mask-frames", options.mask_frames, 2, "frames of the drive in five modules");
}

}  // namespace eod::claims
