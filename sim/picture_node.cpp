#include "sim/picture_node.h"

#include "lcmtypes/channels.h"

namespace eod::sim {

PictureNode::PictureNode(lcm::LCM& lcm, std::string_view channel_prefix) : lcm_(lcm) {
  outputs_["drive"].channel = ChannelName(channel_prefix, kDriveCameraChannel);
  outputs_["gripper"].channel = ChannelName(channel_prefix, kGripperCameraChannel);
  outputs_["rear"].channel = ChannelName(channel_prefix, kRearCameraChannel);
  outputs_["quad"].channel = ChannelName(channel_prefix, kQuadCameraChannel);
  outputs_["mast"].channel = ChannelName(channel_prefix, kMastCameraChannel);
}

void PictureNode::Publish(const Picture& picture) {
  const auto found = outputs_.find(picture.camera);
  if (found == outputs_.end()) return;
  auto& [channel, message] = found->second;
  message.utime = ToUtime(picture.time);
  message.width = picture.width;
  message.height = picture.height;
  message.row_stride = 0;
  message.pixelformat = image_t::PIXEL_FORMAT_MJPEG;
  message.data.assign(picture.jpeg.begin(), picture.jpeg.end());
  message.size = static_cast<int32_t>(message.data.size());
  message.nmetadata = 0;
  lcm_.publish(channel, &message);
}

}  // namespace eod::sim
