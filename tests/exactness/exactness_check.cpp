// Proves the engine's answers exact: as many seeded segments as asked for, against a reference that
// tries every triangle.
#include <atomic>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/exactness/scene_check.h"

int main(int argc, char** argv) {
  using eod::sim::Verdict;
  constexpr uint64_t kPerScene = 2000;
  uint64_t segments = 1000000, seed = 1;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  CLI::App app{
      "Casts tricky segments in tricky scenes and compares every answer with a reference."};
  app.add_option("--segments", segments, "how many")->capture_default_str();
  app.add_option("--seed", seed, "of the first scene; each next one is one more")
      ->capture_default_str();
  app.add_option("--jobs", jobs, "threads")->capture_default_str()->check(CLI::Range(1, 1024));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  const uint64_t scenes = (segments + kPerScene - 1) / kPerScene;
  std::atomic<uint64_t> next{0};
  std::mutex mutex;
  Verdict all;
  const auto work = [&] {
    for (uint64_t scene = next++; scene < scenes; scene = next++) {
      const Verdict verdict = eod::sim::CheckScene(seed + scene, kPerScene);
      const std::scoped_lock lock(mutex);
      all.Add(verdict);
      if (!verdict.ok()) {
        std::cout << fmt::format("scene {}: missed {}, extra {}, different {}, error {:.3g} m\n",
                                 seed + scene, verdict.missed, verdict.extra, verdict.different,
                                 verdict.worst_error);
      }
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < jobs; ++i) threads.emplace_back(work);
  threads.clear();
  std::cout << fmt::format(
      "{} segments in {} scenes, {} of them hit, {} are none: {} missed, {} extra, {} different "
      "between "
      "instruction sets, worst error {:.3g} um\n",
      all.segments, scenes, all.hits, all.refused, all.missed, all.extra, all.different,
      all.worst_error * 1e6);
  return all.ok() && all.hits > all.segments / 4 ? 0 : 1;
}
