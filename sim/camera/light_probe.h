#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/world/world_model.h"

namespace eod::sim {

/// What shines on a place without the sun's shadow map.
struct PlaceLight {
  Eigen::Vector3f lamps = Eigen::Vector3f::Zero();  ///< linear light of lamps that stand fast
  float sky = 1;                                    ///< share of the sky that is seen, 0..1
};

/// Looks about in a module for what hides sky and lamps: casts segments at what isectors run into.
/// Not thread-safe. Points are in the module's local frame [m].
class LightProbe {
 public:
  /// With `street_lamps`, lamps under the open sky are lit too, else only those under a roof.
  LightProbe(const ModuleModel& module, bool street_lamps);
  ~LightProbe();

  /// Whether something hides the sky straight above a surface at `p_M` with normal `n_M`, which is
  /// not itself within a solid or under the ground.
  bool IsRoofed(const Eigen::Vector3f& p_M, const Eigen::Vector3f& n_M);
  /// Whether it lies within a solid.
  bool IsInside(const Eigen::Vector3f& p_M, const Eigen::Vector3f& n_M);

  /// On a surface there. The sky is all there under no roof, else what is seen of it in thirteen
  /// directions.
  PlaceLight At(const Eigen::Vector3f& p_M, const Eigen::Vector3f& n_M);
  /// On a thing there, as far as it can be told without its surfaces.
  PlaceLight Around(const Eigen::Vector3f& p_M);

  /// What is hidden from the open sky, of some points: where no rain falls.
  void Roofed(std::span<const Eigen::Vector3f> points, std::vector<bool>& roofed);

  const std::vector<Lamp>& lamps() const { return lamps_; }  ///< that are lit

 private:
  struct Caster;
  float SkyAt(const Eigen::Vector3d& p_M);
  Eigen::Vector3f LampsAt(const Eigen::Vector3d& p_M, const Eigen::Vector3f* n_M);

  std::unique_ptr<Caster> caster_;
  std::vector<Lamp> lamps_;
};

}  // namespace eod::sim
