#include "sim/isectors/isector_set.h"

namespace eod::sim {

namespace {

IsectorSegment LineOf(const SegmentSpec& segment) {
  return {.start = segment.start,
          .direction = segment.direction,
          .length = segment.length,
          .enabled = segment.enabled};
}

Isector MakeIsector(const IsectorSpec& spec, uint32_t module_bits) {
  std::vector<IsectorSegment> segments;
  for (const SegmentSpec& segment : spec.segments) segments.push_back(LineOf(segment));
  Isector isector(spec.name, spec.method, std::move(segments));
  isector.set_class_mask(module_bits | spec.class_mask);
  isector.set_face_rule(spec.face_rule);
  isector.set_hit_rule(spec.hit_rule);
  return isector;
}

}  // namespace

IsectorSet::IsectorSet(const RobotModel& model, uint32_t module_bit, Coverage coverage,
                       const IsectorRules& rules)
    : model_(model), coverage_(coverage), rules_(rules) {
  size_t most = 0;
  for (const IsectorSpec& spec : model.isectors) {
    if (spec.method == IsectorMethod::kTripod) tripod_ = static_cast<int>(isectors_.size());
    isectors_.push_back(MakeIsector(spec, rules.module_masks ? module_bit : kAnyModule));
    most += spec.segments.size();
  }
  segments_.reserve(most);
  batch_.Reserve(most);
}

void IsectorSet::Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML,
                      MotionSet commanded, int64_t step) {
  commanded |= kAlways;
  step_ = step;
  for (size_t i = 0; i < isectors_.size(); ++i) Place(static_cast<int>(i), X_ML, commanded);
  batch_.CastIsectors(isectors_, world, step);
  segments_.clear();
  for (size_t i = 0; i < batch_.queries().size(); ++i) {
    segments_.push_back(
        {batch_.IsectorOf(i), batch_.SegmentOf(i), batch_.queries()[i], batch_.hits()[i]});
  }
  const bool stands = tripod_ >= 0 && isectors_[tripod_].IsFresh(step);
  ground_ = stands ? ReadTripod(isectors_[tripod_], step) : GroundFix{};
}

void IsectorSet::Reload(int isector) {
  const IsectorSpec& spec = model_.isectors.at(isector);
  for (size_t i = 0; i < spec.segments.size(); ++i) {
    isectors_[isector].SetSegment(static_cast<int>(i), LineOf(spec.segments[i]));
  }
}

/// Puts an isector where its link is, with the segments that `commanded` loads.
void IsectorSet::Place(int index, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded) {
  const IsectorSpec& spec = model_.isectors[index];
  Isector& isector = isectors_[index];
  const auto is_loaded = [&](MotionSet motions) {
    return !rules_.dynamic_loading || (motions & commanded) != 0;
  };
  const bool exists = !spec.extended || coverage_ == Coverage::kExtended;
  isector.set_enabled(exists && is_loaded(spec.motions));
  if (!isector.enabled()) return;
  isector.set_pose(X_ML[spec.link] * spec.X_LI);
  for (size_t i = 0; i < spec.segments.size(); ++i) {
    const SegmentSpec& segment = spec.segments[i];
    const bool silenced = (segment.motions & ~silenced_) == 0;
    isector.EnableSegment(static_cast<int>(i),
                          segment.enabled && !silenced && is_loaded(segment.motions));
  }
}

}  // namespace eod::sim
