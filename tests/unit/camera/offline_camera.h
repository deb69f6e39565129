#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/camera/gl_context.h"
#include "sim/camera/scene_renderer.h"

namespace eod::sim {

/// Renders single pictures on the caller's thread, for tests and tools.
class OfflineCamera {
 public:
  OfflineCamera(const RobotModel& robot, const WorldModel& world, int width = 640,
                int height = 480);
  ~OfflineCamera();

  /// RGBA, bottom row first. Valid until the next call.
  const std::vector<uint8_t>& Take(const SceneSnapshot& snapshot, const std::string& camera);

  const DrawCounters& counters() const { return counters_; }
  int width() const { return target_.width(); }
  int height() const { return target_.height(); }

 private:
  const RobotModel& robot_;
  std::unique_ptr<GlContext> context_;
  SceneRenderer renderer_;
  RenderTarget target_;
  std::vector<uint8_t> pixels_;
  DrawCounters counters_;
};

}  // namespace eod::sim
