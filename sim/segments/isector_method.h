#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <Eigen/Core>

#include "sim/geometry/object_class.h"

namespace eod::sim {

/// The eight isectors of the source paper: how their segments lie, and what is read from them.
/// O is the isector's origin.
enum class IsectorMethod : uint8_t {
  kVolume,  ///< 1..32 segments as the user likes
  kHat,     ///< one vertical through O: height of O above the terrain
  kZ,       ///< one vertical through O: z of the terrain
  kZpr,     ///< one vertical through O: z, pitch and roll of the terrain
  kXyzpr,   ///< one vertical through O: height of O above it, its pitch and roll
  kLos,     ///< one line of sight, along +Y of the isector in general
  kTripod,  ///< three verticals around O: z, pitch and roll of the plane through their hits
  kBump     ///< up to six from O, along +-X, +-Y and +-Z
};

/// In the order of IsectorMethod, as robot files and messages write them.
inline constexpr std::array<std::string_view, 8> kMethodNames = {"volume", "hat", "z",      "zpr",
                                                                 "xyzpr",  "los", "tripod", "bump"};

constexpr std::string_view NameOf(IsectorMethod method) {
  return kMethodNames[static_cast<size_t>(method)];
}

/// Methods that look for the ground: their segments turn with the heading alone, so that they stay
/// vertical whatever the attitude, and their hits carry a robot instead of being in its way.
constexpr bool LooksForGround(IsectorMethod method) {
  return method == IsectorMethod::kHat || method == IsectorMethod::kZ ||
         method == IsectorMethod::kZpr || method == IsectorMethod::kXyzpr ||
         method == IsectorMethod::kTripod;
}

/// How many segments an isector of a method may have.
struct SegmentCount {
  size_t fewest = 1;
  size_t most = 1;
};

constexpr SegmentCount SegmentCountOf(IsectorMethod method) {
  switch (method) {
    case IsectorMethod::kVolume:
      return {1, 32};  // as many as a segment set of IRIS Performer holds
    case IsectorMethod::kTripod:
      return {3, 3};
    case IsectorMethod::kBump:
      return {1, 6};
    default:
      return {1, 1};
  }
}

/// Classes that a method looks for unless told otherwise: ground methods what is stood on, the
/// others what is run into, which the loose objects are too.
constexpr uint32_t UsualClasses(IsectorMethod method) {
  return LooksForGround(method) ? kClampProxy
                                : kBumpProxy | kBombObject | kMovableObject | kContainmentVessel;
}

/// Whether verticals through these points span no plane, so that they are no legs for a TRIPOD.
inline bool StandInOneLine(const Eigen::Vector3d& m, const Eigen::Vector3d& n,
                           const Eigen::Vector3d& p) {
  constexpr double kLeastArea = 1e-6;  // [m^2]
  const Eigen::Vector3d side = n - m, other = p - m;
  return std::abs(side.x() * other.y() - side.y() * other.x()) < kLeastArea;
}

}  // namespace eod::sim
