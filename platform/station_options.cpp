#include "platform/station_options.h"

#include <string>

#include <CLI/CLI.hpp>

namespace eod {
namespace {

std::string CheckChannelPrefix(const std::string& prefix) {
  return IsChannelPrefix(prefix) ? "" : "'" + prefix + "': allowed are up to 32 of A-Z a-z 0-9 _";
}

}  // namespace

void AddBusOptions(CLI::App& app, StationOptions& options) {
  app.add_option(
         "--bus", options.bus_url,
         "CAN bus: socketcan:IFACE (a real or virtual interface), udp:GROUP:PORT (python-can's "
         "udp_multicast) or inproc:NAME")
      ->type_name("URL")
      ->capture_default_str();
  app.add_option("--can-ttl", options.bus.multicast_ttl,
                 "how far a udp bus reaches: 0 this host, 1 the local network")
      ->type_name("HOPS")
      ->check(CLI::Range(0, 255))
      ->capture_default_str();
}

void AddStationOptions(CLI::App& app, StationOptions& options) {
  app.add_option("--lcm-url", options.lcm.url,
                 "LCM network; without it LCM_DEFAULT_URL, or else udpm://239.255.76.67:7667?ttl=0")
      ->type_name("URL");
  app.add_option("--channel-prefix", options.lcm.channel_prefix,
                 "put before every channel name: tells several stations on one network apart")
      ->type_name("PREFIX")
      ->check(CLI::Validator(CheckChannelPrefix, "", "channel prefix"));
  app.add_flag("--describe", options.describe, "print configuration, rates and channels, then end");
}

std::unique_ptr<CanBus> OpenCanBus(const StationOptions& options, const Clock& clock) {
  return OpenCanBus(options.bus_url, clock, options.bus);
}

}  // namespace eod
