#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/robot/robot_parts.h"
#include "sim/robot/vocabulary.h"

namespace eod::sim {

namespace {

constexpr int kDriveMotions = 4;

int IndexIn(const std::vector<SdfLink>& links, const std::string& name) {
  const auto found = std::find_if(links.begin(), links.end(),
                                  [&name](const SdfLink& link) { return link.name == name; });
  return found == links.end() ? -1 : static_cast<int>(found - links.begin());
}

LinkSpec::Kind KindOf(const SdfJoint& joint, const std::filesystem::path& file) {
  if (joint.type == "fixed") return LinkSpec::Kind::kFixed;
  if (joint.type == "revolute") return LinkSpec::Kind::kRevolute;
  if (joint.type == "prismatic") return LinkSpec::Kind::kPrismatic;
  FailAt(
      file, joint.line,
      fmt::format("joint {}: type {}, allowed fixed, revolute, prismatic", joint.name, joint.type));
}

LinkSpec ToLinkSpec(const SdfModel& sdf, const SdfJoint& joint, int parent, int parent_in_sdf,
                    const std::filesystem::path& file) {
  if (!joint.X_LJ.isApprox(Eigen::Isometry3d::Identity(), 1e-12)) {
    FailAt(file, joint.line,
           fmt::format("joint {}: has a pose; put the child link's origin there", joint.name));
  }
  const SdfLink& child = sdf.links[static_cast<size_t>(IndexIn(sdf.links, joint.child))];
  const SdfLink& above = sdf.links[static_cast<size_t>(parent_in_sdf)];
  LinkSpec link;
  link.name = child.name;
  link.parent = parent;
  link.X_PL = above.X_ML.inverse() * child.X_ML;
  link.kind = KindOf(joint, file);
  link.axis = joint.axis;
  return link;
}

JointSpec ReadJoint(const SdfJoint& joint, const CustomElement& motion) {
  const bool turns = joint.type == "revolute";
  const std::string home = turns ? "home_deg" : "home_m";
  const std::string acceleration = turns ? "accel_deg_per_s2" : "accel_mps2";
  motion.AllowAttributes({"index", "positive", "negative", home, acceleration});
  JointSpec spec{.name = joint.name,
                 .lower = joint.lower,
                 .upper = joint.upper,
                 .rate = joint.velocity,
                 .home = motion.Number(home, -360, 360),
                 .positive_motion = MotionOf(motion, "positive"),
                 .negative_motion = MotionOf(motion, "negative")};
  const double unit = turns ? std::numbers::pi / 180 : 1;
  spec.home *= unit;
  if (motion.Has(acceleration)) spec.acceleration = motion.Number(acceleration, 0.01, 1e4) * unit;
  if (!(spec.lower < spec.upper) || !std::isfinite(spec.upper - spec.lower)) {
    motion.Fail(
        fmt::format("joint {}: limits {}..{} leave no room", joint.name, spec.lower, spec.upper));
  }
  if (!(spec.rate > 0) || !std::isfinite(spec.rate)) {
    motion.Fail(fmt::format("joint {}: rate {}, needs <velocity> above 0 in <limit>", joint.name,
                            spec.rate));
  }
  if (spec.home < spec.lower - 1e-9 || spec.home > spec.upper + 1e-9) {
    motion.Fail(fmt::format("joint {}: home {} outside its limits {}..{}", joint.name, spec.home,
                            spec.lower, spec.upper));
  }
  if (spec.positive_motion != (spec.negative_motion ^ 1) || spec.positive_motion < kDriveMotions) {
    motion.Fail(fmt::format("joint {}: {} and {} are no pair of joint motions", joint.name,
                            motion.Text("positive"), motion.Text("negative")));
  }
  return spec;
}

void SetFollower(const CustomElement& follows, int joint, LinkSpec& link) {
  link.joint = joint;
  if (follows.Has("scale")) link.scale = follows.Number("scale", -10, 10);
  if (!follows.Has("hand")) return;
  const std::string& hand = follows.Text("hand");
  if (hand != "left" && hand != "right") {
    follows.Fail(fmt::format("hand = \"{}\" of <eod:{}>: allowed left, right", hand, follows.name));
  }
  link.hand = hand == "left" ? LinkSpec::Hand::kLeft : LinkSpec::Hand::kRight;
}

/// Links that copy another joint: the second hand and the crossbeam.
void ReadFollowers(const SdfModel& sdf, const std::array<JointSpec, kJointCount>& joints,
                   const std::vector<std::vector<LinkSpec>::iterator>& moved) {
  for (size_t i = 0; i < sdf.joints.size(); ++i) {
    const CustomElement* follows = FindElement(sdf.joints[i].customs, "follows");
    if (follows == nullptr) continue;
    follows->AllowAttributes({"joint", "scale", "hand"});
    const std::string& leader = follows->Text("joint");
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const JointSpec& joint) { return joint.name == leader; });
    if (found == joints.end()) {
      follows->Fail(
          fmt::format("joint = \"{}\" of <eod:follows>: no joint with <eod:motion>", leader));
    }
    SetFollower(*follows, static_cast<int>(found - joints.begin()), *moved[i]);
  }
}

void CheckComplete(const std::array<bool, kJointCount>& given, const SdfModel& sdf,
                   const std::filesystem::path& file) {
  std::vector<std::string> missing;
  for (int i = 0; i < kJointCount; ++i) {
    if (!given[static_cast<size_t>(i)]) missing.push_back(fmt::format("J{}", i + 1));
  }
  if (missing.empty()) return;
  FailAt(file, sdf.line,
         fmt::format("model {}: {} joints carry <eod:motion>, {} are needed ({} x 2 + {} = {} "
                     "motions); missing: {}",
                     sdf.name, kJointCount - static_cast<int>(missing.size()), kJointCount,
                     kJointCount, kDriveMotions, kMotionCount, fmt::join(missing, ", ")));
}

}  // namespace

LinkTree ReadLinks(const SdfModel& sdf, const std::filesystem::path& file) {
  LinkTree tree;
  std::vector<int> index(sdf.links.size(), -1);  // by place in the file
  const auto add = [&](int in_sdf, LinkSpec link) {
    index[static_cast<size_t>(in_sdf)] = static_cast<int>(tree.links.size());
    link.mass = sdf.links[static_cast<size_t>(in_sdf)].mass;
    link.p_LC = sdf.links[static_cast<size_t>(in_sdf)].p_LC;
    tree.links.push_back(std::move(link));
    tree.order.push_back(in_sdf);
  };
  if (sdf.links.empty() || sdf.links[0].name != "chassis") {
    FailAt(file, sdf.line, fmt::format("model {}: the first link must be chassis", sdf.name));
  }
  LinkSpec chassis;
  chassis.name = "chassis";
  add(0, std::move(chassis));
  // Each round takes the joints whose parent is known by now; file order within a round.
  for (bool grew = true; grew;) {
    grew = false;
    for (const SdfJoint& joint : sdf.joints) {
      const int child = IndexIn(sdf.links, joint.child), parent = IndexIn(sdf.links, joint.parent);
      if (child < 0 || parent < 0 || index[static_cast<size_t>(parent)] < 0) continue;
      if (index[static_cast<size_t>(child)] >= 0) continue;
      add(child, ToLinkSpec(sdf, joint, index[static_cast<size_t>(parent)], parent, file));
      grew = true;
    }
  }
  for (size_t i = 0; i < sdf.links.size(); ++i) {
    if (index[i] < 0) {
      FailAt(file, sdf.links[i].line,
             fmt::format("link {} hangs on no joint that leads to the chassis", sdf.links[i].name));
    }
  }
  return tree;
}

std::array<JointSpec, kJointCount> ReadJoints(const SdfModel& sdf,
                                              const std::filesystem::path& file,
                                              std::vector<LinkSpec>& links) {
  std::array<JointSpec, kJointCount> joints;
  std::array<bool, kJointCount> given{};
  std::vector<std::vector<LinkSpec>::iterator> moved;  // by place of the joint in the file
  for (const SdfJoint& joint : sdf.joints) {
    AllowElements(joint.customs, {"motion", "follows"}, "joint " + joint.name);
    moved.push_back(std::find_if(links.begin(), links.end(),
                                 [&](const LinkSpec& link) { return link.name == joint.child; }));
    const CustomElement* motion = FindElement(joint.customs, "motion");
    if (motion == nullptr) continue;
    const int index = motion->Integer("index", 1, kJointCount) - 1;
    if (given[static_cast<size_t>(index)]) {
      motion->Fail(fmt::format("joint {}: J{} is {} already", joint.name, index + 1,
                               joints[static_cast<size_t>(index)].name));
    }
    given[static_cast<size_t>(index)] = true;
    joints[static_cast<size_t>(index)] = ReadJoint(joint, *motion);
    moved.back()->joint = index;
  }
  CheckComplete(given, sdf, file);
  MotionSet motions = (1u << kDriveMotions) - 1;
  for (const JointSpec& joint : joints) {
    motions |= SetOf(joint.positive_motion) | SetOf(joint.negative_motion);
  }
  if (motions != kAllMotions) {
    FailAt(file, sdf.line, fmt::format("model {}: two joints share a motion", sdf.name));
  }
  ReadFollowers(sdf, joints, moved);
  return joints;
}

}  // namespace eod::sim
