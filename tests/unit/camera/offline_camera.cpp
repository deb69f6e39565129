#include "tests/unit/camera/offline_camera.h"

namespace eod::sim {

OfflineCamera::OfflineCamera(const RobotModel& robot, const WorldModel& world, int width,
                             int height, GlBackend backend, bool draw_data)
    : robot_(robot),
      world_(world),
      width_(width),
      height_(height),
      draw_data_(draw_data),
      context_(MakeGlContext(backend)) {}

// What is about to be deleted belongs to this context, even if another one was made meanwhile.
OfflineCamera::~OfflineCamera() { context_->MakeCurrent(); }

const std::vector<uint8_t>& OfflineCamera::Take(const SceneSnapshot& snapshot,
                                                const std::string& camera) {
  context_->MakeCurrent();
  if (!bare_) {
    bare_.emplace(Bare{SceneRenderer(context_->gl(), robot_, world_),
                       RenderTarget(context_->gl(), width_, height_)});
  }
  bare_->renderer.Prepare(snapshot);
  counters_ = bare_->renderer.Draw(FindCamera(robot_, camera), bare_->target);
  bare_->target.Read(pixels_);
  return pixels_;
}

const std::vector<uint8_t>& OfflineCamera::TakeFinished(const SceneSnapshot& snapshot,
                                                        const std::string& picture) {
  context_->MakeCurrent();
  if (!maker_) maker_.emplace(context_->gl(), robot_, world_, width_, height_, draw_data_);
  maker_->Show(snapshot);
  const std::vector<uint8_t>& pixels = maker_->Make(picture);
  counters_ = maker_->counters();
  return pixels;
}

}  // namespace eod::sim
