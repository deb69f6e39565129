#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/camera/gl_context.h"
#include "sim/camera/picture_maker.h"
#include "sim/camera/scene_renderer.h"

namespace eod::sim {

/// Renders single pictures on the caller's thread, for tests and tools.
class OfflineCamera {
 public:
  OfflineCamera(const RobotModel& robot, const WorldModel& world, int width = 640, int height = 480,
                GlBackend backend = GlBackend::kOsMesa, bool draw_data = true);
  ~OfflineCamera();

  /// The bare scene: RGBA, bottom row first. Valid until the next call.
  const std::vector<uint8_t>& Take(const SceneSnapshot& snapshot, const std::string& camera);

  /// As the operator sees it: with the sensor's noise, faults, data and the link's damage.
  /// `picture` may be "quad".
  const std::vector<uint8_t>& TakeFinished(const SceneSnapshot& snapshot,
                                           const std::string& picture);

  const DrawCounters& counters() const { return counters_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  /// The bare scene's own renderer, made when it is asked for: it holds textures and the module.
  struct Bare {
    SceneRenderer renderer;
    RenderTarget target;
  };

  const RobotModel& robot_;
  const WorldModel& world_;
  int width_;
  int height_;
  bool draw_data_;
  std::unique_ptr<GlContext> context_;
  std::optional<Bare> bare_;
  std::optional<PictureMaker> maker_;
  std::vector<uint8_t> pixels_;
  DrawCounters counters_;
};

}  // namespace eod::sim
