#pragma once

#include <map>
#include <string>
#include <string_view>

#include <lcm/lcm-cpp.hpp>

#include "eod/image_t.hpp"

#include "sim/camera/camera_thread.h"

namespace eod::sim {

/// Puts the cameras' pictures on LCM. Lives on the camera's thread; LCM lets several threads
/// publish.
class PictureNode {
 public:
  PictureNode(lcm::LCM& lcm, std::string_view channel_prefix);

  /// Publishes on the channel of the picture's camera. A camera without a channel is passed over.
  void Publish(const Picture& picture);

 private:
  struct Output {
    std::string channel;
    image_t message;  ///< keeps its memory
  };
  lcm::LCM& lcm_;
  std::map<std::string, Output, std::less<>> outputs_;  ///< by name of the camera
};

}  // namespace eod::sim
