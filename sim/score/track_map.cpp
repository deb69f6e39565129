#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sim/score/score_page.h"

namespace eod::sim {
namespace {

constexpr double kWidth = 760, kMaxHeight = 480;  // [px]
constexpr double kEdge = 1.0;                     // [m] around everything

/// Local metres to pixels: x to the right, y up.
struct Sheet {
  Eigen::AlignedBox<double, 2> area;
  double scale = 1;  // [px/m]
  double height = 0;

  explicit Sheet(const ScoreSheet& sheet) {
    for (const Eigen::Vector2d& point : sheet.track) area.extend(point);
    for (const SheetPlace& place : sheet.places) area.extend(place.position);
    area.min().array() -= kEdge;
    area.max().array() += kEdge;
    const Eigen::Vector2d size = area.sizes();
    scale = std::min(kWidth / size.x(), kMaxHeight / size.y());
    // A narrow way is shown in the middle of the full width.
    const double more = kWidth / scale - size.x();
    area.min().x() -= more / 2;
    area.max().x() += more / 2;
    height = size.y() * scale;
  }
  double X(double x) const { return (x - area.min().x()) * scale; }
  double Y(double y) const { return height - (y - area.min().y()) * scale; }
};

/// Distance of the grid's lines [m]: 1, 2, 5, 10, ... of which about ten fit.
double GridStep(const Sheet& sheet) {
  const double wanted = sheet.area.sizes().maxCoeff() / 10;
  const double decade = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= wanted) return factor * decade;
  }
  return 10 * decade;
}

std::string Grid(const Sheet& sheet) {
  const double step = GridStep(sheet);
  std::string svg = "<g class=\"grid\">";
  for (double x = std::ceil(sheet.area.min().x() / step) * step; x < sheet.area.max().x();
       x += step) {
    svg += fmt::format("<path d=\"M{:.1f} 0V{:.1f}\"/>", sheet.X(x), sheet.height);
  }
  for (double y = std::ceil(sheet.area.min().y() / step) * step; y < sheet.area.max().y();
       y += step) {
    svg += fmt::format("<path d=\"M0 {:.1f}H{:.0f}\"/>", sheet.Y(y), kWidth);
  }
  const double length = step * sheet.scale;
  return svg + fmt::format(
                   "</g><g class=\"scale\"><path d=\"M14 {0:.1f}h{1:.1f}\"/>"
                   "<text x=\"{2:.1f}\" y=\"{3:.1f}\">{4:g} m</text></g>",
                   sheet.height - 12, length, 20 + length, sheet.height - 8, step);
}

std::string Places(const Sheet& sheet, const std::vector<SheetPlace>& places) {
  std::string svg = "<g class=\"place\">";
  for (const SheetPlace& place : places) {
    const double x = sheet.X(place.position.x()), y = sheet.Y(place.position.y());
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>",
        x - 4, y - 4, x + 8, y + 4, EscapeHtml(place.name));
  }
  return svg + "</g>";
}

std::string Way(const Sheet& sheet, const std::vector<Eigen::Vector2d>& track) {
  std::string svg = "<polyline class=\"way\" points=\"";
  for (const Eigen::Vector2d& point : track) {
    svg += fmt::format("{:.1f},{:.1f} ", sheet.X(point.x()), sheet.Y(point.y()));
  }
  const Eigen::Vector2d& start = track.front();
  const Eigen::Vector2d& end = track.back();
  return svg + fmt::format(
                   "\"/><circle class=\"start\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/>"
                   "<circle class=\"end\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/>",
                   sheet.X(start.x()), sheet.Y(start.y()), sheet.X(end.x()), sheet.Y(end.y()));
}

/// Marks with the number that the event has in the table; those at one place share a mark.
std::string Events(const Sheet& sheet, const std::vector<SheetEvent>& events) {
  std::string svg;
  std::vector<Eigen::Vector2d> taken;
  for (size_t i = 0; i < events.size(); ++i) {
    const SheetEvent& event = events[i];
    if (event.points == 0 && event.part != "failure") continue;
    Eigen::Vector2d at(sheet.X(event.position.x()), sheet.Y(event.position.y()));
    const auto crowds = [&](const Eigen::Vector2d& other) { return (other - at).norm() < 17; };
    // Beside the marks that are there already, in a row to the right.
    while (std::any_of(taken.begin(), taken.end(), crowds) && at.x() < kWidth - 18) at.x() += 18;
    taken.push_back(at);
    const bool gained = event.points > 0;
    svg += fmt::format(
        "<g class=\"mark {0}\"><title>{4}</title><circle cx=\"{1:.1f}\" cy=\"{2:.1f}\" "
        "r=\"8.5\"/><text x=\"{1:.1f}\" y=\"{5:.1f}\">{3}</text></g>",
        gained ? "good" : "bad", at.x(), at.y(), i + 1, EscapeHtml(event.text), at.y() + 3.5);
  }
  return svg;
}

}  // namespace

std::string ToMap(const ScoreSheet& score) {
  if (score.track.empty()) return {};
  const Sheet sheet(score);
  return fmt::format(
             "<svg viewBox=\"0 0 {:.0f} {:.1f}\" role=\"img\" aria-label=\"The robot's way\">",
             kWidth, sheet.height) +
         Grid(sheet) + Places(sheet, score.places) + Way(sheet, score.track) +
         Events(sheet, score.events) + "</svg>";
}

}  // namespace eod::sim
