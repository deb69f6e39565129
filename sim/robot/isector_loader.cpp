#include <fmt/format.h>

#include "sim/robot/robot_parts.h"
#include "sim/robot/vocabulary.h"

namespace eod::sim {

namespace {

SegmentSpec ReadGroundLine(const CustomElement& element, const RobotModel& model) {
  element.AllowAttributes({"name", "start", "enabled"});
  const double length = model.step_up_limit + model.fall_search;
  SegmentSpec segment{.name = element.Text("name"),
                      .direction = -Eigen::Vector3d::UnitZ(),
                      .length = length,
                      .motions = kAllMotions | kAlways};
  if (element.Has("start")) segment.start = element.Vector("start");
  segment.start.z() += model.step_up_limit;
  segment.enabled = FlagOf(element, "enabled", true);
  return segment;
}

SegmentSpec ReadFeeler(const CustomElement& element) {
  element.AllowAttributes(
      {"name", "start", "direction", "length", "d0", "skin", "motions", "blocks", "enabled"});
  SegmentSpec segment{.name = element.Text("name"),
                      .direction = element.Vector("direction"),
                      .length = element.Number("length", 0.001, 1000),
                      .d0 = element.Number("d0", 0, 10),
                      .skin = element.Number("skin", 0, 10),
                      .motions = kAllMotions | kAlways};
  if (element.Has("start")) segment.start = element.Vector("start");
  if (element.Has("motions")) segment.motions = MotionsOf(element, "motions");
  if (element.Has("blocks")) segment.blocks = MotionsOf(element, "blocks");
  segment.enabled = FlagOf(element, "enabled", true);
  if (std::abs(segment.direction.norm() - 1) > 1e-6) {
    element.Fail(fmt::format("direction of <eod:segment> {}: length {}, needs 1", segment.name,
                             segment.direction.norm()));
  }
  segment.direction.normalize();
  if (segment.length < segment.d0 + 0.10) {
    element.Fail(fmt::format("length {} of <eod:segment> {}: needs d0 + 0.10 m = {} or more",
                             segment.length, segment.name, segment.d0 + 0.10));
  }
  return segment;
}

bool IsExtended(const CustomElement& element) {
  if (!element.Has("coverage")) return false;
  const std::string& coverage = element.Text("coverage");
  if (coverage != "paper" && coverage != "extended") {
    element.Fail(
        fmt::format("coverage = \"{}\" of <eod:isector>: allowed paper, extended", coverage));
  }
  return coverage == "extended";
}

}  // namespace

IsectorSpec ReadIsector(const CustomElement& element, int link, const RobotModel& model) {
  element.AllowAttributes(
      {"name", "method", "part", "pose", "motions", "coverage", "face", "hit", "classes"});
  AllowElements(element.children, {"segment"}, "isector " + element.Text("name"));
  IsectorSpec isector{.name = element.Text("name"),
                      .method = MethodOf(element, "method"),
                      .link = link,
                      .motions = MotionsOf(element, "motions"),
                      .part = PartOf(element, "part"),
                      .extended = IsExtended(element),
                      .segments = {}};
  if (element.Has("pose")) isector.X_LI = element.Pose("pose");
  const bool ground = LooksForGround(isector.method);
  isector.class_mask =
      element.Has("classes") ? ClassesOf(element, "classes") : UsualClasses(isector.method);
  isector.hit_rule = ground ? HitRule::kHighest : HitRule::kNearest;
  if (element.Has("hit")) isector.hit_rule = HitRuleOf(element, "hit");
  if (element.Has("face")) isector.face_rule = FaceRuleOf(element, "face");
  for (const CustomElement& child : element.children) {
    isector.segments.push_back(ground ? ReadGroundLine(child, model) : ReadFeeler(child));
  }
  const auto [fewest, most] = SegmentCountOf(isector.method);
  if (isector.segments.size() < fewest || isector.segments.size() > most) {
    element.Fail(fmt::format("isector {}: {} segments, method {} has {}..{}", isector.name,
                             isector.segments.size(), element.Text("method"), fewest, most));
  }
  const auto& legs = isector.segments;
  if (isector.method == IsectorMethod::kTripod &&
      StandInOneLine(legs[0].start, legs[1].start, legs[2].start)) {
    element.Fail(fmt::format("isector {}: its legs stand in one line, method tripod needs a plane",
                             isector.name));
  }
  return isector;
}

}  // namespace eod::sim
