#include <algorithm>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tests/bench/isector_bench/report.h"
#include "tests/bench/isector_bench/run_options.h"

using namespace eod::bench;

namespace {

bool IsRight(const SizeResult& result) {
  return std::all_of(result.engines.begin(), result.engines.end(), [](const EngineResult& engine) {
    return !engine.spec.package.empty() || engine.missed() + engine.extra() == 0;
  });
}

/// 0 if the product's answers were all right.
int Run(const RunOptions& options, const std::string& json_file) {
  // With the JSON on standard output, the tables are for the terminal.
  std::ostream& text = json_file == "-" ? std::cerr : std::cout;
  text << Introduction(ThisMachine(), options);
  std::vector<SizeResult> results;
  for (const int64_t triangles : options.triangles) {
    results.push_back(RunSize(options, triangles));
    text << Tables(results.back()) << std::flush;
  }
  if (json_file == "-") std::cout << ToJson(results).dump(2) << "\n";
  if (!json_file.empty() && json_file != "-") {
    std::ofstream(json_file) << ToJson(results).dump(2) << "\n";
  }
  return std::all_of(results.begin(), results.end(), IsRight) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times the isector engine beside others. Status 1: ours missed or added a hit."};
  RunOptions options;
  std::string json_file;
  AddRunOptions(app, options);
  app.add_option("--json", json_file, "write the results to this file; - is standard output");
  CLI11_PARSE(app, argc, argv);
  try {
    return Run(options, json_file);
  } catch (const std::exception& error) {
    std::cerr << "isector_bench: " << error.what() << "\n";
    return 2;
  }
}
