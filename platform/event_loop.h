#pragma once

#include <array>
#include <functional>
#include <vector>

#include <poll.h>
#include <signal.h>

#include "platform/clock.h"
#include "platform/file_descriptor.h"
#include "platform/time.h"

namespace eod {

/// One poll over descriptors, periodic timers and the end signals (SIGINT, SIGTERM, SIGHUP).
/// Single-threaded; callbacks run in the order: descriptors as added, then timers as added.
/// While a loop exists, an end signal ends its `Run` instead of the program; a process has one
/// loop at a time.
class EventLoop {
 public:
  explicit EventLoop(const Clock& clock);
  ~EventLoop();
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// Calls `on_readable` whenever `descriptor` has something to read, an error to fetch, or an end.
  /// The caller keeps it open; a closed or negative one is not watched.
  void AddDescriptor(int descriptor, std::function<void()> on_readable);

  /// Watches `descriptor` no more. May be called from a callback.
  void RemoveDescriptor(int descriptor);

  /// Calls `on_tick(scheduled)` every `period`, first one period from the start of `Run`.
  /// `scheduled` is the moment the tick was due, an exact multiple. Missed ticks are not caught up
  /// in a burst: they are counted in `missed_ticks` and the schedule goes on at the next multiple.
  void AddTimer(Duration period, std::function<void(TimePoint scheduled)> on_tick);

  /// Runs until `Stop` or an end signal. Descriptors and timers are added before.
  void Run();

  /// May be called from a callback.
  void Stop() { stopping_ = true; }

  uint64_t missed_ticks() const { return missed_ticks_; }

 private:
  struct Source {
    int descriptor;
    std::function<void()> on_readable;
  };
  struct Timer {
    Duration period;
    std::function<void(TimePoint)> on_tick;
    TimePoint due;
  };
  void WaitForEvents();
  void ArmTimer();
  void RunReadableSources();
  void RunDueTimers();

  const Clock& clock_;
  std::vector<Source> sources_;
  std::vector<Timer> timers_;
  std::vector<pollfd> polled_;  ///< signals, timer, then sources_ one to one
  FileDescriptor signal_descriptor_;
  FileDescriptor timer_descriptor_;
  std::array<struct sigaction, 3> former_actions_{};
  TimePoint armed_for_{};
  uint64_t missed_ticks_ = 0;
  bool stopping_ = false;
};

}  // namespace eod
