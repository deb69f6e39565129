#include "sim/isectors/isector_set.h"

#include <cmath>

namespace eod::sim {

namespace {

using Eigen::Vector3d;

bool IsVertical(IsectorMethod method) {
  return method != IsectorMethod::kVolume && method != IsectorMethod::kLos &&
         method != IsectorMethod::kBump;
}

/// The frame that an isector's lines are given in: TRIPOD and the height isectors turn with the
/// heading alone, so that their lines stay vertical.
Eigen::Isometry3d SegmentFrame(const IsectorSpec& isector, const Eigen::Isometry3d& X_ML) {
  Eigen::Isometry3d X_MI = X_ML * isector.X_LI;
  if (IsVertical(isector.method)) {
    X_MI.linear() = ToRotation({.heading = ToAttitude(X_MI.linear()).heading});
  }
  return X_MI;
}

}  // namespace

IsectorSet::IsectorSet(const RobotModel& model, uint32_t module_bit, Coverage coverage)
    : model_(model), module_bit_(module_bit), coverage_(coverage) {
  size_t most = 0;
  for (const IsectorSpec& isector : model.isectors) most += isector.segments.size();
  segments_.reserve(most);
  queries_.reserve(most);
  hits_.reserve(most);
}

bool IsectorSet::IsActive(const IsectorSpec& isector, MotionSet commanded) const {
  if (isector.extended && coverage_ == Coverage::kPaper) return false;
  return (isector.motions & commanded) != 0;
}

void IsectorSet::Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML,
                      MotionSet commanded) {
  commanded |= kAlways;
  segments_.clear();
  queries_.clear();
  for (size_t i = 0; i < model_.isectors.size(); ++i) {
    if (IsActive(model_.isectors[i], commanded)) LoadIsector(i, X_ML, commanded);
  }
  hits_.resize(queries_.size());
  memory_.counters = {};
  world.Cast(queries_, hits_, memory_);
  for (size_t i = 0; i < segments_.size(); ++i) segments_[i].hit = hits_[i];
  FixGround(X_ML);
}

void IsectorSet::LoadIsector(size_t index, std::span<const Eigen::Isometry3d> X_ML,
                             MotionSet commanded) {
  const IsectorSpec& isector = model_.isectors[index];
  const Eigen::Isometry3d X_MI = SegmentFrame(isector, X_ML[static_cast<size_t>(isector.link)]);
  for (size_t i = 0; i < isector.segments.size(); ++i) {
    const SegmentSpec& segment = isector.segments[i];
    if ((segment.motions & commanded) == 0) continue;
    const SegmentQuery query{
        .start = X_MI * segment.start,
        .direction = X_MI.linear() * segment.direction,
        .length = segment.length,
        .class_mask = module_bit_ | isector.class_mask,
        .hit_rule = IsVertical(isector.method) ? HitRule::kHighest : HitRule::kNearest,
        .face_rule = FaceRule::kTwoSided,
        .group = static_cast<uint32_t>(index)};
    segments_.push_back({static_cast<int>(index), static_cast<int>(i), query, {}});
    queries_.push_back(query);
  }
}

void IsectorSet::FixGround(std::span<const Eigen::Isometry3d> X_ML) {
  ground_ = {};
  std::array<Vector3d, 3> feet;
  const IsectorSpec* tripod = nullptr;
  double offsets = 0;
  for (const CastSegment& cast : segments_) {
    const IsectorSpec& isector = model_.isectors[static_cast<size_t>(cast.isector)];
    if (isector.method != IsectorMethod::kTripod) continue;
    tripod = &isector;
    if (!cast.hit.hit) continue;
    feet[static_cast<size_t>(ground_.legs++)] = cast.hit.point;
    // The robot's own plane at this leg: through its origin, square to its up axis.
    const Eigen::Isometry3d X_MI = X_ML[static_cast<size_t>(isector.link)] * isector.X_LI;
    const Vector3d up = X_MI.linear().col(2), d = cast.hit.point - X_MI.translation();
    const double foot = -(up.x() * d.x() + up.y() * d.y()) / up.z();
    offsets += d.z() - foot;
  }
  if (tripod == nullptr || ground_.legs == 0) return;
  const Eigen::Isometry3d X_MI = X_ML[static_cast<size_t>(tripod->link)] * tripod->X_LI;
  ground_.mean_offset = offsets / ground_.legs;
  ground_.height = X_MI.translation().z() + ground_.mean_offset;
  if (ground_.legs < 3) return;
  Vector3d n = (feet[1] - feet[0]).cross(feet[2] - feet[0]).normalized();
  if (n.z() < 0) n = -n;
  ground_.normal = n;
  const Vector3d d = X_MI.translation() - feet[0];
  ground_.height = feet[0].z() - (n.x() * d.x() + n.y() * d.y()) / n.z();
}

}  // namespace eod::sim
