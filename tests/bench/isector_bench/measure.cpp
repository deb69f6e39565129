#include "tests/bench/isector_bench/measure.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

#include <malloc.h>

namespace eod::bench {

namespace {

using Clock = std::chrono::steady_clock;

double Microseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::micro>(duration).count();
}

}  // namespace

double DriveTimes::best_us() const { return *std::min_element(round_us.begin(), round_us.end()); }

double DriveTimes::median_us() const {
  std::vector<double> sorted = round_us;
  std::sort(sorted.begin(), sorted.end());
  const size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

double DriveTimes::worst_undisturbed_us() const {
  return *std::max_element(frame_us.begin(), frame_us.end());
}

void TimeRound(Engine& engine, const Drive& drive, DriveTimes& times) {
  std::vector<sim::SegmentHit> hits(static_cast<size_t>(drive.cast));
  const size_t frames = drive.frames();
  times.cast = drive.cast;
  times.frame_us.resize(frames, 1e9);
  const Clock::time_point begin = Clock::now();
  Clock::time_point last = begin;
  for (size_t frame = 0; frame < frames; ++frame) {
    engine.Cast(drive.lines.subspan(frame * static_cast<size_t>(drive.per_frame), hits.size()),
                hits);
    const Clock::time_point now = Clock::now();
    const double took = Microseconds(now - last);
    last = now;
    times.frame_us[frame] = std::min(times.frame_us[frame], took);
    times.worst_frame_us = std::max(times.worst_frame_us, took);
  }
  times.round_us.push_back(Microseconds(last - begin) / static_cast<double>(frames));
}

std::vector<sim::SegmentHit> Answers(Engine& engine, const Drive& drive) {
  std::vector<sim::SegmentHit> hits(drive.lines.size());
  const auto cast = static_cast<size_t>(drive.cast), step = static_cast<size_t>(drive.per_frame);
  for (size_t first = 0; first < drive.frames() * step; first += step)
    engine.Cast(drive.lines.subspan(first, cast), std::span(hits).subspan(first, cast));
  return hits;
}

double ClockCost() {
  constexpr int kReads = 100000;
  const Clock::time_point begin = Clock::now();
  Clock::time_point last = begin;
  for (int i = 0; i < kReads; ++i) last = Clock::now();
  return Microseconds(last - begin) * 1000 / kReads;
}

int64_t HeldMemory() {
  malloc_trim(0);
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    int64_t kilobytes = 0;
    if (word == "RssAnon:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

Built Build(const EngineSpec& spec, const Source& source) {
  Built built;
  const int64_t before = HeldMemory();
  const Clock::time_point begin = Clock::now();
  built.engine = spec.build(source);
  built.seconds = Microseconds(Clock::now() - begin) * 1e-6;
  built.bytes = HeldMemory() - before;
  return built;
}

}  // namespace eod::bench
