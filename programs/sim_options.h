#pragma once

#include <filesystem>
#include <string>

#include <CLI/App.hpp>

#include "platform/station_options.h"
#include "sim/camera/camera_thread.h"
#include "sim/sim_node.h"

namespace eod::sim {

/// What the command line of eod-sim decides.
struct SimOptions {
  std::filesystem::path world = EOD_DATA_DIR "/sim/worlds/training_ground.sdf";
  std::filesystem::path robot = EOD_DATA_DIR "/sim/robots/eod_robot.sdf";
  std::string scenario = EOD_DATA_DIR "/sim/scenarios/flat_first_drive.toml";  ///< file or name
  std::filesystem::path scenarios = EOD_DATA_DIR "/sim/scenarios";             ///< folder
  uint64_t repetition = 0;
  bool list = false;  ///< only print the catalogue
  std::filesystem::path rules = EOD_DATA_DIR "/sim/rules/eod_rules.toml";
  SimNodeConfig node;
  bool cameras = true;
  CameraConfig camera;
  // Lock-step: a candump log instead of LCM.
  bool lockstep = false;
  std::filesystem::path dbc = EOD_DATA_DIR "/dbc/control_box.dbc";
  std::filesystem::path map = EOD_DATA_DIR "/dbc/control_box.map.toml";
  std::filesystem::path can_log;
  std::filesystem::path out;
  std::filesystem::path report;  ///< folder for score and report of a mission; empty: none
};

/// Registers all but the station's options. Values go to `options`, which must outlive the parsing.
void AddSimOptions(CLI::App& app, SimOptions& options);

/// Text of `--describe`.
std::string Describe(const SimOptions& options);

}  // namespace eod::sim
