#include "firmware_emu/sight_node.h"

#include <algorithm>

#include "lcmtypes/channels.h"

namespace eod::box {

SightNode::SightNode(const std::string& channel_prefix, lcm::LCM& lcm, const Clock& clock)
    : lcm_(lcm), clock_(clock) {
  robot_subscription_ =
      lcm_.subscribe(ChannelName(channel_prefix, kRobotStateChannel), &SightNode::OnRobot, this);
  scene_subscription_ =
      lcm_.subscribe(ChannelName(channel_prefix, kSceneChannel), &SightNode::OnScene, this);
}

SightNode::~SightNode() {
  lcm_.unsubscribe(robot_subscription_);
  lcm_.unsubscribe(scene_subscription_);
}

void SightNode::OnRobot(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                        const robot_state_t* message) {
  std::copy_n(message->position_m, 3, position_W_.begin());
  robot_module_ = message->module;
  sight_.robot_time = clock_.Now();
  sight_.heading_deg = message->heading_deg;
  sight_.speed_mps = message->speed_mps;
  sight_.turn_rate_dps = message->turn_rate_dps;
  Place();
}

void SightNode::OnScene(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                        const scene_t* message) {
  std::copy_n(message->origin_m, 3, origin_W_.begin());
  scene_module_ = message->module;
  sight_.scene_time = clock_.Now();
  sight_.objects.resize(message->name.size());
  for (size_t i = 0; i < sight_.objects.size(); ++i) {
    SeenObject& object = sight_.objects[i];
    object.name = message->name[i];
    std::copy_n(message->position_m[i].begin(), 3, object.position.begin());
    object.heading_deg = message->heading_deg[i];
    object.tilt_deg = message->tilt_deg[i];
    object.is_held = message->is_held[i] != 0;
    object.is_gone = message->is_gone[i] != 0;
  }
  Place();
}

/// On entering a module one message comes first: until the other one has, nothing fits together.
void SightNode::Place() {
  sight_.has_robot = robot_module_ == scene_module_ && robot_module_ != 0;
  for (size_t i = 0; i < 3; ++i) sight_.position[i] = position_W_[i] - origin_W_[i];
}

}  // namespace eod::box
