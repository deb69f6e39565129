#include <algorithm>

#include "sim/robot/robot_model.h"

namespace eod::sim {

namespace {

template <typename Named>
int IndexOfName(const std::vector<Named>& list, std::string_view name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [name](const Named& one) { return one.name == name; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

double Coordinate(const LinkSpec& link, const RobotState& state) {
  switch (link.hand) {
    case LinkSpec::Hand::kLeft:
      return link.scale * state.left_opening;
    case LinkSpec::Hand::kRight:
      return link.scale * state.right_opening;
    default:
      return link.joint < 0 ? 0.0 : link.scale * state.joint[static_cast<size_t>(link.joint)];
  }
}

Eigen::Isometry3d PoseInParent(const LinkSpec& link, const RobotState& state) {
  switch (link.kind) {
    case LinkSpec::Kind::kRevolute:
      return link.X_PL * Eigen::AngleAxisd(Coordinate(link, state), link.axis);
    case LinkSpec::Kind::kPrismatic:
      return link.X_PL * Eigen::Translation3d(Coordinate(link, state) * link.axis);
    default:
      return link.X_PL;
  }
}

}  // namespace

int FindLink(const RobotModel& model, std::string_view name) {
  return IndexOfName(model.links, name);
}

int FindIsector(const RobotModel& model, std::string_view name) {
  return IndexOfName(model.isectors, name);
}

RobotState HomeState(const RobotModel& model) {
  RobotState state;
  for (size_t i = 0; i < kJointCount; ++i) state.joint[i] = model.joints[i].home;
  state.left_opening = state.right_opening = state.joint[kGripperOpening];
  return state;
}

void LinkPoses(const RobotModel& model, const RobotState& state,
               std::vector<Eigen::Isometry3d>& poses) {
  poses.resize(model.links.size());
  poses[0].linear() = ToRotation(state.attitude);
  poses[0].translation() = state.position;
  poses[0].makeAffine();
  for (size_t i = 1; i < model.links.size(); ++i) {
    const LinkSpec& link = model.links[i];
    poses[i] = poses[static_cast<size_t>(link.parent)] * PoseInParent(link, state);
  }
}

}  // namespace eod::sim
