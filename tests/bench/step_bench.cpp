#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "tests/scenario/recorded_commands.h"

namespace {

using eod::lockstep::CommandedStep;
using eod::lockstep::kData;
using eod::lockstep::ShippedData;

constexpr int kRounds = 15;

using Times = std::vector<double>;  // [us] of each step

/// The mission again, in a simulator of its own.
Times TimeSteps(const std::vector<CommandedStep>& steps, const eod::sim::Scenario& scenario) {
  eod::sim::SimulatorConfig config;
  config.exercise = ShippedData().rules;
  eod::sim::Simulator simulator(ShippedData().robot, ShippedData().world, scenario, config);
  Times times;
  times.reserve(steps.size());
  for (const CommandedStep& step : steps) {
    const auto start = std::chrono::steady_clock::now();
    simulator.Step(step.now, step.command);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    times.push_back(took.count());
  }
  return times;
}

void Print(std::string_view what, Times times) {
  double sum = 0;
  for (const double time : times) sum += time;
  std::sort(times.begin(), times.end());
  const auto share = [&](double part) {
    return times[static_cast<size_t>(part * static_cast<double>(times.size() - 1))];
  };
  fmt::print("{:24}{:8.1f}{:8.1f}{:8.1f}{:8.1f}{:8.1f}\n", what,
             sum / static_cast<double>(times.size()), share(0.5), share(0.99), share(0.999),
             times.back());
}

/// All rounds of one mission. The rounds do the same step by step, so the least time of a step is
/// what it takes, and what is above that is the computer's other work.
void Measure(const char* title, const char* script, const char* scenario_name, int rounds) {
  const eod::sim::Scenario scenario = eod::lockstep::ShippedScenario(scenario_name);
  const auto steps = eod::lockstep::RecordCommands(
      eod::box::LoadScript(kData / "firmware_emu/scripts" / script), scenario);
  Times least = TimeSteps(steps, scenario);
  Times all = least;
  for (int round = 1; round < rounds; ++round) {
    const Times times = TimeSteps(steps, scenario);
    all.insert(all.end(), times.begin(), times.end());
    for (size_t i = 0; i < times.size(); ++i) least[i] = std::min(least[i], times[i]);
  }
  const auto slowest = std::max_element(least.begin(), least.end()) - least.begin();
  fmt::print("{}: {} steps, {} rounds, slowest step {}\n", title, steps.size(), rounds,
             slowest + 1);
  Print("  every step", std::move(all));
  Print("  least of the rounds", std::move(least));
}

int Rounds(int argc, char** argv) {
  if (argc < 2) return kRounds;
  const std::string_view text = argv[1];
  int rounds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rounds);
  if (argc > 2 || error != std::errc{} || end != text.data() + text.size() || rounds < 1) {
    throw std::runtime_error("usage: step_bench [ROUNDS]");
  }
  return rounds;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int rounds = Rounds(argc, argv);
    fmt::print("{:24}{:>8}{:>8}{:>8}{:>8}{:>8}\n", "[us of wall clock]", "mean", "p50", "p99",
               "p99.9", "max");
    Measure("first drive", "first_drive.boxscript", "flat_first_drive", rounds);
    Measure("charge into the can", "bomb_ground.boxscript", "bomb_ground_m", rounds);
    Measure("charge dropped", "bomb_dropped.boxscript", "bomb_ground_m", rounds);
  } catch (const std::exception& error) {
    fmt::print(stderr, "step_bench: {}\n", error.what());
    return 2;
  }
  return 0;
}
