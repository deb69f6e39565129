#include "tests/bench/isector_bench/size_run.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/bench/isector_bench/workload.h"

namespace eod::bench {

namespace {

constexpr int64_t kBruteForce = 10000;  // triangles up to which the reference is checked
constexpr size_t kBruteForceStride = 23;

/// The lines of all drives, and what they truly meet.
struct Task {
  std::vector<sim::SegmentQuery> short_lines, sight_lines, aimed_lines;
  std::vector<reference::Nearest> short_truth, sight_truth, aimed_truth;

  Drive Short() const { return {short_lines, kLinesPerFrame, kLinesPerFrame}; }
  Drive Legs() const { return {short_lines, kLinesPerFrame, kLegs}; }
  Drive Sight() const { return {sight_lines, kSightLinesPerFrame, kSightLinesPerFrame}; }
  Drive Aimed() const { return {aimed_lines, kAimedLinesPerFrame, kAimedLinesPerFrame}; }
};

int CheckByBruteForce(const Scene& scene, std::span<const sim::SegmentQuery> lines,
                      std::span<const reference::Nearest> truth) {
  int checked = 0;
  for (size_t i = 0; i < lines.size(); i += kBruteForceStride) {
    const reference::Nearest slow = reference::TryEveryTriangle(scene.module.triangles, lines[i]);
    if (slow.triangle != truth[i].triangle || slow.range != truth[i].range)
      throw std::logic_error("the reference is wrong: brute force differs");
    ++checked;
  }
  return checked;
}

Task MakeTask(const Scene& scene, int frames, SizeResult& result) {
  const std::vector<RobotPose> path = DrivePath(frames);
  Task task{ShortLines(path), SightLines(path), AimedLines(scene, path), {}, {}, {}};
  const reference::DoubleTree tree(scene.module.triangles);
  task.short_truth = TrueAnswers(tree, task.Short());
  task.sight_truth = TrueAnswers(tree, task.Sight());
  task.aimed_truth = TrueAnswers(tree, task.Aimed());
  result.short_hits = HitShare(task.Short(), task.short_truth, 0, kLinesPerFrame);
  result.leg_hits = HitShare(task.Short(), task.short_truth, 0, kLegs);
  result.bump_hits = HitShare(task.Short(), task.short_truth, kLegs, kLinesPerFrame - kLegs);
  result.sight_hits = HitShare(task.Sight(), task.sight_truth, 0, kSightLinesPerFrame);
  if (result.triangles <= kBruteForce) {
    result.tried_by_brute_force = CheckByBruteForce(scene, task.short_lines, task.short_truth) +
                                  CheckByBruteForce(scene, task.sight_lines, task.sight_truth) +
                                  CheckByBruteForce(scene, task.aimed_lines, task.aimed_truth);
  }
  return task;
}

Outcome Expect(const EngineSpec& spec, const RunOptions& options, int64_t triangles) {
  const std::vector<std::string>& asked = options.engines;
  if (!asked.empty() && std::find(asked.begin(), asked.end(), spec.name) == asked.end())
    return Outcome::kNotAskedFor;
  if (spec.build == nullptr) return Outcome::kNotInstalled;
  return triangles > spec.most_triangles ? Outcome::kTooLarge : Outcome::kMeasured;
}

void JudgeAll(Engine& engine, const Task& task, EngineResult& result) {
  if (result.spec.legs_only) {
    result.on_path = Judge(task.Legs(), Answers(engine, task.Legs()), task.short_truth);
    return;
  }
  result.on_path = Judge(task.Short(), Answers(engine, task.Short()), task.short_truth);
  result.at_edges = Judge(task.Aimed(), Answers(engine, task.Aimed()), task.aimed_truth);
  result.in_sight = Judge(task.Sight(), Answers(engine, task.Sight()), task.sight_truth);
}

/// An engine that is there, and where its numbers go.
struct Runner {
  std::unique_ptr<Engine> engine;
  EngineResult* result;
};

/// Whose turn it is. Every engine comes first at times, and every other round runs backwards, so
/// that an engine does not always find the caches as the same one left them.
size_t Turn(size_t round, size_t i, size_t count) {
  return (round + (round % 2 == 0 ? i : count - 1 - i)) % count;
}

void TimeAll(std::span<const Runner> runners, const Task& task, int rounds) {
  for (size_t round = 0; round < static_cast<size_t>(rounds); ++round) {
    for (size_t i = 0; i < runners.size(); ++i) {
      const auto& [engine, result] = runners[Turn(round, i, runners.size())];
      TimeRound(*engine, result->spec.legs_only ? task.Legs() : task.Short(), result->short_lines);
    }
    for (size_t i = 0; i < runners.size(); ++i) {
      const auto& [engine, result] = runners[Turn(round, i, runners.size())];
      if (!result->spec.legs_only) TimeRound(*engine, task.Sight(), result->sight_lines);
    }
  }
}

/// What a library allocates once and for all belongs to no scene.
void WarmUp(const EngineSpec& spec) {
  static const Scene small = MakeScene(kBruteForce);
  static const IndexedMesh mesh = MakeIndexed(small.module.triangles);
  Build(spec, {small, mesh});
}

}  // namespace

SizeResult RunSize(const RunOptions& options, int64_t triangles) {
  std::cerr << fmt::format("{} triangles: scene and reference ...\n", triangles);
  const Scene scene = MakeScene(triangles);
  SizeResult result;
  result.triangles = static_cast<int64_t>(scene.module.triangles.size());
  result.terrain_density = scene.terrain_density;
  result.path_density = DensityNearPath(scene);
  result.terrain_size = scene.terrain_size;
  const Task task = MakeTask(scene, options.frames, result);
  const IndexedMesh mesh = MakeIndexed(scene.module.triangles);

  for (const EngineSpec& spec : KnownEngines()) {
    EngineResult& engine = result.engines.emplace_back();
    engine.spec = spec;
    engine.outcome = Expect(spec, options, triangles);
  }
  std::vector<Runner> runners;
  for (EngineResult& engine : result.engines) {
    if (engine.outcome != Outcome::kMeasured) continue;
    std::cerr << fmt::format("{} triangles: {} ...\n", triangles, engine.spec.name);
    WarmUp(engine.spec);
    Built built = Build(engine.spec, {scene, mesh});
    engine.build_s = built.seconds;
    engine.bytes = built.bytes;
    JudgeAll(*built.engine, task, engine);
    runners.push_back({std::move(built.engine), &engine});
  }
  std::cerr << fmt::format("{} triangles: {} rounds ...\n", triangles, options.rounds);
  TimeAll(runners, task, options.rounds);
  return result;
}

}  // namespace eod::bench
