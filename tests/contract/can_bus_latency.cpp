// can_bus_latency URL [URL]: how long a frame takes from one node to another (each in a thread of
// its own that waits in poll), and there and back again. With two URLs the nodes sit on two
// interfaces of one bus, such as can0 and can1.
#include <algorithm>
#include <cstring>
#include <iostream>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <poll.h>

#include "platform/event_loop.h"
#include "platform/open_can_bus.h"
#include "platform/run_main.h"

namespace eod {
namespace {

constexpr uint32_t kPing = 0x100;
constexpr uint32_t kPong = 0x101;
constexpr uint32_t kEnd = 0x1FF;

CanFrame Stamped(uint32_t id, TimePoint moment) {
  CanFrame frame{.id = id, .length = 8};
  const int64_t nanoseconds = moment.time_since_epoch().count();
  std::memcpy(frame.data.data(), &nanoseconds, sizeof nanoseconds);
  return frame;
}

Duration Age(const CanFrame& frame, TimePoint now) {
  int64_t nanoseconds = 0;
  std::memcpy(&nanoseconds, frame.data.data(), sizeof nanoseconds);
  return now.time_since_epoch() - Duration{nanoseconds};
}

void Report(const std::string& what, std::vector<Duration> durations) {
  if (durations.empty()) throw std::runtime_error(what + ": nothing arrived");
  std::ranges::sort(durations);
  const auto at = [&durations](size_t percent) {
    const size_t index = std::min(durations.size() - 1, durations.size() * percent / 100);
    return ToSeconds(durations[index]) * 1e6;
  };
  std::cout << fmt::format("{}: p50 {:.1f} us, p99 {:.1f} us, max {:.1f} us, n {}\n", what, at(50),
                           at(99), ToSeconds(durations.back()) * 1e6, durations.size());
}

/// Answers every ping with a pong that carries the same moment; gives the pings' ages.
std::vector<Duration> Answer(CanBus& bus, const Clock& clock) {
  std::vector<Duration> ages;
  pollfd entry{.fd = bus.PollDescriptor(), .events = POLLIN, .revents = 0};
  while (::poll(&entry, 1, 5000) > 0) {
    while (auto frame = bus.Receive()) {
      if (frame->id == kEnd) return ages;
      if (frame->id != kPing) continue;
      ages.push_back(Age(*frame, clock.Now()));
      frame->id = kPong;
      bus.Send(*frame);
    }
  }
  return ages;
}

void Measure(const std::string& here, const std::string& there, int count) {
  const SteadyClock clock;
  const auto asking = OpenCanBus(here, clock);
  const auto answering = OpenCanBus(there, clock);
  std::vector<Duration> one_way;
  std::vector<Duration> round_trip;
  std::thread answerer([&] { one_way = Answer(*answering, clock); });
  EventLoop loop(clock);
  loop.AddTimer(std::chrono::milliseconds(1), [&](TimePoint) {
    if (count-- > 0) asking->Send(Stamped(kPing, clock.Now()));
    if (count < -20) loop.Stop();  // 20 ms for the last answer
  });
  loop.AddDescriptor(asking->PollDescriptor(), [&] {
    while (const auto frame = asking->Receive()) {
      if (frame->id == kPong) round_trip.push_back(Age(*frame, clock.Now()));
    }
  });
  loop.Run();
  asking->Send({.id = kEnd});
  answerer.join();
  Report(here + " one way", one_way);
  Report(here + " there and back", round_trip);
}

}  // namespace
}  // namespace eod

int main(int argc, char** argv) {
  CLI::App app("Latency of a CAN bus between two nodes, at 1 kHz.");
  std::string here;
  std::string there;
  int count = 5000;
  app.add_option("url", here)->required();
  app.add_option("other-url", there);
  app.add_option("--count", count, "frames");
  return eod::RunMain(app, "0", argc, argv,
                      [&] { eod::Measure(here, there.empty() ? here : there, count); });
}
