#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace eod::claims {

/// What the command line decides.
struct ClaimOptions {
  std::string json_file = "paper_claims.json";
  std::vector<int64_t> triangles = {10000, 30000, 100000, 300000, 1000000};
  int rounds = 15;
  int frames = 2000;
  int starts = 500;
  int mask_frames = 40;
};

/// Registers all of them. Values go to `options`, which must outlive the parsing.
void AddClaimOptions(CLI::App& app, ClaimOptions& options);

}  // namespace eod::claims
