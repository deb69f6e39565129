#include "sim/camera/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/camera/isector_overlay.h"
#include "sim/camera/shaders.h"
#include "sim/camera/surface_textures.h"

namespace eod::sim {
namespace {

constexpr double kShadowHalfSide = 15;  // [m]
constexpr double kShadowAhead = 7;   // [m] its middle lies before the robot: that way cameras look
constexpr float kFineDistance = 12;  // [m] within which shapes are drawn in full detail
constexpr double kModuleDepth = 0.9999;  // share of the depth buffer for all near things
constexpr double kMeadowDepth = 0.99999;
constexpr int kGrass = 1;  // in kSurfaceTextures

/// Meadow around the module, out to where fog hides it: rings around the camera's own place.
SurfaceMesh MakeSurroundings() {
  constexpr std::array kRadii{40.0, 200.0, 2500.0};
  constexpr int kSides = 16;
  Visual meadow;
  meadow.shape = Visual::Shape::kMesh;
  meadow.material.diffuse = Eigen::Vector3f::Ones();
  const auto rim = [](double radius, int side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0)
        .cast<float>()
        .eval();
  };
  double inner = 0;
  for (const double outer : kRadii) {
    for (int side = 0; side < kSides; ++side) {
      const std::array corners{rim(inner, side), rim(outer, side), rim(outer, side + 1),
                               rim(inner, side + 1)};
      for (const size_t corner : {0, 1, 2, 0, 2, 3}) meadow.triangles.push_back(corners[corner]);
    }
    inner = outer;
  }
  SurfaceMesh mesh;
  AppendVisual(meadow, Eigen::Isometry3d::Identity(), 0, {}, mesh);
  return mesh;
}
constexpr GLsizei kSurroundingsIndices = 16 * 3 * (1 + 2 + 2);

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

SceneRenderer::SceneRenderer(const GlFunctions& gl, const RobotModel& robot,
                             const WorldModel& world)
    : gl_(gl),
      robot_(robot),
      world_(world),
      surfaces_(UploadSurfaces(gl)),
      variation_(UploadSurface(gl, PaintGroundVariation())),
      shadow_map_(gl),
      shadow_program_(gl),
      textured_(gl, SurfaceProgram::Kind::kTextured, world.atmosphere),
      ground_(gl, SurfaceProgram::Kind::kGround, world.atmosphere),
      sky_(gl, world.atmosphere),
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
  bones_.resize(3 * (robot.links.size() + 1));
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
}

void SceneRenderer::LoadModule(int module) {
  module_.reset();
  module_id_ = module;
  const auto found = std::find_if(world_.modules.begin(), world_.modules.end(),
                                  [&](const ModuleModel& model) { return model.id == module; });
  if (found == world_.modules.end()) return;
  DrawList list = BuildWorldDrawList(*found);
  DrawList movables = BuildMovablesDrawList(*found);
  GpuMesh mesh(gl_, list.mesh);
  GpuMesh movables_mesh(gl_, movables.mesh);
  // Only the ranges are needed from here on.
  list.mesh = {};
  movables.mesh = {};
  module_ = std::make_unique<ModuleScene>(ModuleScene{&*found, std::move(list), std::move(mesh),
                                                      std::move(movables), std::move(movables_mesh),
                                                      BonePalette(3 * found->movables.size())});
}

void SceneRenderer::PoseMovables() {
  if (module_ == nullptr) return;
  const std::vector<MovableObject>& movables = module_->model->movables;
  for (size_t i = 0; i < movables.size(); ++i) {
    const bool is_told = i < snapshot_.movables.size();
    if (is_told && !snapshot_.movables[i].is_visible) {
      HideBone(i, module_->movables_bones);
    } else {
      SetBone(is_told ? snapshot_.movables[i].X_MO : movables[i].X_MO, i, module_->movables_bones);
    }
  }
}

void SceneRenderer::Prepare(const SceneSnapshot& snapshot) {
  snapshot_ = snapshot;
  const bool is_new_module = snapshot.module != module_id_;
  if (is_new_module) LoadModule(snapshot.module);
  LinkPoses(robot_, snapshot.state, X_ML_);
  SetBone(Eigen::Isometry3d::Identity(), 0, bones_);
  for (size_t link = 0; link < X_ML_.size(); ++link) SetBone(X_ML_[link], link + 1, bones_);
  PoseMovables();
  // What stands still throws the shadow that is there already.
  if (!is_new_module && snapshot.state == shadow_state_ && snapshot.movables == shadow_movables_) {
    return;
  }
  shadow_state_ = snapshot.state;
  shadow_movables_ = snapshot.movables;
  DrawShadow();
}

void SceneRenderer::DrawShadow() {
  const Eigen::Matrix3d R_MB = ToRotation(snapshot_.state.attitude);
  sun_ = MakeSunView(world_.atmosphere.sun_direction.cast<double>(),
                     snapshot_.state.position + kShadowAhead * R_MB.col(1), kShadowHalfSide,
                     ShadowMap::kSide);
  counters_ = {};
  shadow_map_.Bind();
  gl_.DepthRange(0.0, 1.0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5F, 4.0F);
  if (module_ != nullptr && !module_->movables_list.ranges.empty()) {
    shadow_program_.Use(sun_, module_->movables_bones);
    module_->movables_mesh.Bind();
    for (const DrawRange& range : module_->movables_list.ranges) DrawRun(range.coarse);
  }
  shadow_program_.Use(sun_, bones_);
  robot_mesh_.Bind();
  for (const DrawRange& range : robot_list_.ranges) DrawRun(range.coarse);
  if (module_ != nullptr) {
    const Frustum lit(sun_);
    module_->mesh.Bind();
    for (const DrawRange& range : module_->list.ranges) {
      if (range.casts_shadow && lit.MaySee(range.bounds)) DrawRun(range.coarse);
    }
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  shadow_counters_ = counters_;
}

DrawCounters SceneRenderer::Draw(const CameraSpec& camera, const RenderTarget& target) {
  const Lens lens{.horizontal_fov = camera.horizontal_fov,
                  .aspect = static_cast<double>(target.width()) / target.height(),
                  .near = camera.near};
  const Eigen::Isometry3d X_MC =
      X_ML_.at(static_cast<size_t>(camera.link)) * camera.X_LC * ShakeOf(snapshot_.effects);
  counters_ = shadow_counters_;
  target.Bind();
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  // Nothing is seen behind a dead feed.
  if (snapshot_.effects.noise < 1) {
    const View view = MakeCameraView(X_MC, lens);
    DrawScene(view);
    gl_.DepthRange(0.0, kModuleDepth);
    if (const int triangles = plume_.Draw(snapshot_.quads, X_MC, lens); triangles > 0) {
      counters_.triangles += triangles;
      ++counters_.draw_calls;
    }
    DrawIsectors(view, target);
  }
  effects_.Draw(snapshot_.effects, target.height());
  return counters_;
}

void SceneRenderer::DrawScene(const View& view) {
  gl_.ActiveTexture(SurfaceProgram::kVariationUnit);
  gl_.BindTexture(GL_TEXTURE_2D, variation_.id());
  gl_.ActiveTexture(SurfaceProgram::kShadowUnit);
  gl_.BindTexture(GL_TEXTURE_2D, shadow_map_.texture());

  gl_.DepthRange(0.0, kModuleDepth);
  // Near things first: what they hide is not shaded.
  textured_.Use(view, sun_);
  DrawThings(textured_);
  DrawWorld(view, false);
  ground_.Use(view, sun_);
  ground_.SetBones(bones_);
  DrawWorld(view, true);
  DrawSurroundings(view);
  counters_.triangles += sky_.Draw(view);
  ++counters_.draw_calls;
}

/// The robot and what is movable. Leaves the robot's bones, whose first is the static world.
void SceneRenderer::DrawThings(const SurfaceProgram& program) {
  const auto draw = [&](const DrawList& list, const GpuMesh& mesh, const BonePalette& bones) {
    program.SetBones(bones);
    mesh.Bind();
    for (const DrawRange& range : list.ranges) {
      BindSurface(range.texture);
      DrawRun(range.fine);
    }
  };
  if (module_ != nullptr && !module_->movables_list.ranges.empty()) {
    draw(module_->movables_list, module_->movables_mesh, module_->movables_bones);
  }
  draw(robot_list_, robot_mesh_, bones_);
}

void SceneRenderer::DrawWorld(const View& view, bool ground) {
  if (module_ == nullptr) return;
  const Frustum frustum(view);
  const Eigen::Vector3f eye = view.p_ME.cast<float>();
  module_->mesh.Bind();
  for (const DrawRange& range : module_->list.ranges) {
    if ((range.texture == kGrass) != ground || !frustum.MaySee(range.bounds)) continue;
    const bool is_near = range.bounds.exteriorDistance(eye) < kFineDistance;
    BindSurface(range.texture);
    DrawRun(is_near ? range.fine : range.coarse);
  }
}

void SceneRenderer::DrawSurroundings(const View& view) {
  BonePalette here(3);
  SetBone(Eigen::Isometry3d(Eigen::Translation3d(view.p_ME.x(), view.p_ME.y(), 0)), 0, here);
  ground_.SetBones(here);
  // Behind all of the module, so that its ground hides the meadow beneath, and before the sky.
  gl_.DepthRange(kModuleDepth, kMeadowDepth);
  BindSurface(kGrass);
  surroundings_.Bind();
  gl_.DrawElements(GL_TRIANGLES, kSurroundingsIndices, GL_UNSIGNED_INT, nullptr);
  ++counters_.draw_calls;
  counters_.triangles += kSurroundingsIndices / 3;
}

void SceneRenderer::DrawIsectors(const View& view, const RenderTarget& target) {
  overlay_triangles_.clear();
  AppendSegments(snapshot_.segments, view, target.width(), target.height(), overlay_triangles_);
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

void SceneRenderer::DrawRun(const IndexRun& run) {
  if (run.count == 0) return;
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.count), GL_UNSIGNED_INT,
                   BufferOffset(run.first * sizeof(uint32_t)));
  ++counters_.draw_calls;
  counters_.triangles += static_cast<int>(run.count / 3);
}

void SceneRenderer::BindSurface(int texture) {
  gl_.ActiveTexture(SurfaceProgram::kTextureUnit);
  gl_.BindTexture(GL_TEXTURE_2D, surfaces_.at(static_cast<size_t>(texture)).id());
}

}  // namespace eod::sim
