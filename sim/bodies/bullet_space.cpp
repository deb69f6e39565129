#include "sim/bodies/bullet_space.h"

#include <vector>

namespace eod::sim {

namespace {

constexpr double kGravity = 9.81;      // [m/s^2]
constexpr int kSolverIterations = 30;  // cylinders stand without creeping
constexpr double kReach = 2000;        // [m] half the largest module, and more
constexpr int kProxies = 4096;
constexpr int kManifolds = 512;  // two things that are near each other
constexpr int kAlgorithms = 1024;
constexpr int kPairs = 1024;
constexpr int kContacts = 256;  // points in one step
constexpr int kBodies = 64;     // awake or near one that is

btDefaultCollisionConstructionInfo Pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = kManifolds;
  info.m_defaultMaxCollisionAlgorithmPoolSize = kAlgorithms;
  return info;
}

}  // namespace

RoomySolver::RoomySolver() {
  m_tmpSolverBodyPool.reserve(kBodies);
  m_tmpSolverContactConstraintPool.reserve(kContacts);
  m_tmpSolverContactFrictionConstraintPool.reserve(2 * kContacts);
  m_tmpSolverContactRollingFrictionConstraintPool.reserve(3 * kContacts);
  m_orderTmpConstraintPool.reserve(kContacts);
  m_orderFrictionConstraintPool.reserve(2 * kContacts);
}

BulletSpace::BulletSpace()
    : configuration(Pools()),
      dispatcher(&configuration),
      broadphase(btVector3(-kReach, -kReach, -kReach), btVector3(kReach, kReach, kReach), kProxies,
                 nullptr, true),
      world(&dispatcher, &broadphase, &solver, &configuration) {
  world.setGravity(btVector3(0, 0, -kGravity));
  world.setForceUpdateAllAabbs(false);
  btContactSolverInfo& info = world.getSolverInfo();
  info.m_numIterations = kSolverIterations;
  // Depth is worked off by poses alone: worked off by velocities, things would hop.
  info.m_splitImpulse = true;
  info.m_splitImpulsePenetrationThreshold = 0;
  MakeRoom();
}

void BulletSpace::Reset() {
  broadphase.resetPool(&dispatcher);
  solver.reset();
}

/// Bullet's lists grow and never shrink: they are grown now.
void BulletSpace::MakeRoom() {
  btCollisionObject one, other;
  btSphereShape any(1);
  one.setCollisionShape(&any);
  other.setCollisionShape(&any);
  std::vector<btPersistentManifold*> manifolds;
  for (int i = 0; i < kManifolds; ++i) {
    manifolds.push_back(dispatcher.getNewManifold(&one, &other));
  }
  for (btPersistentManifold* manifold : manifolds) dispatcher.releaseManifold(manifold);
  btOverlappingPairCache& pairs = *broadphase.getOverlappingPairCache();
  std::vector<btBroadphaseProxy> proxies(kPairs + 1);
  for (int i = 0; i <= kPairs; ++i) {
    btBroadphaseProxy& proxy = proxies[static_cast<size_t>(i)];
    proxy.m_uniqueId = i + 1;
    proxy.m_collisionFilterGroup = proxy.m_collisionFilterMask = 1;
    if (i > 0) pairs.addOverlappingPair(&proxies[0], &proxy);
  }
  for (size_t i = proxies.size() - 1; i > 0; --i) {
    pairs.removeOverlappingPair(&proxies[0], &proxies[i], &dispatcher);
  }
}

}  // namespace eod::sim
