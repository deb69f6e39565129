#include "programs/batch_display.h"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "batch/progress_line.h"
#include "platform/event_loop.h"
#include "platform/terminal.h"

namespace eod::batch {
namespace {

constexpr Duration kLook = std::chrono::milliseconds(100);
constexpr Duration kLinePeriod = std::chrono::seconds(10);  // where it is no terminal

/// The line that is written over on a terminal, or one now and then.
class ProgressPrinter {
 public:
  ProgressPrinter(BatchRun& run, TimePoint start)
      : run_(run), start_(start), next_line_(start + kLinePeriod) {}

  void Print(TimePoint now, bool is_last) {
    const int columns = TerminalColumns();
    const char* wipe = columns > 0 ? "\r\033[K" : "";
    for (const std::string& news : run_.TakeNews()) fmt::print("{}{}\n", wipe, news);
    if (columns == 0 && now < next_line_ && !is_last) return;
    next_line_ = now + kLinePeriod;
    fmt::print("{}{}{}", wipe, ProgressLine(run_.progress(), now - start_, columns),
               columns == 0 || is_last ? "\n" : "");
    std::fflush(stdout);
  }

 private:
  BatchRun& run_;
  TimePoint start_;
  TimePoint next_line_;
};

}  // namespace

void Display(BatchRun& run, int jobs) {
  const SteadyClock clock;
  EventLoop loop(clock);  // before the threads: from now on a signal ends it, not the program
  ProgressPrinter printer(run, clock.Now());
  run.Start(jobs);
  loop.AddTimer(kLook, [&](TimePoint) {
    if (run.is_finished()) return loop.Stop();
    printer.Print(clock.Now(), false);
  });
  loop.Run();
  const bool is_interrupted = !run.is_finished();
  if (is_interrupted) run.Stop();
  run.Join();
  printer.Print(clock.Now(), true);
  const BatchProgress progress = run.progress();
  if (is_interrupted && progress.done() < progress.planned) {
    throw std::runtime_error(
        fmt::format("interrupted: {} of {} runs are done and kept; the same command goes on",
                    progress.done(), progress.planned));
  }
}

}  // namespace eod::batch
