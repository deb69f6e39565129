#include <numbers>

#include <fmt/format.h>

#include "sim/robot/robot_parts.h"

namespace eod::sim {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Corners y, z of a closed polygon, counter-clockwise seen from +X.
std::vector<Eigen::Vector2d> ReadOutline(const CustomElement& support) {
  const std::vector<double> numbers = support.Numbers("outline");
  if (numbers.size() < 6 || numbers.size() % 2 != 0) {
    support.Fail(fmt::format(
        "outline of <eod:support>: {} numbers, needs y and z of 3 points or more", numbers.size()));
  }
  std::vector<Eigen::Vector2d> outline;
  for (size_t i = 0; i < numbers.size(); i += 2) outline.emplace_back(numbers[i], numbers[i + 1]);
  return outline;
}

void AddPoints(const CustomElement& support, const RobotModel& model,
               std::vector<SupportPoint>& points) {
  support.AllowAttributes({"link", "x", "outline"});
  const int link = FindLink(model, support.Text("link"));
  if (link < 0) {
    support.Fail(fmt::format("link = \"{}\" of <eod:support>: no such link", support.Text("link")));
  }
  const std::vector<Eigen::Vector2d> outline = ReadOutline(support);
  const size_t count = outline.size();
  for (const double x : support.Numbers("x")) {
    const uint32_t group = points.empty() ? 0 : points.back().group + 1;
    for (size_t i = 0; i < count; ++i) {
      // Square to the line between its neighbours.
      const Eigen::Vector2d along = outline[(i + 1) % count] - outline[(i + count - 1) % count];
      if (along.norm() < 1e-6) support.Fail("outline of <eod:support>: turns back on itself");
      points.push_back({.link = link,
                        .p_L = {x, outline[i].x(), outline[i].y()},
                        .n_L = Eigen::Vector3d(0, along.y(), -along.x()).normalized(),
                        .group = group});
    }
  }
}

}  // namespace

StanceSpec ReadStance(const SdfModel& sdf, const RobotModel& model) {
  const CustomElement* stance = FindElement(sdf.customs, "stance");
  if (stance == nullptr) {
    FailAt(model.file, sdf.line, fmt::format("model {} needs <eod:stance>", sdf.name));
  }
  stance->AllowAttributes({"friction", "pitch_limit_deg", "roll_limit_deg", "overturned_deg",
                           "press_on_s", "lift_off_m", "reach_up_m", "reach_down_m", "rise_mps",
                           "rise_per_metre"});
  AllowElements(stance->children, {"support"}, "stance");
  StanceSpec spec;
  spec.friction = stance->Number("friction", 0.05, 2);
  spec.pitch_limit = stance->Number("pitch_limit_deg", 1, 60) * kDegree;
  spec.roll_limit = stance->Number("roll_limit_deg", 1, 60) * kDegree;
  spec.overturned = stance->Number("overturned_deg", 46, 85) * kDegree;
  spec.press_on_s = stance->Number("press_on_s", 0, 10);
  spec.lift_off = stance->Number("lift_off_m", 0.001, 0.1);
  spec.reach_up = stance->Number("reach_up_m", 0.01, 1);
  spec.reach_down = stance->Number("reach_down_m", 0.05, 2);
  spec.rise_speed = stance->Number("rise_mps", 0.01, 10);
  spec.rise_per_metre = stance->Number("rise_per_metre", 0.1, 10);
  for (const CustomElement& support : stance->children) AddPoints(support, model, spec.points);
  if (spec.points.empty()) stance->Fail("<eod:stance> needs at least one <eod:support>");
  double mass = 0;
  for (const LinkSpec& link : model.links) mass += link.mass;
  if (mass <= 0) stance->Fail("the links have no mass, <eod:stance> needs a centre of gravity");
  return spec;
}

}  // namespace eod::sim
