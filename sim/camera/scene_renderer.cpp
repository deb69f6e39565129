#include "sim/camera/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/camera/isector_overlay.h"
#include "sim/camera/rain_streaks.h"
#include "sim/camera/shaders.h"
#include "sim/camera/surface_textures.h"
#include "sim/camera/surroundings.h"

namespace eod::sim {
namespace {

constexpr double kShadowHalfSide = 15;  // [m]
constexpr double kShadowAhead = 7;  // [m] its middle lies before the robot: that way cameras look
// [px] a metre, as far as which shapes are drawn finely, and in blocks and regions of the module.
constexpr float kFinePixels = 35;
constexpr float kBlockPixels = 12;
constexpr float kRegionPixels = 4;
constexpr float kFineLinkPixels = 250;  // the same of the robot's parts, and of movable objects
constexpr float kFineMovablePixels = 100;
constexpr double kModuleDepth = 0.9999;  // share of the depth buffer for all near things
constexpr double kMeadowDepth = 0.99999;
constexpr double kRobotMiddle = 0.6;    // [m] above the ground: light is looked for there
constexpr float kFaintestSun = 0.004F;  // that throws a shadow to be seen
constexpr int kGrass = 1;               // in kSurfaceTextures

std::vector<GlObject> UploadSurfaces(const GlFunctions& gl) {
  std::vector<GlObject> surfaces;
  for (size_t i = 0; i < kSurfaceTextures.size(); ++i) {
    surfaces.push_back(UploadSurface(gl, PaintSurfaceTexture(static_cast<int>(i))));
  }
  return surfaces;
}

}  // namespace

const CameraSpec& FindCamera(const RobotModel& robot, const std::string& name) {
  const auto found = std::find_if(robot.cameras.begin(), robot.cameras.end(),
                                  [&](const CameraSpec& camera) { return camera.name == name; });
  if (found != robot.cameras.end()) return *found;
  std::vector<std::string> names;
  for (const CameraSpec& camera : robot.cameras) names.push_back(camera.name);
  throw std::runtime_error(fmt::format("{}: no camera \"{}\"; there are: {}", robot.file.string(),
                                       name, fmt::join(names, ", ")));
}

double ZoomedFov(const CameraSpec& camera, double zoom) {
  const double magnification = std::clamp(zoom, 1.0, camera.zoom_most);
  if (magnification == 1) return camera.horizontal_fov;
  return 2 * std::atan(std::tan(camera.horizontal_fov / 2) / magnification);
}

SceneRenderer::SceneRenderer(const GlFunctions& gl, const RobotModel& robot,
                             const WorldModel& world)
    : gl_(gl),
      robot_(robot),
      world_(world),
      surfaces_(UploadSurfaces(gl)),
      variation_(UploadSurface(gl, PaintGroundVariation())),
      shadow_map_(gl),
      shadow_program_(gl),
      programs_(gl),
      sky_(gl),
      robot_list_(BuildRobotDrawList(robot)),
      robot_mesh_(gl, robot_list_.mesh),
      surroundings_(gl, MakeSurroundings()),
      overlay_program_(MakeProgram(gl, "overlay", kOverlayVertexShader, kOverlayFragmentShader)),
      overlay_(gl),
      plume_(gl),
      effects_(gl) {
  const auto check = [](const std::string& owner, size_t count, const char* what) {
    if (count < kMaxBones) return;
    throw std::runtime_error(
        fmt::format("{}: {} {}, cameras can show {}", owner, count, what, kMaxBones - 1));
  };
  check(robot.file.string(), robot.links.size(), "links");
  for (const ModuleModel& module : world.modules) {
    check(fmt::format("{}: module {}", world.file.string(), module.name), module.movables.size(),
          "movable objects");
  }
  bones_ = MakePalette(robot.links.size() + 1);
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
}

void SceneRenderer::LoadModule(int module) {
  module_.reset();
  module_id_ = module;
  const auto found = std::find_if(world_.modules.begin(), world_.modules.end(),
                                  [&](const ModuleModel& model) { return model.id == module; });
  if (found == world_.modules.end()) return;
  module_ = std::make_unique<ModuleScene>(gl_, *found, lighting_.street_lamps);
}

void SceneRenderer::PoseRobot() {
  LinkPoses(robot_, snapshot_.state, X_ML_);
  PlaceLight light;
  if (module_ != nullptr) {
    const Eigen::Vector3d p_M = snapshot_.state.position + kRobotMiddle * Eigen::Vector3d::UnitZ();
    light = module_->probe().Around(p_M.cast<float>());
  }
  for (size_t link = 0; link < X_ML_.size(); ++link) {
    SetBone(X_ML_[link], link + 1, bones_);
    SetBoneLight(light, link + 1, bones_);
  }
}

void SceneRenderer::Prepare(const SceneSnapshot& snapshot) {
  snapshot_ = snapshot;
  const bool had_street_lamps = lighting_.street_lamps;
  lighting_ = LightingOf(world_.atmosphere, snapshot.weather);
  sky_.SetLook(lighting_.sky);
  const bool is_new_module =
      snapshot.module != module_id_ || lighting_.street_lamps != had_street_lamps;
  if (is_new_module) LoadModule(snapshot.module);
  PoseRobot();
  if (module_ != nullptr) module_->Pose(snapshot.movables);
  if (lighting_.sun_light.maxCoeff() < kFaintestSun) {
    shadow_to_sun_.setZero();
    shadow_counters_ = {};
    return;
  }
  // What stands still throws the shadow that is there already.
  if (!is_new_module && snapshot.state == shadow_state_ && snapshot.movables == shadow_movables_ &&
      lighting_.to_sun == shadow_to_sun_) {
    return;
  }
  shadow_state_ = snapshot.state;
  shadow_movables_ = snapshot.movables;
  shadow_to_sun_ = lighting_.to_sun;
  DrawShadow();
}

void SceneRenderer::DrawShadow() {
  const Eigen::Matrix3d R_MB = ToRotation(snapshot_.state.attitude);
  sun_ = MakeSunView(lighting_.to_sun.cast<double>(),
                     snapshot_.state.position + kShadowAhead * R_MB.col(1), kShadowHalfSide,
                     ShadowMap::kSide);
  counters_ = {};
  shadow_map_.Bind();
  gl_.DepthRange(0.0, 1.0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5F, 4.0F);
  if (module_ != nullptr && !module_->movables_list().ranges.empty()) {
    shadow_program_.Use(sun_, module_->movables_bones());
    module_->movables_mesh().Bind();
    for (const DrawRange& range : module_->movables_list().ranges) Collect(range.coarse);
    DrawCollected();
  }
  shadow_program_.Use(sun_, bones_);
  robot_mesh_.Bind();
  for (const DrawRange& range : robot_list_.ranges) Collect(range.coarse);
  DrawCollected();
  if (module_ != nullptr) {
    const Frustum lit(sun_);
    module_->mesh().Bind();
    for (const DrawRange& range : module_->list().ranges) {
      if (range.casts_shadow && lit.MaySee(range.bounds)) Collect(range.coarse);
    }
    DrawCollected();
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  shadow_counters_ = counters_;
}

DrawCounters SceneRenderer::Draw(const CameraSpec& camera, const RenderTarget& target,
                                 const PixelArea& area) {
  const Lens lens{.horizontal_fov = ZoomedFov(camera, snapshot_.zoom),
                  .aspect = static_cast<double>(area.width) / area.height,
                  .near = camera.near};
  pixels_per_radian_ = static_cast<float>(area.width / 2.0 / std::tan(lens.horizontal_fov / 2));
  const Eigen::Isometry3d X_MC =
      X_ML_.at(static_cast<size_t>(camera.link)) * camera.X_LC * ShakeOf(snapshot_.effects);
  counters_ = shadow_counters_;
  target.Bind(area);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  // Nothing is seen behind a dead feed.
  if (snapshot_.effects.noise < 1) {
    const View view = MakeCameraView(X_MC, lens);
    const std::vector<ShiningSpot> spots = ChooseSpots(robot_, snapshot_.lights, X_ML_, X_MC);
    DrawScene(view, spots);
    gl_.DepthRange(0.0, kModuleDepth);
    if (const int triangles = plume_.Draw(snapshot_.quads, X_MC, lens); triangles > 0) {
      counters_.triangles += triangles;
      ++counters_.draw_calls;
    }
    DrawRain(view, spots, area);
    DrawIsectors(view, area);
  }
  effects_.Draw(snapshot_.effects, area.height);
  return counters_;
}

void SceneRenderer::DrawScene(const View& view, std::span<const ShiningSpot> spots) {
  gl_.ActiveTexture(SurfaceProgram::kVariationUnit);
  gl_.BindTexture(GL_TEXTURE_2D, variation_.id());
  gl_.ActiveTexture(SurfaceProgram::kShadowUnit);
  gl_.BindTexture(GL_TEXTURE_2D, shadow_map_.texture());

  gl_.DepthRange(0.0, kModuleDepth);
  // Near things first: what they hide is not shaded.
  SurfaceFeatures features{.spots = static_cast<int>(spots.size()),
                           .is_wet = lighting_.wetness > 0,
                           .is_infrared = snapshot_.lights.infrared};
  const SurfaceProgram& textured = programs_.Get(features);
  textured.Use(view, sun_, lighting_, spots);
  DrawThings(textured, view);
  DrawWorld(view, false);
  features.is_ground = true;
  const SurfaceProgram& ground = programs_.Get(features);
  ground.Use(view, sun_, lighting_, spots);
  ground.SetBones(bones_);
  DrawWorld(view, true);
  DrawSurroundings(view, ground);
  counters_.triangles += sky_.Draw(view, snapshot_.lights.infrared);
  ++counters_.draw_calls;
}

/// The robot and what is movable. Leaves the robot's bones, whose first is the static world.
void SceneRenderer::DrawThings(const SurfaceProgram& program, const View& view) {
  const Frustum frustum(view);
  const Eigen::Vector3f eye = view.p_ME.cast<float>();
  const auto draw = [&](const DrawList& list, const GpuMesh& mesh, const BonePalette& bones,
                        float fine_pixels) {
    program.SetBones(bones);
    mesh.Bind();
    for (size_t i = 0; i < list.ranges.size(); ++i) {
      const DrawRange& range = list.ranges[i];
      const Eigen::AlignedBox3f box = Placed(range.bounds, static_cast<size_t>(range.bone), bones);
      if (frustum.MaySee(box)) {
        const bool is_near = box.exteriorDistance(eye) < pixels_per_radian_ / fine_pixels;
        Collect(is_near ? range.fine : range.coarse);
      }
      const bool is_last =
          i + 1 == list.ranges.size() || list.ranges[i + 1].texture != range.texture;
      if (!is_last) continue;
      BindSurface(range.texture);
      DrawCollected();
    }
  };
  if (module_ != nullptr && !module_->movables_list().ranges.empty()) {
    draw(module_->movables_list(), module_->movables_mesh(), module_->movables_bones(),
         kFineMovablePixels);
  }
  draw(robot_list_, robot_mesh_, bones_, kFineLinkPixels);
}

void SceneRenderer::DrawWorld(const View& view, bool ground) {
  if (module_ == nullptr) return;
  const Frustum frustum(view);
  const Eigen::Vector3f eye = view.p_ME.cast<float>();
  const float region_distance = pixels_per_radian_ / kRegionPixels;
  const DrawList& list = module_->list();
  module_->mesh().Bind();
  int texture = -1;
  const auto draw_collected = [&] {
    if (texture >= 0) BindSurface(texture);
    DrawCollected();
  };
  for (const DrawBlock& region : list.regions) {
    if ((region.texture == kGrass) != ground || !frustum.MaySee(region.bounds)) continue;
    if (region.texture != texture) draw_collected();
    texture = region.texture;
    if (region.bounds.exteriorDistance(eye) > region_distance) {
      Collect(region.run);
    } else {
      for (size_t i = 0; i < region.count; ++i) {
        CollectDetails(list.blocks[region.first + i], frustum, eye);
      }
    }
  }
  draw_collected();
}

void SceneRenderer::CollectDetails(const DrawBlock& block, const Frustum& frustum,
                                   const Eigen::Vector3f& eye) {
  if (!frustum.MaySee(block.bounds)) return;
  if (block.bounds.exteriorDistance(eye) > pixels_per_radian_ / kBlockPixels) {
    return Collect(block.run);
  }
  for (size_t i = 0; i < block.count; ++i) {
    const DrawRange& range = module_->list().ranges[block.first + i];
    if (!frustum.MaySee(range.bounds)) continue;
    const bool is_near = range.bounds.exteriorDistance(eye) < pixels_per_radian_ / kFinePixels;
    Collect(is_near ? range.fine : range.coarse);
  }
}

void SceneRenderer::DrawSurroundings(const View& view, const SurfaceProgram& ground) {
  BonePalette here = MakePalette(1);
  SetBone(Eigen::Isometry3d(Eigen::Translation3d(view.p_ME.x(), view.p_ME.y(), 0)), 0, here);
  ground.SetBones(here);
  // Behind all of the module, so that its ground hides the meadow beneath, and before the sky.
  gl_.DepthRange(kModuleDepth, kMeadowDepth);
  BindSurface(kGrass);
  surroundings_.Bind();
  gl_.DrawElements(GL_TRIANGLES, 3 * kSurroundingsTriangles, GL_UNSIGNED_INT, nullptr);
  ++counters_.draw_calls;
  counters_.triangles += kSurroundingsTriangles;
}

void SceneRenderer::DrawRain(const View& view, std::span<const ShiningSpot> spots,
                             const PixelArea& area) {
  overlay_triangles_.clear();
  AppendRain({.rain = snapshot_.weather.rain,
              .time_s = ToSeconds(snapshot_.time.time_since_epoch()),
              .width = area.width,
              .height = area.height,
              .focal_px = pixels_per_radian_},
             view, lighting_, spots, module_ == nullptr ? nullptr : &module_->probe(),
             overlay_triangles_);
  if (overlay_triangles_.empty()) return;
  gl_.UseProgram(overlay_program_.id());
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthMask(GL_FALSE);
  overlay_.Draw(overlay_triangles_);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_CULL_FACE);
  ++counters_.draw_calls;
  counters_.triangles += static_cast<int>(overlay_triangles_.size() / 3);
}

void SceneRenderer::DrawIsectors(const View& view, const PixelArea& area) {
  overlay_triangles_.clear();
  AppendSegments(snapshot_.segments, view, area.width, area.height, overlay_triangles_);
  if (overlay_triangles_.empty()) return;
  gl_.UseProgram(overlay_program_.id());
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  overlay_.Draw(overlay_triangles_);
  gl_.Enable(GL_CULL_FACE);
  gl_.Enable(GL_DEPTH_TEST);
  ++counters_.draw_calls;
  counters_.triangles += static_cast<int>(overlay_triangles_.size() / 3);
}

void SceneRenderer::Collect(const IndexRun& run) {
  if (run.count == 0) return;
  run_counts_.push_back(static_cast<GLsizei>(run.count));
  run_starts_.push_back(BufferOffset(run.first * sizeof(uint32_t)));
  counters_.triangles += static_cast<int>(run.count / 3);
}

/// One call for all runs of the bound mesh, program and texture.
void SceneRenderer::DrawCollected() {
  if (run_counts_.empty()) return;
  gl_.MultiDrawElements(GL_TRIANGLES, run_counts_.data(), GL_UNSIGNED_INT, run_starts_.data(),
                        static_cast<GLsizei>(run_counts_.size()));
  ++counters_.draw_calls;
  run_counts_.clear();
  run_starts_.clear();
}

void SceneRenderer::BindSurface(int texture) {
  gl_.ActiveTexture(SurfaceProgram::kTextureUnit);
  gl_.BindTexture(GL_TEXTURE_2D, surfaces_.at(static_cast<size_t>(texture)).id());
}

}  // namespace eod::sim
