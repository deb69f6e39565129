#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "platform/time.h"
#include "sim/camera/camera_fault.h"
#include "sim/camera/gl_context.h"
#include "sim/plume/picture_effects.h"
#include "sim/plume/plume_quad.h"
#include "sim/robot/robot_model.h"
#include "sim/world/weather.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// An isector line to draw into the picture, in the module's local frame.
struct DrawnSegment {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  bool hit = false;
  bool contact = false;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of the hit
};

/// A movable object as it stands, in the order of ModuleModel::movables.
struct DrawnMovable {
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();
  bool is_visible = true;  ///< not if it is gone
  bool operator==(const DrawnMovable& other) const {
    return is_visible == other.is_visible && X_MO.matrix() == other.X_MO.matrix();
  }
};

/// What the cameras show: copied out of a step, so that a slow picture never delays one.
struct SceneSnapshot {
  TimePoint time{};
  int module = 1;
  int camera_select = 1;  ///< the operator's, see CameraChoice
  Weather weather;
  RobotLights lights;
  RobotState state;
  std::vector<DrawnSegment> segments;  ///< empty unless isectors are drawn
  /// Those beyond its end stand where the module has them at the start.
  std::vector<DrawnMovable> movables;
  std::vector<PlumeQuad> quads;  ///< of an explosion
  PictureEffects effects;
  double zoom = 1;         ///< magnification of cameras that zoom
  float link_quality = 1;  ///< of the way that pictures take, 0 (none arrives) .. 1
  std::vector<CameraFault> faults;
  uint32_t seed = 0;  ///< of noise and of what the link damages
};

struct CameraConfig {
  /// Names in the robot file, and "quad": all four in one picture. Which of them are rendered
  /// follows the operator's choice.
  std::vector<std::string> cameras = {"drive", "gripper", "mast", "rear", "quad"};
  int width = 640;
  int height = 480;
  double rate_hz = 30;  ///< pictures a second of a camera at its full rate, 1..60
  int jpeg_quality = 80;
  bool draw_isectors = false;
  bool draw_data = true;  ///< name, time, tilt and zoom, burnt into the pictures
  GlBackend backend = GlBackend::kOsMesa;
};

/// One compressed picture. At most 65,000 bytes, so that it fits one LCM datagram: quality is
/// lowered for a picture that does not.
struct Picture {
  std::string_view camera;
  TimePoint time{};  ///< of the step that is shown
  int width = 0;
  int height = 0;
  std::span<const uint8_t> jpeg;
};

/// Renders snapshots on a thread of its own with OSMesa and hands out JPEG pictures.
class CameraThread {
 public:
  /// Called on the camera's thread. Must not throw.
  using PictureSink = std::function<void(const Picture&)>;

  /// Throws std::runtime_error with one line if OSMesa gives no OpenGL 3.3 context or a camera is
  /// not in the robot file. `robot` and `world` must outlive the thread.
  CameraThread(const RobotModel& robot, const WorldModel& world, CameraConfig config,
               PictureSink sink);
  /// Ends the thread and waits for it.
  ~CameraThread();

  /// Hands over the newest snapshot; the one before, if not rendered yet, is forgotten. Never
  /// blocks for longer than a copy.
  void Show(const SceneSnapshot& snapshot);

  uint64_t pictures() const;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace eod::sim
