// can_bus_pipe URL: a bus as text, for tests in other languages. Sends each candump line of its
// standard input, and prints each frame that it receives as one, until the input ends.
#include <iostream>
#include <string>

#include "platform/candump_log.h"
#include "platform/event_loop.h"
#include "platform/open_can_bus.h"
#include "platform/run_main.h"

namespace eod {
namespace {

void SendLine(CanBus& bus, const std::string& line) {
  const auto frame = ParseCandumpLine(line);
  if (!frame || bus.Send(*frame) != SendOutcome::kSent) std::cout << "not sent: " << line << '\n';
  std::cout.flush();
}

void Run(const std::string& url) {
  const SteadyClock clock;
  const auto bus = OpenCanBus(url, clock);
  EventLoop loop(clock);
  std::string pending;
  loop.AddDescriptor(STDIN_FILENO, [&] {
    std::array<char, 4096> bytes{};
    const auto count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) return loop.Stop();
    pending.append(bytes.data(), static_cast<size_t>(count));
    for (size_t end = pending.find('\n'); end != std::string::npos; end = pending.find('\n')) {
      SendLine(*bus, pending.substr(0, end));
      pending.erase(0, end + 1);
    }
  });
  loop.AddDescriptor(bus->PollDescriptor(), [&bus] {
    while (const auto frame = bus->Receive()) {
      std::cout << FormatCandumpLine(*frame, "bus") << std::endl;
    }
  });
  std::cout << "ready" << std::endl;
  loop.Run();
}

}  // namespace
}  // namespace eod

int main(int argc, char** argv) {
  CLI::App app("A CAN bus as candump text.");
  std::string url;
  app.add_option("url", url)->required();
  return eod::RunMain(app, "0", argc, argv, [&url] { eod::Run(url); });
}
