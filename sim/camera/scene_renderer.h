#pragma once

#include <map>
#include <memory>
#include <vector>

#include "sim/camera/camera_thread.h"
#include "sim/camera/draw_list.h"
#include "sim/camera/effects_pass.h"
#include "sim/camera/gpu_mesh.h"
#include "sim/camera/lighting.h"
#include "sim/camera/module_scene.h"
#include "sim/camera/plume_pass.h"
#include "sim/camera/render_target.h"
#include "sim/camera/sky_dome.h"
#include "sim/camera/surface_program.h"
#include "sim/camera/view.h"

namespace eod::sim {

/// Work of one picture, its share of the shadow map counted in.
struct DrawCounters {
  int triangles = 0;
  int draw_calls = 0;
};

/// The camera of that name. Throws std::runtime_error that names the cameras there are.
const CameraSpec& FindCamera(const RobotModel& robot, const std::string& name);

/// Horizontal field of view [rad] at `zoom`, which a camera obeys as far as its lens goes.
double ZoomedFov(const CameraSpec& camera, double zoom);

/// Draws the robot in its module. Use: `Prepare` once a snapshot, then `Draw` for each camera.
class SceneRenderer {
 public:
  /// Throws std::runtime_error with one line: an unknown texture, too many links or
  /// movable objects.
  SceneRenderer(const GlFunctions& gl, const RobotModel& robot, const WorldModel& world);

  /// Poses the robot and what is movable, and renders the sun's shadow around it. The first call
  /// for a module uploads that module. An unknown module shows sky and grass only.
  void Prepare(const SceneSnapshot& snapshot);

  /// Draws the prepared snapshot as `camera` sees it, into `area` of the target. What is far away
  /// for the size of the picture and the zoom of the lens is drawn more coarsely.
  DrawCounters Draw(const CameraSpec& camera, const RenderTarget& target, const PixelArea& area);
  DrawCounters Draw(const CameraSpec& camera, const RenderTarget& target) {
    return Draw(camera, target, target.whole());
  }
  /// Share of the shadow map in the counters of each Draw.
  const DrawCounters& shadow_counters() const { return shadow_counters_; }

 private:
  void LoadModule(int module);
  void PoseRobot();
  void DrawShadow();
  void DrawScene(const View& view, std::span<const ShiningSpot> spots);
  void DrawThings(const SurfaceProgram& program, const View& view);
  void DrawWorld(const View& view, bool ground);
  void CollectDetails(const DrawBlock& block, const Frustum& frustum, const Eigen::Vector3f& eye);
  void DrawSurroundings(const View& view, const SurfaceProgram& ground);
  void DrawRain(const View& view, std::span<const ShiningSpot> spots, const PixelArea& area);
  void DrawIsectors(const View& view, const PixelArea& area);
  void Collect(const IndexRun& run);
  void DrawCollected();
  void BindSurface(int texture);

  const GlFunctions& gl_;
  const RobotModel& robot_;
  const WorldModel& world_;
  std::vector<GlObject> surfaces_;
  GlObject variation_;
  ShadowMap shadow_map_;
  ShadowProgram shadow_program_;
  SurfacePrograms programs_;
  SkyDome sky_;
  DrawList robot_list_;
  GpuMesh robot_mesh_;
  GpuMesh surroundings_;
  GlObject overlay_program_;
  ColourTriangles overlay_;
  PlumePass plume_;
  EffectsPass effects_;
  std::unique_ptr<ModuleScene> module_;
  int module_id_ = -1;  ///< of module_, or of what was looked for in vain

  SceneSnapshot snapshot_;
  Lighting lighting_;
  std::vector<Eigen::Isometry3d> X_ML_;
  BonePalette bones_;
  RobotState shadow_state_;  ///< that the shadow map shows, as are these
  std::vector<DrawnMovable> shadow_movables_;
  View sun_;
  Eigen::Vector3f shadow_to_sun_ = Eigen::Vector3f::Zero();
  float pixels_per_radian_ = 1;      ///< in the middle of the picture being drawn
  std::vector<GLsizei> run_counts_;  ///< collected for one call, as are these
  std::vector<const void*> run_starts_;
  std::vector<ColourVertex> overlay_triangles_;
  DrawCounters counters_;
  DrawCounters shadow_counters_;
};

}  // namespace eod::sim
