#pragma once

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <btBulletDynamicsCommon.h>

namespace eod::sim {

/// Keeps room for the contacts of a step, so that no step has to make some.
class RoomySolver final : public btSequentialImpulseConstraintSolver {
 public:
  RoomySolver();
};

/// Bullet's own objects, in double and set for things that stand exactly still. Bodies that are in
/// `world` must outlive it, or be taken out.
struct BulletSpace {
  BulletSpace();

  /// As new, without bodies; keeps the memory. All bodies must have been taken out.
  void Reset();

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  /// Sweep and prune: a tree would take memory whenever a thing wakes up.
  bt32BitAxisSweep3 broadphase;
  RoomySolver solver;
  btDiscreteDynamicsWorld world;

 private:
  void MakeRoom();
};

}  // namespace eod::sim
