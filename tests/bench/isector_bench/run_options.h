#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace eod::bench {

/// What the command line decides.
struct RunOptions {
  std::vector<int64_t> triangles = {10000, 100000, 1000000, 10000000};
  std::vector<std::string> engines;  ///< empty: all
  int rounds = 15;
  int frames = 2000;
};

/// Registers all of them. Values go to `options`, which must outlive the parsing.
void AddRunOptions(CLI::App& app, RunOptions& options);

}  // namespace eod::bench
