#include "tests/unit/camera/offline_camera.h"

namespace eod::sim {

OfflineCamera::OfflineCamera(const RobotModel& robot, const WorldModel& world, int width,
                             int height)
    : robot_(robot),
      context_(MakeOsMesaContext()),
      renderer_(context_->gl(), robot, world),
      target_(context_->gl(), width, height) {}

// What is about to be deleted belongs to this context, even if another one was made meanwhile.
OfflineCamera::~OfflineCamera() { context_->MakeCurrent(); }

const std::vector<uint8_t>& OfflineCamera::Take(const SceneSnapshot& snapshot,
                                                const std::string& camera) {
  context_->MakeCurrent();
  renderer_.Prepare(snapshot);
  counters_ = renderer_.Draw(FindCamera(robot_, camera), target_);
  target_.Read(pixels_);
  return pixels_;
}

}  // namespace eod::sim
