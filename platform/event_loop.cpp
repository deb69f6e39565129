#include "platform/event_loop.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/eventfd.h>
#include <sys/timerfd.h>

namespace eod {
namespace {

constexpr std::array kEndSignals{SIGINT, SIGTERM, SIGHUP};
constexpr size_t kFirstSource = 2;  // polled_[0] signals, polled_[1] timer

// Where the signal handler reports to. A handler can reach nothing but static state; unlike
// signalfd it needs no thread of the program to block the signals.
std::atomic<int> end_signal_descriptor{-1};

void ReportEndSignal(int /*signal*/) {
  const int former_errno = errno;
  const uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(end_signal_descriptor.load(), &one, sizeof one);
  errno = former_errno;
}

FileDescriptor RequireOpen(int number, const char* what) {
  if (number < 0) throw std::system_error(errno, std::generic_category(), what);
  return FileDescriptor(number);
}

timespec ToTimespec(Duration duration) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(duration);
  return {.tv_sec = seconds.count(), .tv_nsec = (duration - seconds).count()};
}

}  // namespace

EventLoop::EventLoop(const Clock& clock)
    : clock_(clock),
      signal_descriptor_(RequireOpen(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC), "eventfd")),
      timer_descriptor_(RequireOpen(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC),
                                    "timerfd_create")) {
  end_signal_descriptor = signal_descriptor_.get();
  struct sigaction action {};
  action.sa_handler = ReportEndSignal;
  action.sa_flags = SA_RESTART;
  for (size_t i = 0; i < kEndSignals.size(); ++i) {
    ::sigaction(kEndSignals[i], &action, &former_actions_[i]);
  }
}

EventLoop::~EventLoop() {
  for (size_t i = 0; i < kEndSignals.size(); ++i) {
    ::sigaction(kEndSignals[i], &former_actions_[i], nullptr);
  }
  end_signal_descriptor = -1;
}

void EventLoop::AddDescriptor(int descriptor, std::function<void()> on_readable) {
  sources_.push_back({descriptor, std::move(on_readable)});
}

void EventLoop::RemoveDescriptor(int descriptor) {
  // Only marked: the callback that asks may be the one that is removed.
  for (Source& source : sources_) {
    if (source.descriptor == descriptor) source.descriptor = -1;
  }
}

void EventLoop::AddTimer(Duration period, std::function<void(TimePoint scheduled)> on_tick) {
  assert(period > Duration::zero());
  timers_.push_back({period, std::move(on_tick), TimePoint{}});
}

void EventLoop::Run() {
  stopping_ = false;
  const TimePoint start = clock_.Now();
  for (Timer& timer : timers_) timer.due = start + timer.period;
  while (!stopping_) {
    WaitForEvents();
    if ((polled_[0].revents & POLLIN) != 0) break;
    RunReadableSources();
    if (!stopping_) RunDueTimers();
  }
}

void EventLoop::WaitForEvents() {
  ArmTimer();
  polled_.assign({{signal_descriptor_.get(), POLLIN, 0}, {timer_descriptor_.get(), POLLIN, 0}});
  for (const Source& source : sources_) polled_.push_back({source.descriptor, POLLIN, 0});
  if (::ppoll(polled_.data(), polled_.size(), nullptr, nullptr) < 0) {
    // Interrupted: nothing is known to be readable; the next round sees what the signal reported.
    for (pollfd& entry : polled_) entry.revents = 0;
  }
}

void EventLoop::ArmTimer() {
  if (timers_.empty()) return;
  const TimePoint due = std::ranges::min(timers_, {}, &Timer::due).due;
  const bool has_expired = polled_.size() > 1 && (polled_[1].revents & POLLIN) != 0;
  if (due == armed_for_ && !has_expired) return;
  // A time of zero would disarm it.
  const Duration wait = std::max(due - clock_.Now(), Duration{1});
  const itimerspec setting{.it_interval = {}, .it_value = ToTimespec(wait)};
  ::timerfd_settime(timer_descriptor_.get(), 0, &setting, nullptr);
  armed_for_ = due;
}

void EventLoop::RunReadableSources() {
  for (size_t i = 0; i < sources_.size() && !stopping_; ++i) {
    const short events = polled_[kFirstSource + i].revents;
    if ((events & POLLNVAL) != 0) {
      sources_[i].descriptor = -1;
    } else if (events != 0 && sources_[i].descriptor >= 0) {
      sources_[i].on_readable();
    }
  }
}

void EventLoop::RunDueTimers() {
  const TimePoint now = clock_.Now();
  for (Timer& timer : timers_) {
    if (now < timer.due || stopping_) continue;
    const auto missed = (now - timer.due) / timer.period;
    const TimePoint scheduled = timer.due + missed * timer.period;
    missed_ticks_ += static_cast<uint64_t>(missed);
    timer.due = scheduled + timer.period;
    timer.on_tick(scheduled);
  }
}

}  // namespace eod
