#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace eod::recorder {

/// When a recording ends by itself.
enum class Until : uint8_t { kSignal, kMissionEnd, kScriptDone };

struct RecorderConfig {
  std::filesystem::path out;
  std::filesystem::path dbc_file;
  std::filesystem::path map_file;
  std::string channel_prefix;
  int bit_rate = 500000;        ///< [bit/s] of the bus, for its load
  double picture_period_s = 2;  ///< between two kept pictures of a camera
  Until until = Until::kSignal;
  double seconds = 0;  ///< longest recording; 0: no bound
  bool plain = false;  ///< lines instead of one live line
};

/// For people: what would be recorded, from where, into which files.
std::string Describe(const RecorderConfig& config, const std::string& bus_url);

}  // namespace eod::recorder
