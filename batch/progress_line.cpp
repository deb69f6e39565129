#include "batch/progress_line.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eod::batch {
namespace {

constexpr size_t kBar = 24;  // [columns]

std::string Bar(const BatchProgress& progress) {
  const size_t full = progress.planned == 0 ? kBar : progress.done() * kBar / progress.planned;
  return fmt::format("[{:<{}}] ", std::string(full, '='), kBar);
}

std::string TimeLeft(const BatchProgress& progress, double elapsed_s) {
  const size_t left = progress.planned - progress.done();
  if (left == 0 || progress.driven == 0) return "";
  const auto seconds = static_cast<long>(
      std::ceil(elapsed_s * static_cast<double>(left) / static_cast<double>(progress.driven)));
  if (seconds < 3600) return fmt::format(", {}:{:02} left", seconds / 60, seconds % 60);
  return fmt::format(", {}:{:02}:{:02} left", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace

std::string ProgressLine(const BatchProgress& progress, Duration elapsed, int columns) {
  const double elapsed_s = ToSeconds(elapsed);
  std::string line = columns > 0 ? Bar(progress) : "";
  line += fmt::format("{} of {} runs", progress.done(), progress.planned);
  if (progress.found > 0) line += fmt::format(" ({} found done)", progress.found);
  if (progress.unexpected > 0) line += fmt::format(", {} not as expected", progress.unexpected);
  if (progress.driven > 0 && elapsed_s > 0) {
    line += fmt::format(", {:.0f} times real time", progress.simulated_s / elapsed_s);
  }
  line += TimeLeft(progress, elapsed_s);
  if (columns > 0) line.resize(std::min(line.size(), static_cast<size_t>(columns)));
  return line;
}

}  // namespace eod::batch
