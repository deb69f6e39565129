#include "console/console_config.h"

#include <fmt/format.h>

#include "lcmtypes/channels.h"

namespace eod::console {

std::string Describe(const ConsoleConfig& config) {
  std::string text = fmt::format(
      "eod-console: camera pictures for a browser\n"
      "page             http://{}:{}/\n"
      "streams          /chosen.mjpeg /beside.mjpeg, and /NAME.mjpeg of each camera\n"
      "text             /step.txt: what the trainee is to do now\n"
      "hears\n",
      config.address, config.port);
  for (const Channel& channel :
       {kBoxCommandChannel, kMissionStatusChannel, kDriveCameraChannel, kMastCameraChannel,
        kGripperCameraChannel, kRearCameraChannel, kQuadCameraChannel}) {
    text += fmt::format("  {:<24} {:<18} {}\n", ChannelName(config.channel_prefix, channel),
                        channel.type, channel.rate);
  }
  return text;
}

}  // namespace eod::console
