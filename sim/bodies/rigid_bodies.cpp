#include "sim/bodies/rigid_bodies.h"

#include "sim/bodies/bullet_engine.h"

namespace eod::sim {

RigidBodies::RigidBodies(const ModuleModel& module, const RobotModel& robot)
    : engine_(std::make_unique<Engine>(module, robot)) {}

RigidBodies::~RigidBodies() = default;

void RigidBodies::Reset() { engine_->Reset(); }

void RigidBodies::SetStart(int body, const std::optional<Eigen::Isometry3d>& X_MO) {
  engine_->SetStart(body, X_MO);
}

void RigidBodies::Step(double dt_s, std::span<const Eigen::Isometry3d> X_ML) {
  engine_->Step(dt_s, X_ML);
}

std::span<const BodyState> RigidBodies::states() const { return engine_->states(); }

void RigidBodies::Hold(int body) { engine_->Hold(body); }

void RigidBodies::MoveHeld(int body, const Eigen::Isometry3d& X_MO) {
  engine_->MoveHeld(body, X_MO);
}

void RigidBodies::Release(int body) { engine_->Release(body); }

void RigidBodies::Remove(int body) { engine_->Remove(body); }

void RigidBodies::Push(int body, const Eigen::Vector3d& impulse_M, const Eigen::Vector3d& p_M) {
  engine_->Push(body, impulse_M, p_M);
}

}  // namespace eod::sim
