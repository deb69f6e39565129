#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

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
  const bool json_to_stdout = json_file == "-";
  std::ostream& text = json_to_stdout ? std::cerr : std::cout;
  std::ofstream file;
  if (!json_file.empty() && !json_to_stdout) file.open(json_file);
  if (!file) throw std::runtime_error(json_file + " cannot be written");
  text << Introduction(ThisMachine(), options);
  std::vector<SizeResult> results;
  for (const int64_t triangles : options.triangles) {
    results.push_back(RunSize(options, triangles));
    text << Tables(results.back()) << std::flush;
  }
  if (!json_file.empty())
    (json_to_stdout ? std::cout : file) << ToJson(results).dump(2) << std::endl;
  if (!file) throw std::runtime_error(json_file + " could not be written");
  return std::all_of(results.begin(), results.end(), IsRight) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times the isector engine beside others. Status 1: ours missed or added a hit."};
  RunOptions options;
  std::string json_file;
  AddRunOptions(app, options);
  app.add_option("--json", json_file, "write the results to this file; - is standard output");
  try {
    app.parse(argc, argv);
    return Run(options, json_file);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "isector_bench: " << error.what() << "\n";
    return 2;
  }
}
