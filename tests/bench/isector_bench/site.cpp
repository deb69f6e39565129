#include "tests/bench/isector_bench/site.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/unit/sim/random_scene.h"

namespace eod::bench {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTurn = 20 * std::numbers::pi / 180;
constexpr double kBuried = 1.5;  // [m] how far things reach into the ground

// The stairs on the north side, climbed in -U, 29 degrees steep: the prototype climbs 30.
constexpr int kSteps = 8;
constexpr double kRise = 0.16, kTread = 0.29;
constexpr double kStairsFoot = 6, kStairsEnd = -3.32;  // U of the first and the last riser
constexpr double kLandingFrom = kStairsFoot - (kSteps - 1) * kTread;
constexpr double kLandingTo = kStairsEnd + (kSteps - 1) * kTread;
constexpr double kStairsHalfWidth = 0.6;

/// Ground under a point of S, in M.
double GroundUnder(double u, double v) {
  const Vector3d p_M = SitePose() * Vector3d(u, v, 0);
  return GroundHeight(p_M.x(), p_M.y());
}

/// Height of the level that the stairs stand on.
double StairsBase() { return GroundUnder((kLandingFrom + kLandingTo) / 2, kLoopV); }

/// A box that stands upright, turned by `yaw` against S.
struct Block {
  std::string name;
  Vector2d middle;  // U, V
  Vector2d size;    // along its own axes
  double level;     // height in M that `top` and `bottom` are counted from
  double top;
  double bottom = -kBuried;
  double yaw = 0;
};

SiteObject Place(const Block& block) {
  const double height = block.top - block.bottom;
  Isometry3d X_MO = SitePose() * Eigen::Translation3d(block.middle.x(), block.middle.y(), 0) *
                    Eigen::AngleAxisd(block.yaw, Vector3d::UnitZ());
  X_MO.translation().z() = block.level + (block.top + block.bottom) / 2;
  return {block.name,
          sim::Transformed(X_MO, sim::BoxMesh({block.size.x(), block.size.y(), height}))};
}

/// Something that stands on the ground under its middle.
SiteObject Stand(std::string name, Vector2d middle, Vector2d size, double top, double yaw = 0) {
  return Place({.name = std::move(name),
                .middle = middle,
                .size = size,
                .level = GroundUnder(middle.x(), middle.y()),
                .top = top,
                .yaw = yaw});
}

void AddStairs(std::vector<SiteObject>& objects) {
  const double base = StairsBase();
  for (int i = 0; i < kSteps - 1; ++i) {
    const double top = (i + 1) * kRise;
    for (const double u : {kStairsFoot - (i + 0.5) * kTread, kStairsEnd + (i + 0.5) * kTread}) {
      objects.push_back(Place({"step", {u, kLoopV}, {kTread, 2 * kStairsHalfWidth}, base, top}));
    }
  }
  const double length = kLandingFrom - kLandingTo, middle = (kLandingFrom + kLandingTo) / 2;
  objects.push_back(
      Place({"landing", {middle, kLoopV}, {length, 2 * kStairsHalfWidth}, base, kSteps * kRise}));
  // A wall on the outside all along, a railing on the inside of the landing.
  objects.push_back(Place({"stairs_wall", {1.34, kLoopV + 0.55}, {9.6, 0.1}, base, 2.6}));
  for (double u = kLandingTo; u <= kLandingFrom; u += 0.4)
    objects.push_back(Place({"post", {u, kLoopV - 0.5}, {0.05, 0.05}, base, 2.3}));
  objects.push_back(Place({.name = "rail",
                           .middle = {middle, kLoopV - 0.45},
                           .size = {length, 0.05},
                           .level = base,
                           .top = 1.6,
                           .bottom = 1.3}));
}

/// South side, driven in +U: a wall close on the right, for a while one on the left too, a gate,
/// two kerbs.
void AddSouth(std::vector<SiteObject>& objects) {
  objects.push_back(Stand("wall", {-2.75, -kLoopV - 0.55}, {10, 0.2}, 2.5));
  objects.push_back(Stand("wall", {-4.5, -kLoopV + 0.55}, {5, 0.2}, 1.2));
  for (const double side : {-0.58, 0.58})
    objects.push_back(Stand("gate_post", {3.2, -kLoopV + side}, {0.2, 0.2}, 1.8));
  objects.push_back(Stand("kerb", {6, -kLoopV - 0.48}, {3.6, 0.15}, 0.18));
  objects.push_back(Stand("kerb", {6, -kLoopV + 0.48}, {3.6, 0.15}, 0.18));
}

/// West side, driven in -V: a corridor with a ceiling that the arm comes close to.
void AddWest(std::vector<SiteObject>& objects) {
  objects.push_back(Stand("corridor", {-kLoopU - 0.55, 0.4}, {0.2, 5.8}, 2.2));
  objects.push_back(Stand("corridor", {-kLoopU + 0.55, 0.4}, {0.2, 5.8}, 2.2));
  objects.push_back(Place({.name = "ceiling",
                           .middle = {-kLoopU, 0.4},
                           .size = {1.3, 5.8},
                           .level = GroundUnder(-kLoopU, 0.4),
                           .top = 1.5,
                           .bottom = 1.3}));
}

/// Boxes that somebody left: beside the east side, and all over the rest of the site.
void AddClutter(std::vector<SiteObject>& objects) {
  sim::SeededNumbers numbers(20060304);
  const auto add = [&](double u, double v) {
    const Vector2d size(numbers.Between(0.15, 0.5), numbers.Between(0.15, 0.5));
    objects.push_back(Stand("clutter", {u, v}, size, numbers.Between(0.1, 0.9),
                            numbers.Between(0, std::numbers::pi)));
  };
  for (double v = -3.2; v < 3.4; v += 0.55) {
    for (const double side : {-1.0, 1.0}) add(kLoopU + side * numbers.Between(0.62, 0.9), v);
  }
  for (int i = 0; i < 60; ++i) {
    const double u = numbers.Between(-kSiteHalfU, kSiteHalfU);
    const double v = numbers.Between(-kSiteHalfV, kSiteHalfV);
    const bool inside = std::abs(u) < kLoopU - 1.2 && std::abs(v) < kLoopV - 1.2;
    const bool outside = std::abs(u) > kLoopU + 1.2 || std::abs(v) > kLoopV + 1.2;
    if (inside || outside) add(u, v);
  }
}

}  // namespace

Isometry3d SitePose() {
  Isometry3d X_MS = Isometry3d::Identity();
  X_MS.translation() << kSiteCentre, GroundHeight(kSiteCentre.x(), kSiteCentre.y());
  X_MS.linear() = Eigen::AngleAxisd(kTurn, Vector3d::UnitZ()).toRotationMatrix();
  return X_MS;
}

double SupportHeight(double x, double y) {
  static const Isometry3d kX_SM = SitePose().inverse();
  static const double kBase = StairsBase();
  const double ground = GroundHeight(x, y);
  const Vector3d p_S = kX_SM * Vector3d(x, y, 0);
  if (std::abs(p_S.y() - kLoopV) > kStairsHalfWidth) return ground;
  // The line from nosing to nosing begins one tread before the first riser.
  const double up = (kStairsFoot + kTread - p_S.x()) / kTread * kRise;
  const double down = (p_S.x() - kStairsEnd + kTread) / kTread * kRise;
  return std::max(ground, kBase + std::min({up, down, kSteps * kRise}));
}

std::vector<SiteObject> SiteObjects() {
  std::vector<SiteObject> objects;
  AddSouth(objects);
  AddStairs(objects);
  AddWest(objects);
  AddClutter(objects);
  return objects;
}

}  // namespace eod::bench
