#pragma once

#include <string>

#include <lcm/lcm-cpp.hpp>

#include "eod/robot_state_t.hpp"
#include "eod/scene_t.hpp"

#include "firmware_emu/sight.h"
#include "platform/clock.h"

namespace eod::box {

/// The eyes of a scripted operator: hears EOD_ROBOT_STATE and EOD_SCENE.
class SightNode {
 public:
  SightNode(const std::string& channel_prefix, lcm::LCM& lcm, const Clock& clock);
  ~SightNode();
  SightNode(const SightNode&) = delete;
  SightNode& operator=(const SightNode&) = delete;

  const Sight& sight() const { return sight_; }

 private:
  void OnRobot(const lcm::ReceiveBuffer* buffer, const std::string& channel,
               const robot_state_t* message);
  void OnScene(const lcm::ReceiveBuffer* buffer, const std::string& channel,
               const scene_t* message);
  void Place();

  lcm::LCM& lcm_;
  const Clock& clock_;
  lcm::Subscription* robot_subscription_ = nullptr;
  lcm::Subscription* scene_subscription_ = nullptr;
  std::array<double, 3> position_W_{};  ///< [m] of the robot in the world
  std::array<double, 3> origin_W_{};    ///< [m] of the module
  int robot_module_ = 0;
  int scene_module_ = 0;
  Sight sight_;
};

}  // namespace eod::box
