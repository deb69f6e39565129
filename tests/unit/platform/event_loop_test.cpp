#include "platform/event_loop.h"

#include <array>
#include <chrono>
#include <vector>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace eod {
namespace {

using std::chrono::milliseconds;

/// Time that jumps by a step of its own each time it is looked at: no test waits for it.
class JumpingClock final : public Clock {
 public:
  explicit JumpingClock(Duration step) : step_(step) {}
  TimePoint Now() const override { return now_ += step_; }

 private:
  Duration step_;
  mutable TimePoint now_{};
};

/// A descriptor that is readable from the start.
class ReadableDescriptor {
 public:
  int get() const { return descriptor_.get(); }
  void Drain() {
    uint64_t count = 0;
    ASSERT_EQ(::read(get(), &count, sizeof count), static_cast<ssize_t>(sizeof count));
  }

 private:
  FileDescriptor descriptor_{::eventfd(1, EFD_NONBLOCK)};
};

TEST(EventLoop, TicksAtExactMultiplesOfThePeriod) {
  const SteadyClock clock;
  EventLoop dut(clock);
  std::vector<TimePoint> scheduled;
  dut.AddTimer(milliseconds(1), [&](TimePoint due) {
    EXPECT_LE(due, clock.Now());
    scheduled.push_back(due);
    if (scheduled.size() == 20) dut.Stop();
  });
  dut.Run();
  ASSERT_EQ(scheduled.size(), 20U);
  Duration missed{};
  for (size_t i = 1; i < scheduled.size(); ++i) {
    const Duration gap = scheduled[i] - scheduled[i - 1];
    EXPECT_EQ(gap % milliseconds(1), Duration::zero());
    EXPECT_GT(gap, Duration::zero());
    missed += gap - milliseconds(1);
  }
  EXPECT_LE(missed / milliseconds(1), static_cast<int64_t>(dut.missed_ticks()));
}

TEST(EventLoop, CountsMissedTicksInsteadOfCatchingUp) {
  // Looked at once to start, once to arm and once to run timers, the clock jumps 3.5 periods each
  // time: at 7 periods after the start, ticks 1 to 6 are missed and tick 7 runs.
  const JumpingClock clock(std::chrono::microseconds(3500));
  EventLoop dut(clock);
  std::vector<TimePoint> scheduled;
  dut.AddTimer(milliseconds(1), [&](TimePoint due) {
    scheduled.push_back(due);
    dut.Stop();
  });
  dut.Run();
  const TimePoint start{std::chrono::microseconds(3500)};
  EXPECT_EQ(scheduled, std::vector<TimePoint>{start + milliseconds(7)});
  EXPECT_EQ(dut.missed_ticks(), 6U);
}

TEST(EventLoop, RunsDescriptorsAsAddedThenTimersAsAdded) {
  const JumpingClock clock(milliseconds(1));
  EventLoop dut(clock);
  ReadableDescriptor first;
  ReadableDescriptor second;
  std::string order;
  // Both timers are due in the first round, in which both descriptors are readable as well.
  dut.AddTimer(std::chrono::nanoseconds(1), [&](TimePoint) { order += 'c'; });
  dut.AddTimer(std::chrono::nanoseconds(2), [&](TimePoint) {
    order += 'd';
    dut.Stop();
  });
  dut.AddDescriptor(first.get(), [&] { order += 'a'; });
  dut.AddDescriptor(second.get(), [&] { order += 'b'; });
  dut.Run();
  EXPECT_EQ(order, "abcd");
}

TEST(EventLoop, CallsADescriptorAgainUntilItIsDrained) {
  const SteadyClock clock;
  EventLoop dut(clock);
  ReadableDescriptor source;
  int calls = 0;
  dut.AddDescriptor(source.get(), [&] {
    if (++calls == 3) {
      source.Drain();
      dut.Stop();
    }
  });
  dut.Run();
  EXPECT_EQ(calls, 3);
}

TEST(EventLoop, ReportsTheEndOfAPipeUntilItIsRemoved) {
  const SteadyClock clock;
  EventLoop dut(clock);
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const FileDescriptor read_end(ends[0]);
  ::close(ends[1]);
  int calls = 0;
  dut.AddDescriptor(read_end.get(), [&] {
    ++calls;
    dut.RemoveDescriptor(read_end.get());
  });
  dut.AddTimer(milliseconds(1), [&](TimePoint) { dut.Stop(); });
  dut.Run();
  EXPECT_EQ(calls, 1);
}

TEST(EventLoop, IgnoresNegativeAndClosedDescriptors) {
  const SteadyClock clock;
  EventLoop dut(clock);
  const int closed = ::eventfd(1, 0);
  ::close(closed);
  dut.AddDescriptor(-1, [] { FAIL(); });
  dut.AddDescriptor(closed, [] { FAIL(); });
  dut.AddTimer(milliseconds(1), [&](TimePoint) { dut.Stop(); });
  dut.Run();
}

class EventLoopEndSignal : public testing::TestWithParam<int> {};

TEST_P(EventLoopEndSignal, EndsTheRunAndNotTheProgram) {
  const SteadyClock clock;
  EventLoop dut(clock);
  dut.AddTimer(milliseconds(1), [](TimePoint) { ::raise(GetParam()); });
  dut.Run();
}

TEST_P(EventLoopEndSignal, EndsARunThatIsStillToCome) {
  const SteadyClock clock;
  EventLoop dut(clock);
  ::raise(GetParam());
  dut.Run();
}

TEST_P(EventLoopEndSignal, MeansTheSameAsBeforeOnceTheLoopIsGone) {
  const SteadyClock clock;
  EXPECT_EXIT(
      {
        { EventLoop dut(clock); }
        ::raise(GetParam());
      },
      testing::KilledBySignal(GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(Every, EventLoopEndSignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(SteadyClock, NeverGoesBack) {
  const SteadyClock dut;
  TimePoint before = dut.Now();
  for (int i = 0; i < 1000; ++i) {
    const TimePoint now = dut.Now();
    ASSERT_GE(now, before);
    before = now;
  }
}

TEST(SteadyClock, ShowsUnixTime) {
  // 2024-01-01; a machine whose clock says less has no time at all.
  EXPECT_GT(ToUtime(SteadyClock().Now()), 1'704'067'200'000'000);
}

}  // namespace
}  // namespace eod
