#pragma once

#include "sim/camera/camera_thread.h"
#include "sim/camera/glyph_atlas.h"

namespace eod::sim {

/// What an operator control unit writes into a picture. Latin-1, each possibly empty.
struct OnScreenText {
  std::string name;   ///< top left: the camera's
  std::string clock;  ///< top right: hh:mm:ss.t of the snapshot (UTC)
  std::string tilt;   ///< bottom left: pitch (nose up +) and roll (right side down +) of the robot
  std::string head;   ///< bottom right: pan, tilt and zoom of a camera that has them
};

/// Written out, or shortened for a picture that is less than 480 pixels wide.
OnScreenText TextOf(const RobotModel& robot, const CameraSpec& camera,
                    const SceneSnapshot& snapshot, int width);

/// Writes into pictures of one height.
class OnScreenData {
 public:
  /// Throws std::runtime_error if the font is missing.
  explicit OnScreenData(int height);

  /// Name and clock above, tilt and head below, and between name and clock a mark that this is a
  /// simulation.
  void Draw(const OnScreenText& text, const PixelView& picture) const;
  /// In the middle of a picture that does not come.
  void DrawNoSignal(const PixelView& picture) const;
  /// [px] as far as which the lines above and below reach into the picture.
  int band() const { return margin_ + letters_.line_height() + 4; }

 private:
  void DrawMark(int left, int top, const PixelView& picture) const;

  GlyphAtlas letters_;
  GlyphAtlas capitals_;  ///< twice as large
  int margin_;
};

}  // namespace eod::sim
