#pragma once

#include <memory>
#include <span>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "sim/robot/robot_model.h"
#include "sim/world/bullet_shapes.h"

namespace eod::sim {

/// The robot's links for Bullet: solids that push and are not pushed. Each is a body of its own, so
/// that meeting one needs no memory.
class LinkBodies {
 public:
  explicit LinkBodies(const RobotModel& robot);

  struct Solid {
    int link = 0;
    uint32_t parts = 0;  ///< bits of Part
    Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
    BulletShapePointer shape;
    std::unique_ptr<btRigidBody> body;
  };
  std::vector<Solid>& solids() { return solids_; }

  /// New bodies, that stand nowhere until the links are placed.
  void Rebuild();

  /// Whether the links stand where the last step left them.
  bool StandsAt(std::span<const Eigen::Isometry3d> X_ML) const;
  /// Whether a link at X_ML is within `margin` of a box.
  bool IsNear(std::span<const Eigen::Isometry3d> X_ML, std::span<const Eigen::AlignedBox3d> boxes,
              double margin) const;
  /// Has the bodies move from where the last step left them to X_ML, in Bullet's next step.
  void Follow(std::span<const Eigen::Isometry3d> X_ML);
  /// The step ends; `X_ML` is where it leaves them.
  void Remember(std::span<const Eigen::Isometry3d> X_ML);

 private:
  struct Ball {  ///< round all solids of a link, in its frame
    int link;
    Eigen::Vector3d centre;
    double radius;
  };
  bool IsSolidNear(std::span<const Eigen::Isometry3d> X_ML, int link,
                   const Eigen::AlignedBox3d& box, double margin) const;

  std::vector<Solid> solids_;
  std::vector<Ball> balls_;
  std::vector<Eigen::Isometry3d> last_;       ///< of the last step
  std::vector<Eigen::Isometry3d> in_bullet_;  ///< where the bodies are
  bool placed_ = false, remembered_ = false;  ///< whether those two lists hold anything
};

}  // namespace eod::sim
