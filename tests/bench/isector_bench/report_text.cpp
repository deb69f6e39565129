#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "tests/bench/isector_bench/report.h"
#include "tests/bench/isector_bench/workload.h"

namespace eod::bench {

namespace {

/// Best time of the product on a drive [us a frame, by line]; 0 if it was not asked.
double OursBest(const SizeResult& result, DriveTimes EngineResult::*drive) {
  for (const EngineResult& engine : result.engines) {
    const DriveTimes& times = engine.*drive;
    if (engine.spec.name == "ours" && !times.round_us.empty())
      return times.ns_per_line(times.best_us());
  }
  return 0;
}

std::string Times(double peer, double ours) {
  return ours > 0 ? fmt::format("{:.2f}", peer / ours) : "-";
}

std::string WhyNot(const EngineResult& engine) {
  switch (engine.outcome) {
    case Outcome::kNotInstalled:
      return fmt::format("not installed ({})", engine.spec.package);
    case Outcome::kTooLarge:
      return fmt::format("skipped beyond {} triangles", engine.spec.most_triangles);
    default:
      return "not asked for";
  }
}

std::string Megabytes(int64_t bytes) {
  return fmt::format("{:.1f}", static_cast<double>(bytes) / 1e6);
}

std::string ShortLineTable(const SizeResult& result) {
  std::string text =
      fmt::format("{:<15}{:>9}{:>8}{:>8}{:>10}{:>8}{:>9}{:>13}{:>9}{:>9}\n", "", "ns/line", "",
                  "times", "us/frame", "", "worst", "worst,", "build", "memory");
  text +=
      fmt::format("{:<15}{:>9}{:>8}{:>8}{:>10}{:>8}{:>9}{:>13}{:>9}{:>9}\n", "short lines", "best",
                  "median", "ours", "best", "median", "frame", "undisturbed", "s", "MB");
  const double ours = OursBest(result, &EngineResult::short_lines);
  for (const EngineResult& engine : result.engines) {
    if (engine.outcome != Outcome::kMeasured) {
      text += fmt::format("{:<15}  {}\n", engine.spec.name, WhyNot(engine));
      continue;
    }
    const DriveTimes& times = engine.short_lines;
    const double best = times.ns_per_line(times.best_us());
    text += fmt::format(
        "{:<15}{:>9.1f}{:>8.1f}{:>8}{:>10.2f}{:>8.2f}{:>9.1f}{:>13.1f}{:>9.3f}{:>9}{}\n",
        engine.spec.name, best, times.ns_per_line(times.median_us()), Times(best, ours),
        times.best_us(), times.median_us(), times.worst_frame_us, times.worst_undisturbed_us(),
        engine.build_s, Megabytes(engine.bytes),
        engine.spec.legs_only ? "  (3 TRIPOD lines a frame)" : "");
  }
  return text;
}

std::string Wrong(const Verdict& verdict) {
  return fmt::format("{} / {}", verdict.missed, verdict.extra);
}

/// Lines of sight, and what every engine got wrong.
std::string SightAndVerdictTable(const SizeResult& result) {
  std::string text =
      fmt::format("{:<15}{:>10}{:>10}{:>8}{:>12}{:>11}{:>17}{:>14}{:>14}\n", "", "ns/line", "",
                  "times", "wrong on", "wrong at", "wrong in", "worst short", "worst sight");
  text += fmt::format("{:<15}{:>10}{:>10}{:>8}{:>12}{:>11}{:>17}{:>14}{:>14}\n", "lines of sight",
                      "best", "median", "ours", "the path", "edges", "lines of sight", "error um",
                      "error um");
  const double ours = OursBest(result, &EngineResult::sight_lines);
  for (const EngineResult& engine : result.engines) {
    if (engine.outcome != Outcome::kMeasured) continue;
    const DriveTimes& times = engine.sight_lines;
    if (times.round_us.empty()) {
      text += fmt::format("{:<15}{:>10}{:>10}{:>8}{:>12}{:>11}{:>17}{:>14.1f}{:>14}\n",
                          engine.spec.name, "-", "-", "-", Wrong(engine.on_path), "-", "-",
                          engine.on_path.worst_error_um, "-");
      continue;
    }
    const double best = times.ns_per_line(times.best_us());
    text +=
        fmt::format("{:<15}{:>10.1f}{:>10.1f}{:>8}{:>12}{:>11}{:>17}{:>14.1f}{:>14.1f}\n",
                    engine.spec.name, best, times.ns_per_line(times.median_us()), Times(best, ours),
                    Wrong(engine.on_path), Wrong(engine.at_edges), Wrong(engine.in_sight),
                    std::max(engine.on_path.worst_error_um, engine.at_edges.worst_error_um),
                    engine.in_sight.worst_error_um);
  }
  return text;
}

}  // namespace

std::string Introduction(const Machine& machine, const RunOptions& options) {
  return fmt::format(
      R"(Isector engines on one robot's drive
processor     {}; {}
compiler      {}
load average  {}
clock         a reading takes {:.0f} ns; one a frame, part of all times

{} frames at {:.0f} Hz and {:.2f} m/s, 1.7 km from the origin. A frame: 3 TRIPOD lines of 2 m and 10
BUMPs of six 0.3 m lines; apart from them 8 lines of sight of 200 m. {} rounds, the engines in turn
in one process and one thread. "undisturbed": the slowest frame by its best round; "worst" has the
machine's interruptions in it. Memory: growth of what the process holds (RssAnon), input apart.
Wrong answers: missed / extra against a reference in double, on the path, on {} lines aimed at
edges and corners, and in lines of sight; more than 10 mm off counts as wrong.
Bullet in double precision; Embree and OpenSceneGraph in single, counted from the scene's middle;
Embree with flush-to-zero, built by one thread.
)",
      machine.processor, machine.instruction_sets, machine.compiler, machine.load, ClockCost(),
      options.frames, kFrameRate, kSpeed, options.rounds, kAimedLines);
}

std::string Tables(const SizeResult& result) {
  std::string text = fmt::format(
      "\n{} triangles: terrain of {:.0f} m x {:.0f} m with {:.0f} triangles a m2; {:.0f} a m2 near "
      "the path\n"
      "hits: {:.1f} % of the short lines (TRIPOD {:.1f} %, BUMP {:.1f} %), {:.1f} % of the lines "
      "of "
      "sight\n",
      result.triangles, result.terrain_size.x(), result.terrain_size.y(), result.terrain_density,
      result.path_density, 100 * result.short_hits, 100 * result.leg_hits, 100 * result.bump_hits,
      100 * result.sight_hits);
  if (result.tried_by_brute_force > 0) {
    text += fmt::format("reference: the same as brute force on {} lines of these\n",
                        result.tried_by_brute_force);
  }
  return text + "\n" + ShortLineTable(result) + "\n" + SightAndVerdictTable(result);
}

}  // namespace eod::bench
