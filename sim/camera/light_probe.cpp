#include "sim/camera/light_probe.h"

#include <array>
#include <cmath>
#include <numbers>

#include "sim/geometry/object_class.h"
#include "sim/world/world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kOff = 0.06F;       // [m] a surface is looked from a little outside of it
constexpr double kRoofReach = 40;   // [m]
constexpr double kLampSize = 0.30;  // [m] what is so near to a lamp is its own housing
constexpr float kBounce = 0.045F;   // share of a lamp's light that walls bring round a corner ...
constexpr float kTurned = 0.20F;    // ... and to a surface that is turned away from it
constexpr float kDimmest = 0.02F;   // share of the sky that reaches the innermost room

/// A direction to the sky and its weight.
struct Ray {
  Vector3d direction;
  float weight;
};

/// Upwards, four at 50 and eight at 18 degrees: by windows the sky comes in from the side.
std::array<Ray, 13> SkyRays() {
  constexpr double kPi = std::numbers::pi;
  std::array<Ray, 13> rays{Ray{Vector3d::UnitZ(), 0.2F}};
  for (size_t i = 1; i < rays.size(); ++i) {
    const bool is_high = i <= 4;
    const double elevation = (is_high ? 50 : 18) * kPi / 180;
    const double azimuth = is_high ? (static_cast<double>(i) + 0.5) * kPi / 2
                                   : (static_cast<double>(i) + 0.25) * kPi / 4;
    rays[i] = {Vector3d(std::cos(elevation) * std::cos(azimuth),
                        std::cos(elevation) * std::sin(azimuth), std::sin(elevation)),
               is_high ? 0.11F : 0.045F};
  }
  return rays;
}

}  // namespace

struct LightProbe::Caster {
  std::unique_ptr<World> world;
  uint32_t mask = 0;
  CastMemory memory;
  std::vector<SegmentQuery> queries;
  std::vector<SegmentHit> hits;

  void Clear() { queries.clear(); }
  void Add(const Vector3d& start, const Vector3d& direction, double length) {
    queries.push_back(
        {.start = start, .direction = direction, .length = length, .class_mask = mask});
  }
  void Cast() {
    hits.resize(queries.size());
    world->Cast(queries, hits, memory);
  }
  const SegmentHit& One(const Vector3d& start, const Vector3d& direction) {
    Clear();
    Add(start, direction, kRoofReach);
    Cast();
    return hits.front();
  }
  const SegmentHit& Up(const Vector3d& start) { return One(start, Vector3d::UnitZ()); }
};

LightProbe::LightProbe(const ModuleModel& module, bool street_lamps)
    : caster_(std::make_unique<Caster>()) {
  caster_->world = BuildWorld(module);
  caster_->mask = module.class_bit | kBumpProxy;
  for (const Lamp& lamp : module.lamps) {
    const Vector3d above = lamp.p_M + kLampSize * Vector3d::UnitZ();
    if (street_lamps || caster_->Up(above).hit) lamps_.push_back(lamp);
  }
}

LightProbe::~LightProbe() = default;

bool LightProbe::IsRoofed(const Vector3f& p_M, const Vector3f& n_M) {
  const Vector3d off = (p_M + kOff * n_M).cast<double>();
  const SegmentHit& up = caster_->Up(off);
  // A face turned up is met from below only within a solid or under the ground; what looks down and
  // has nothing below it is the underside of something that stands on the ground.
  if (!up.hit || up.normal.z() > 0) return false;
  return n_M.z() > -0.5F || caster_->One(off, -Vector3d::UnitZ()).hit;
}

bool LightProbe::IsInside(const Vector3f& p_M, const Vector3f& n_M) {
  const SegmentHit& hit = caster_->Up((p_M + kOff * n_M).cast<double>());
  return hit.hit && hit.normal.z() > 0;
}

float LightProbe::SkyAt(const Vector3d& p_M) {
  static const std::array<Ray, 13> kRays = SkyRays();
  caster_->Clear();
  for (const Ray& ray : kRays) caster_->Add(p_M, ray.direction, kRoofReach);
  caster_->Cast();
  float seen = 0;
  for (size_t i = 0; i < kRays.size(); ++i) {
    if (!caster_->hits[i].hit) seen += kRays[i].weight;
  }
  return std::max(seen, kDimmest);
}

/// Without a normal: on a thing that has surfaces to all sides.
Vector3f LightProbe::LampsAt(const Vector3d& p_M, const Vector3f* n_M) {
  Vector3f sum = Vector3f::Zero();
  for (const Lamp& lamp : lamps_) {
    const Vector3d way = lamp.p_M - p_M;
    const double distance = way.norm();
    const auto share = static_cast<float>(lamp.light.falloff.At(distance));
    if (share < 0.003F) continue;
    const Vector3d direction = distance > 1e-6 ? Vector3d(way / distance) : Vector3d::UnitZ();
    const float facing =
        n_M == nullptr
            ? 0.6F
            : kTurned + (1 - kTurned) * std::max(n_M->dot(direction.cast<float>()), 0.0F);
    caster_->Clear();
    caster_->Add(p_M, direction, std::max(distance - kLampSize, 0.0));
    caster_->Cast();
    sum += (caster_->hits.front().hit ? kBounce : facing) * share * lamp.light.colour;
  }
  return sum;
}

PlaceLight LightProbe::At(const Vector3f& p_M, const Vector3f& n_M) {
  const Vector3d off = (p_M + kOff * n_M).cast<double>();
  return {.lamps = LampsAt(off, &n_M), .sky = caster_->Up(off).hit ? SkyAt(off) : 1};
}

PlaceLight LightProbe::Around(const Vector3f& p_M) {
  const Vector3d place = p_M.cast<double>();
  return {.lamps = LampsAt(place, nullptr), .sky = caster_->Up(place).hit ? SkyAt(place) : 1};
}

void LightProbe::Roofed(std::span<const Vector3f> points, std::vector<bool>& roofed) {
  caster_->Clear();
  for (const Vector3f& point : points) {
    caster_->Add(point.cast<double>(), Vector3d::UnitZ(), kRoofReach);
  }
  caster_->Cast();
  roofed.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) roofed[i] = caster_->hits[i].hit;
}

}  // namespace eod::sim
