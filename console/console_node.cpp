#include "console/console_node.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "console/operator_page.h"
#include "lcmtypes/channels.h"

namespace eod::console {
namespace {

struct Feed {
  const Channel& channel;
  std::string_view camera;
};
constexpr std::array<Feed, 5> kFeeds{{{kDriveCameraChannel, "drive"},
                                      {kMastCameraChannel, "mast"},
                                      {kGripperCameraChannel, "gripper"},
                                      {kRearCameraChannel, "rear"},
                                      {kQuadCameraChannel, "quad"}}};

}  // namespace

ConsoleNode::ConsoleNode(const ConsoleConfig& config, lcm::LCM& lcm)
    : config_(config), lcm_(lcm), server_(config.address, config.port, OperatorPage()) {
  server_.Tell("step", StepText(false, 0, 0, ""));
  server_.Tell("beside", std::string(ShownFor(camera_select_).beside));
  subscriptions_.push_back(lcm_.subscribe(ChannelName(config.channel_prefix, kBoxCommandChannel),
                                          &ConsoleNode::OnCommand, this));
  subscriptions_.push_back(lcm_.subscribe(ChannelName(config.channel_prefix, kMissionStatusChannel),
                                          &ConsoleNode::OnMission, this));
  for (const Feed& feed : kFeeds) {
    subscriptions_.push_back(lcm_.subscribe(ChannelName(config.channel_prefix, feed.channel),
                                            &ConsoleNode::OnPicture, this));
  }
}

ConsoleNode::~ConsoleNode() {
  for (lcm::Subscription* subscription : subscriptions_) lcm_.unsubscribe(subscription);
}

std::string ConsoleNode::url() const {
  return fmt::format("http://{}:{}/", config_.address, server_.port());
}

void ConsoleNode::OnCommand(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                            const box_command_t* command) {
  if (command->camera_select == camera_select_) return;
  camera_select_ = command->camera_select;
  server_.Tell("beside", std::string(ShownFor(camera_select_).beside));
}

void ConsoleNode::OnMission(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                            const mission_status_t* mission) {
  const bool is_running = mission->state == mission_status_t::STATE_RUN;
  server_.Tell("step", StepText(is_running, mission->step, mission->steps, mission->step_text));
}

void ConsoleNode::OnPicture(const lcm::ReceiveBuffer* /*buffer*/, const std::string& channel,
                            const image_t* picture) {
  if (picture->pixelformat != image_t::PIXEL_FORMAT_MJPEG) return;
  const std::span<const uint8_t> jpeg(picture->data);
  const Shown shown = ShownFor(camera_select_);
  for (const Feed& feed : kFeeds) {
    if (channel != ChannelName(config_.channel_prefix, feed.channel)) continue;
    server_.Offer(std::string(feed.camera), jpeg);
    if (feed.camera == shown.chosen) server_.Offer("chosen", jpeg);
    if (feed.camera == shown.beside) server_.Offer("beside", jpeg);
  }
  server_.Serve();
}

}  // namespace eod::console
