#include "sim/bodies/bullet_engine.h"

#include <algorithm>

namespace eod::sim {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kTouch = 0.5e-3;    // [m] nearer than this is contact
constexpr double kNear = 0.02;       // [m] more than a link moves in three steps at 0.67 m/s
constexpr double kAir = 0.1;         // [m] how much farther it is looked for ground
constexpr double kNeighbour = 0.01;  // [m] what is nearer may lean on it

// User indices of Bullet's bodies: movables have their number.
constexpr int kGroundIndex = -1;
constexpr int IndexOfSolid(size_t solid) { return -2 - static_cast<int>(solid); }
constexpr bool IsSolid(int index) { return index <= -2; }
constexpr size_t SolidOf(int index) { return static_cast<size_t>(-2 - index); }

enum Group : int { kGroundGroup = 1, kLinkGroup = 2, kMovableGroup = 4 };

const btCollisionObject& ObjectOf(const btBroadphaseProxy* proxy) {
  return *static_cast<const btCollisionObject*>(proxy->m_clientObject);
}

/// A held body goes with the robot and so never meets it.
void MeetUnlessHeld(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                    const btDispatcherInfo& info) {
  const btCollisionObject &a = ObjectOf(pair.m_pProxy0), &b = ObjectOf(pair.m_pProxy1);
  if (a.isKinematicObject() && b.isKinematicObject() &&
      (IsSolid(a.getUserIndex()) || IsSolid(b.getUserIndex()))) {
    return;
  }
  btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

}  // namespace

RigidBodies::Engine::Engine(const ModuleModel& module, const RobotModel& robot)
    : objects_(module.movables),
      ground_meshes_{GroundMesh(module.triangles, GroundMesh::Kind::kFloors),
                     GroundMesh(module.triangles, GroundMesh::Kind::kWalls)},
      links_(robot) {
  for (MovableObject& object : objects_) {
    object.visuals.clear();
    X_MO_module_.push_back(object.X_MO);
  }
  settles_.assign(objects_.size(), 0);
  space_.dispatcher.setNearCallback(MeetUnlessHeld);
  bodies_.reserve(objects_.size());
  Reset();
  WarmUp();
}

RigidBodies::Engine::~Engine() { TakeAllOut(); }

/// Bullet's lists of islands find their length while all bodies are awake and, high above, a heap
/// of others is one single island. Nothing else is left of it.
void RigidBodies::Engine::WarmUp() {
  constexpr int kSteps = 3;  // to new contacts, to their islands, and on
  constexpr double kStep_s = 0.004;
  constexpr double kAbove = 1000;  // [m]
  constexpr int kHeap = 16;        // all of them touch each other
  btSphereShape ball(1);
  std::vector<std::unique_ptr<btRigidBody>> heap;
  for (int i = 0; i < kHeap; ++i) {
    btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &ball, btVector3(1, 1, 1));
    info.m_startWorldTransform.setOrigin(btVector3(0.1 * i, 0, kAbove));
    heap.push_back(std::make_unique<btRigidBody>(info));
    space_.world.addRigidBody(heap.back().get(), kMovableGroup, kMovableGroup);
  }
  for (int step = 0; step < kSteps; ++step) {
    for (MovableBody& body : bodies_) body.body().activate(true);
    space_.world.stepSimulation(kStep_s, 0);
  }
  Reset();
}

void RigidBodies::Engine::TakeAllOut() {
  btCollisionObjectArray& inside = space_.world.getCollisionObjectArray();
  while (inside.size() > 0) space_.world.removeCollisionObject(inside[inside.size() - 1]);
}

void RigidBodies::Engine::Reset() {
  // New bodies in an empty space, so that nothing of the past is left: a second run is the first to
  // the last bit.
  TakeAllOut();
  space_.Reset();
  bodies_.clear();
  links_.Rebuild();
  ground_.clear();
  for (GroundMesh& mesh : ground_meshes_) {
    if (mesh.shape() == nullptr) continue;
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, mesh.shape());
    info.m_friction = 1;
    ground_.push_back(std::make_unique<btRigidBody>(info));
    ground_.back()->setUserIndex(kGroundIndex);
    space_.world.addRigidBody(ground_.back().get(), kGroundGroup, kMovableGroup);
  }
  for (size_t i = 0; i < links_.solids().size(); ++i) {
    btRigidBody* const body = links_.solids()[i].body.get();
    body->setUserIndex(IndexOfSolid(i));
    space_.world.addRigidBody(body, kLinkGroup, kMovableGroup);
  }
  for (const MovableObject& object : objects_) {
    MovableBody& added = bodies_.emplace_back(object);
    added.body().setUserIndex(static_cast<int>(bodies_.size()) - 1);
    space_.world.addRigidBody(&added.body(), kMovableGroup,
                              kGroundGroup | kLinkGroup | kMovableGroup);
  }
  states_.assign(bodies_.size(), {});
  grips_.assign(bodies_.size(), {});
  boxes_.assign(bodies_.size(), {});
  is_awake_ = false;
  dt_s_ = 0;
  for (size_t i = 0; i < bodies_.size(); ++i) {
    states_[i].X_MO = objects_[i].X_MO;
    UpdateBox(i);
    if (settles_[i] != 0) Wake(i);
  }
}

void RigidBodies::Engine::SetStart(int body, const std::optional<Isometry3d>& X_MO) {
  const auto index = static_cast<size_t>(body);
  objects_[index].X_MO = X_MO.value_or(X_MO_module_[index]);
  settles_[index] = objects_[index].X_MO.matrix() != X_MO_module_[index].matrix() ? 1 : 0;
}

void RigidBodies::Engine::Step(double dt_s, std::span<const Isometry3d> X_ML) {
  dt_s_ = dt_s;
  const bool is_busy = IsBusy(X_ML);
  if (is_busy) {
    links_.Follow(X_ML);
    FollowGrips();
    space_.world.stepSimulation(dt_s, 0);
    ReadStates();
    ReadContacts();
  }
  KeepGrips(is_busy);
  links_.Remember(X_ML);
}

bool RigidBodies::Engine::IsGripMoving(size_t body) const {
  return grips_[body].X_in_step.matrix() != grips_[body].X_now.matrix();
}

/// Whether a held body may touch the ground or a free one on its way.
bool RigidBodies::Engine::IsGripNear(size_t body) {
  const Vector3d reach = Vector3d::Constant(kNear);
  AlignedBox3d way;
  for (const Isometry3d& X_MO : {grips_[body].X_in_step, grips_[body].X_now}) {
    btVector3 low, high;
    bodies_[body].body().getCollisionShape()->getAabb(bodies_[body].ToBodyFrame(X_MO), low, high);
    way.extend(Vector3d(FromBullet(low) - reach));
    way.extend(Vector3d(FromBullet(high) + reach));
  }
  const auto is_near_body = [&](const AlignedBox3d& box) {
    return !box.isEmpty() && way.intersects(box);
  };
  return std::any_of(boxes_.begin(), boxes_.end(), is_near_body) || IsNearGround(way);
}

bool RigidBodies::Engine::IsNearGround(const AlignedBox3d& box) {
  if (in_the_air_.contains(box)) return false;
  const auto is_near = [this](const AlignedBox3d& any) {
    return ground_meshes_[0].IsNear(any) || ground_meshes_[1].IsNear(any);
  };
  if (is_near(box)) return true;
  const Vector3d reach = Vector3d::Constant(kAir);
  const AlignedBox3d more(box.min() - reach, box.max() + reach);
  if (!is_near(more)) in_the_air_ = more;
  return false;
}

bool RigidBodies::Engine::IsBusy(std::span<const Isometry3d> X_ML) {
  if (is_awake_) return true;
  for (size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].is_held && IsGripMoving(i) && IsGripNear(i)) return true;
  }
  return !links_.StandsAt(X_ML) && links_.IsNear(X_ML, boxes_, kNear);
}

void RigidBodies::Engine::FollowGrips() {
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (!states_[i].is_held) continue;
    btRigidBody& body = bodies_[i].body();
    body.setWorldTransform(bodies_[i].ToBodyFrame(grips_[i].X_in_step));
    body.setInterpolationWorldTransform(
        bodies_[i].ToBodyFrame(PoseBefore(grips_[i].X_in_step, grips_[i].X_now)));
  }
}

void RigidBodies::Engine::KeepGrips(bool was_busy) {
  for (size_t i = 0; i < grips_.size(); ++i) {
    if (IsGripMoving(i) && !was_busy) {
      // It has left whatever it touched while it was near.
      states_[i].touched_by = 0;
      states_[i].touches_ground = false;
    }
    grips_[i].X_in_step = grips_[i].X_now;
  }
}

void RigidBodies::Engine::ReadStates() {
  is_awake_ = false;
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (states_[i].is_gone) continue;
    if (IsFree(i)) ReadState(i);
    is_awake_ = is_awake_ || (IsFree(i) && states_[i].is_moving);
  }
}

void RigidBodies::Engine::ReadState(size_t index) {
  BodyState& state = states_[index];
  const bool was_moving = state.is_moving;
  state.is_moving = bodies_[index].body().isActive();
  if (state.is_moving) {
    state.X_MO = bodies_[index].X_MO();
    state.v_M = bodies_[index].Velocity(state.X_MO);
    state.w_M = FromBullet(bodies_[index].body().getAngularVelocity());
    bodies_[index].WatchRest(state.X_MO);
    UpdateBox(index);
  } else if (was_moving) {
    state.v_M = state.w_M = Vector3d::Zero();
  }
}

void RigidBodies::Engine::ReadContacts() {
  for (BodyState& state : states_) {
    state.touched_by = 0;
    state.touches_ground = false;
  }
  for (int i = 0; i < space_.dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *space_.dispatcher.getManifoldByIndexInternal(i);
    for (int point = 0; point < manifold.getNumContacts(); ++point) {
      if (manifold.getContactPoint(point).getDistance() > kTouch) continue;
      ReadContact(manifold);
      break;
    }
  }
}

void RigidBodies::Engine::ReadContact(const btPersistentManifold& manifold) {
  int movable = manifold.getBody0()->getUserIndex(), other = manifold.getBody1()->getUserIndex();
  if (movable < 0) std::swap(movable, other);
  if (movable < 0 || other >= 0) return;
  BodyState& state = states_[static_cast<size_t>(movable)];
  if (IsSolid(other)) {
    state.touched_by |= links_.solids()[SolidOf(other)].parts;
  } else {
    state.touches_ground = true;
  }
}

void RigidBodies::Engine::UpdateBox(size_t index) {
  btVector3 low, high;
  bodies_[index].body().getAabb(low, high);
  boxes_[index] = AlignedBox3d(FromBullet(low), FromBullet(high));
}

void RigidBodies::Engine::Wake(size_t index) {
  bodies_[index].body().activate(true);
  is_awake_ = true;
}

/// What leans on a body must not hang in the air when that goes.
void RigidBodies::Engine::WakeAround(size_t index) {
  const Vector3d reach = Vector3d::Constant(kNeighbour);
  const AlignedBox3d around(boxes_[index].min() - reach, boxes_[index].max() + reach);
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (i != index && IsFree(i) && around.intersects(boxes_[i])) Wake(i);
  }
}

void RigidBodies::Engine::Hold(int body) {
  const auto index = static_cast<size_t>(body);
  if (!IsFree(index)) return;
  WakeAround(index);
  bodies_[index].Hold();
  // Contacts of the past would go on pushing.
  space_.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(
      bodies_[index].body().getBroadphaseHandle(), &space_.dispatcher);
  const Isometry3d X_MO = states_[index].X_MO;
  states_[index] = {};
  states_[index].X_MO = X_MO;
  states_[index].is_held = true;
  grips_[index] = {X_MO, X_MO, X_MO};
  boxes_[index].setEmpty();
}

void RigidBodies::Engine::MoveHeld(int body, const Isometry3d& X_MO) {
  const auto index = static_cast<size_t>(body);
  if (!states_[index].is_held) return;
  grips_[index].X_before = grips_[index].X_now;
  grips_[index].X_now = X_MO;
  BodyState& state = states_[index];
  state.is_moving = grips_[index].X_before.matrix() != X_MO.matrix();
  if (dt_s_ > 0) state.v_M = (X_MO.translation() - state.X_MO.translation()) / dt_s_;
  state.X_MO = X_MO;
}

void RigidBodies::Engine::Release(int body) {
  const auto index = static_cast<size_t>(body);
  if (!states_[index].is_held) return;
  const Grip& grip = grips_[index];
  bodies_[index].Release(grip.X_before, grip.X_now, dt_s_);
  space_.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(
      bodies_[index].body().getBroadphaseHandle(), &space_.dispatcher);
  states_[index].is_held = false;
  is_awake_ = true;
  ReadState(index);
}

void RigidBodies::Engine::Remove(int body) {
  const auto index = static_cast<size_t>(body);
  if (states_[index].is_gone) return;
  if (IsFree(index)) WakeAround(index);
  space_.world.removeRigidBody(&bodies_[index].body());
  const Isometry3d X_MO = states_[index].X_MO;
  states_[index] = {};
  states_[index].X_MO = X_MO;
  states_[index].is_gone = true;
  boxes_[index].setEmpty();
}

void RigidBodies::Engine::Push(int body, const Vector3d& impulse_M, const Vector3d& p_M) {
  const auto index = static_cast<size_t>(body);
  if (!IsFree(index)) return;
  Wake(index);
  btRigidBody& pushed = bodies_[index].body();
  pushed.applyImpulse(ToBullet(impulse_M), ToBullet(p_M) - pushed.getCenterOfMassPosition());
}

}  // namespace eod::sim
