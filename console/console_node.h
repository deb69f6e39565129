#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "eod/box_command_t.hpp"
#include "eod/image_t.hpp"
#include "eod/mission_status_t.hpp"

#include "console/console_config.h"
#include "console/picture_server.h"
#include "platform/time.h"

namespace eod::console {

/// Hands camera pictures on to browsers as they come. Says nothing on LCM.
class ConsoleNode {
 public:
  /// Throws std::runtime_error if the address or port cannot be had.
  ConsoleNode(const ConsoleConfig& config, lcm::LCM& lcm);
  ~ConsoleNode();
  ConsoleNode(const ConsoleNode&) = delete;
  ConsoleNode& operator=(const ConsoleNode&) = delete;

  void OnCan() {}
  void OnTick(TimePoint /*scheduled*/) { server_.Serve(); }
  Duration tick_period() const { return std::chrono::milliseconds(5); }

  std::string url() const;

 private:
  void OnCommand(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                 const box_command_t* command);
  void OnMission(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                 const mission_status_t* mission);
  void OnPicture(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                 const image_t* picture);

  ConsoleConfig config_;
  lcm::LCM& lcm_;
  PictureServer server_;
  std::vector<lcm::Subscription*> subscriptions_;
  int camera_select_ = 1;
};

}  // namespace eod::console
