#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "platform/lcm_station.h"
#include "platform/open_can_bus.h"

namespace eod {

/// Options by which a program finds its station: the CAN bus and the LCM network it belongs to.
struct StationOptions {
  std::string bus_url = "udp:239.74.163.2:43113";  ///< `--bus`, see OpenCanBus
  CanBusOptions bus;                               ///< `--can-ttl`
  LcmStation lcm;                                  ///< `--lcm-url`, `--channel-prefix`
  bool describe = false;                           ///< `--describe`: print what would run, then end
};

/// Registers `--bus` and `--can-ttl`. Values go to `options`, which must outlive the parsing.
void AddBusOptions(CLI::App& app, StationOptions& options);

/// Registers `--lcm-url`, `--channel-prefix` and `--describe`, which every program has.
void AddStationOptions(CLI::App& app, StationOptions& options);

/// Opens the bus that the options name. Throws as OpenCanBus does.
std::unique_ptr<CanBus> OpenCanBus(const StationOptions& options, const Clock& clock);

}  // namespace eod
