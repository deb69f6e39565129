#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/camera/on_screen_data.h"
#include "sim/camera/picture_link.h"
#include "sim/camera/scene_renderer.h"
#include "sim/camera/sensor.h"

namespace eod::sim {

/// A camera and where its view stands in a picture.
struct PictureView {
  const CameraSpec* camera = nullptr;
  PixelArea area;
};

/// The views of a picture of that name: one camera, or all four in quarters for "quad": drive and
/// gripper above, mast and rear below. Throws std::runtime_error for an unknown camera.
std::vector<PictureView> ViewsOf(const RobotModel& robot, std::string_view picture, int width,
                                 int height);

/// Makes pictures as the operator sees them: the scene, the sensor's noise, the faults of cameras,
/// what the control unit writes into them, and what the link does to them.
class PictureMaker {
 public:
  /// Throws as SceneRenderer does, or if a font is missing that `draw_data` needs.
  PictureMaker(const GlFunctions& gl, const RobotModel& robot, const WorldModel& world, int width,
               int height, bool draw_data);

  /// The moment that the next pictures show.
  void Show(const SceneSnapshot& snapshot);

  /// A picture by its name: RGBA, bottom row first. Valid until the next call.
  const std::vector<uint8_t>& Make(const std::string& picture);

  /// Work of the last picture.
  const DrawCounters& counters() const { return counters_; }

 private:
  struct Faults {
    bool is_dead = false;
    bool is_frozen = false;
    Exposure exposure;
  };
  struct Brush {
    Sensor sensor;
    std::optional<OnScreenData> data;
  };

  Faults FaultsOf(const CameraSpec& camera) const;
  const SceneSnapshot& SnapshotOf(const CameraSpec& camera) const;
  void KeepFrozen();
  void Render(const std::vector<PictureView>& views);
  void Finish(const PictureView& view, const PixelView& pixels);
  void Separate(const PixelView& picture) const;
  Brush& BrushFor(const PixelArea& area);

  const RobotModel& robot_;
  SceneRenderer renderer_;
  RenderTarget target_;
  Brush whole_;
  Brush quarter_;
  SceneSnapshot snapshot_;
  std::map<std::string, SceneSnapshot, std::less<>> frozen_;  ///< by camera: since the fault began
  std::optional<std::string> prepared_;  ///< camera whose frozen moment is; "" for the current one
  std::map<std::string, PictureLink, std::less<>> links_;  ///< by picture
  std::vector<uint8_t> pixels_;
  DrawCounters counters_;
};

}  // namespace eod::sim
