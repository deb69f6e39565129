#pragma once

#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "sim/world/analytic_world.h"
#include "sim/world/bullet_world.h"
#include "tests/unit/sim/random_scene.h"
#include "tests/unit/sim/reference_solid.h"

namespace eod::sim {

inline SegmentHit CastOne(const World& world, const SegmentQuery& query) {
  SegmentHit hit;
  CastMemory memory;
  world.Cast({&query, 1}, {&hit, 1}, memory);
  return hit;
}

inline std::vector<Eigen::Vector3d> PebblePoints() {
  SeededNumbers numbers(11);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 14; ++i) points.push_back(numbers.InBox(0.5));
  return points;
}

/// A solid, and how far a point is from it by other means.
struct KnownSolid {
  std::string name;
  Shape shape;
  DistanceFunction distance;
};

/// All of about half a metre.
inline std::vector<KnownSolid> KnownSolids() {
  const Eigen::Vector3d crate(0.6, 0.25, 0.4);
  return {{"Box", Shape::Box(crate), BoxDistance(crate)},
          {"Cylinder", Shape::Cylinder(0.06, 0.4), CylinderDistance(0.06, 0.4)},
          {"Sphere", Shape::Sphere(0.3), CapsuleDistance(0.3, 0)},
          {"Capsule", Shape::Capsule(0.1, 0.5), CapsuleDistance(0.1, 0.5)},
          {"Hull", Shape::Hull(PebblePoints()), HullDistance(PebblePoints())}};
}

/// One solid in both worlds, in a pose of its own.
struct SolidInBoth {
  Eigen::Isometry3d X_MO;
  AnalyticWorld ours;
  BulletWorld bullet;

  SolidInBoth(const Shape& shape, const BulletOptions& options, SeededNumbers& numbers)
      : X_MO(Eigen::Translation3d(numbers.InBox(50))), bullet(ModuleModel{}, options) {
    const double angle = numbers.Between(0, std::numbers::pi);
    X_MO.rotate(Eigen::AngleAxisd(angle, numbers.InBox(1).normalized()));
    ours.AddShape("solid", kMovableObject, X_MO, shape);
    bullet.AddShape("solid", kMovableObject, X_MO, shape);
  }

  /// From round about or within the solid, towards its middle or past it.
  SegmentQuery RandomSegment(SeededNumbers& numbers) const {
    const Eigen::Vector3d start = X_MO * numbers.InBox(0.7);
    return {.start = start,
            .direction = (X_MO * numbers.InBox(0.25) - start).normalized(),
            .length = numbers.Between(0, 1.5),
            .class_mask = kMovableObject};
  }

  /// Distance of a point from the solid's surface, negative inside [m].
  double Distance(const KnownSolid& solid, const Eigen::Vector3d& p_M) const {
    const Eigen::Vector3d p = X_MO.inverse() * p_M;
    return static_cast<double>(solid.distance({p.x(), p.y(), p.z()}));
  }
};

}  // namespace eod::sim
