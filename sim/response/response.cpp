#include "sim/response/response.h"

#include <algorithm>

namespace eod::sim {
namespace {

/// Below this share of its speed a motion counts as parallel to a surface: rounding must not stop a
/// robot that slides along a wall.
constexpr double kGrazing = 1e-6;

constexpr MotionSet kGripperMotions = SetOf(kGripperOpen) | SetOf(kGripperClose);

/// From the segment's start to the surface; 0 within a thing that can be pushed. Such things are
/// pushed skin on skin, and what starts at the robot's skin may start a little inside of them. The
/// lines that tell nearness are within a charge when it is held between the pads.
double Distance(const SegmentSpec& segment, const CastSegment& cast) {
  const bool yields = (cast.hit.object_class & (kBombObject | kMovableObject)) != 0;
  const bool from_inside = cast.hit.normal.dot(cast.query.direction) > 0;
  return yields && from_inside && !TellsNearness(segment) ? 0 : cast.hit.range;
}

/// How much nearer than D a surface has to be before it stops a motion.
double NearerThanD(const SegmentSpec& segment, const SegmentHit& hit) {
  const bool is_charge = (hit.object_class & kBombObject) != 0;
  return is_charge && TellsNearness(segment) ? segment.d0 - segment.skin : 0;
}

LinkSpec::Hand HandOf(const RobotModel& robot, int link) {
  for (int l = link; l >= 0; l = robot.links[l].parent) {
    if (robot.links[l].hand != LinkSpec::Hand::kNone) return robot.links[l].hand;
  }
  return LinkSpec::Hand::kNone;
}

template <typename Function>
void ForEachMotion(MotionSet set, const Function& function) {
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (Contains(set, motion)) function(motion);
  }
}

bool IsSmallWheel(Part part) {
  return part == Part::kFrontLeftWheel || part == Part::kFrontRightWheel ||
         part == Part::kRearLeftWheel || part == Part::kRearRightWheel;
}

/// Whether a small wheel's line looks down on a floor, both within 45 degrees: the wheel of a
/// flipper that props the robot up rolls on it.
bool RollsOn(const IsectorSpec& isector, const CastSegment& cast) {
  constexpr double kSteep = 0.70710678118654752;
  const Eigen::Vector3d& n_M = cast.hit.normal;
  const bool loose = (cast.hit.object_class & (kBombObject | kMovableObject)) != 0;
  return IsSmallWheel(isector.part) && cast.hit.hit && !loose && n_M.z() >= kSteep &&
         n_M.dot(cast.query.direction) <= -kSteep;
}

/// Judges the segments of one step.
class Judge {
 public:
  Judge(const RobotModel& robot, const RobotState& state, std::span<const Eigen::Isometry3d> X_ML,
        const MotionDemand& demand, const DistanceLaw& law)
      : robot_(robot), state_(state), X_ML_(X_ML), demand_(demand), law_(law) {}

  /// Every motion as if it were the only one.
  SegmentContact JudgeAlone(const CastSegment& cast, const HeldContact* held) const;

  /// The motions that are left, together: their sum can pass V0 where none does alone.
  void JudgeTogether(const CastSegment& cast, MotionSet left_over, SegmentContact& contact) const;

 private:
  const IsectorSpec& Isector(const CastSegment& cast) const {
    return robot_.isectors[cast.isector];
  }
  const SegmentSpec& Segment(const CastSegment& cast) const {
    return Isector(cast).segments[cast.segment];
  }
  MotionSet MayBlock(const CastSegment& cast) const {
    return Isector(cast).motions & Segment(cast).motions & Segment(cast).blocks;
  }
  Eigen::Vector3d OriginVelocity(const CastSegment& cast, int motion, double rate) const {
    const double speed = rate * RatedSpeed(robot_, motion, demand_.speed_range);
    return PointVelocity(robot_, state_, X_ML_, Isector(cast).link, cast.query.start, motion,
                         speed);
  }
  bool Shortens(const CastSegment& cast, int motion, const Eigen::Vector3d& v_M) const;

  const RobotModel& robot_;
  const RobotState& state_;
  std::span<const Eigen::Isometry3d> X_ML_;
  const MotionDemand& demand_;
  const DistanceLaw& law_;
};

bool Judge::Shortens(const CastSegment& cast, int motion, const Eigen::Vector3d& v_M) const {
  if (Contains(kChassisMotions, motion) && RollsOn(Isector(cast), cast)) return false;
  const Eigen::Vector3d& u_M = cast.query.direction;
  if (v_M.dot(u_M) > kGrazing * v_M.norm()) return true;
  // l1, l2 and l5 run along the pads, across the way the hands move. They meet a surface from
  // inside only when the pad is pressed into it, and then closing would press it deeper.
  const bool from_inside = cast.hit.normal.dot(u_M) > 0;
  return motion == kGripperClose && from_inside &&
         HandOf(robot_, Isector(cast).link) != LinkSpec::Hand::kNone;
}

SegmentContact Judge::JudgeAlone(const CastSegment& cast, const HeldContact* held) const {
  const SegmentSpec& segment = Segment(cast);
  const double distance = Distance(segment, cast);
  const double reached = distance + NearerThanD(segment, cast.hit);
  SegmentContact contact;
  contact.threshold = held != nullptr ? held->threshold : segment.d0;
  ForEachMotion(MayBlock(cast) & demand_.commanded, [&](int motion) {
    const Eigen::Vector3d v_M = OriginVelocity(cast, motion, demand_.rate[motion]);
    const double own = DistanceThreshold(segment, v_M.norm(), law_);
    const double threshold = held != nullptr ? std::max(own, held->threshold) : own;
    contact.threshold = std::max(contact.threshold, threshold);
    if (reached < threshold && Shortens(cast, motion, v_M)) contact.blocks |= SetOf(motion);
  });
  // A contact that stood stays for its motions, pressed or not, until the way is free again.
  if (held != nullptr && reached < held->threshold) {
    ForEachMotion(held->blocks & ~demand_.commanded, [&](int motion) {
      if (Shortens(cast, motion, OriginVelocity(cast, motion, 1))) contact.blocks |= SetOf(motion);
    });
  }
  contact.contact = distance < contact.threshold;
  return contact;
}

void Judge::JudgeTogether(const CastSegment& cast, MotionSet left_over,
                          SegmentContact& contact) const {
  Eigen::Vector3d v_M = Eigen::Vector3d::Zero();
  ForEachMotion(left_over,
                [&](int motion) { v_M += OriginVelocity(cast, motion, demand_.rate[motion]); });
  const double threshold = DistanceThreshold(Segment(cast), v_M.norm(), law_);
  contact.threshold = std::max(contact.threshold, threshold);
  const double distance = Distance(Segment(cast), cast);
  contact.contact = distance < contact.threshold;
  const double reached = distance + NearerThanD(Segment(cast), cast.hit);
  if (reached >= threshold || v_M.dot(cast.query.direction) <= kGrazing * v_M.norm()) return;
  ForEachMotion(left_over & MayBlock(cast), [&](int motion) {
    const Eigen::Vector3d own = OriginVelocity(cast, motion, demand_.rate[motion]);
    if (Shortens(cast, motion, own)) contact.blocks |= SetOf(motion);
  });
}

/// Sums up what the contacts block, hand by hand.
void Collect(const RobotModel& robot, std::span<const CastSegment> segments, Response& response) {
  response.blocked = 0;
  response.left_hand_blocked = 0;
  response.right_hand_blocked = 0;
  for (size_t i = 0; i < segments.size(); ++i) {
    MotionSet blocks = response.contacts[i].blocks;
    if (blocks == 0) continue;
    const LinkSpec::Hand hand = HandOf(robot, robot.isectors[segments[i].isector].link);
    if (hand == LinkSpec::Hand::kLeft) response.left_hand_blocked |= blocks & kGripperMotions;
    if (hand == LinkSpec::Hand::kRight) response.right_hand_blocked |= blocks & kGripperMotions;
    if (hand != LinkSpec::Hand::kNone) blocks &= ~kGripperMotions;
    response.blocked |= blocks;
  }
  response.blocked |= response.left_hand_blocked & response.right_hand_blocked;
}

/// Notes the contacts that block: their parts, the first one, and what the next step has to know.
void Hold(const RobotModel& robot, std::span<const CastSegment> segments, Response& response) {
  response.held.clear();
  response.contact_parts = 0;
  response.first_contact = -1;
  for (size_t i = 0; i < segments.size(); ++i) {
    const SegmentContact& contact = response.contacts[i];
    if (contact.blocks == 0) continue;
    const CastSegment& cast = segments[i];
    if (response.first_contact < 0) response.first_contact = static_cast<int>(i);
    response.contact_parts |= 1u << static_cast<int>(robot.isectors[cast.isector].part);
    response.held.push_back({.isector = cast.isector,
                             .segment = cast.segment,
                             .threshold = contact.threshold,
                             .blocks = contact.blocks});
  }
}

const HeldContact* FindHeld(const Response& response, const CastSegment& cast) {
  const auto found =
      std::find_if(response.held.begin(), response.held.end(), [&](const auto& held) {
        return held.isector == cast.isector && held.segment == cast.segment;
      });
  return found == response.held.end() ? nullptr : &*found;
}

}  // namespace

MotionSet Response::Watched() const {
  MotionSet watched = 0;
  for (const HeldContact& contact : held) watched |= contact.blocks;
  return watched;
}

double DistanceThreshold(const SegmentSpec& segment, double speed_mps, const DistanceLaw& law) {
  const double critical_speed = segment.skin / law.dt_s;
  const bool grows = law.with_factor && speed_mps > critical_speed;
  return grows ? segment.d0 + speed_mps * law.dt_s : segment.d0;
}

bool TellsNearness(const SegmentSpec& segment) {
  return (segment.motions & kAllMotions & ~segment.blocks) != 0;
}

void Respond(const RobotModel& robot, const RobotState& state,
             std::span<const Eigen::Isometry3d> X_ML, std::span<const CastSegment> segments,
             const MotionDemand& demand, const DistanceLaw& law, Response& response) {
  const Judge judge(robot, state, X_ML, demand, law);
  const auto can_block = [&](const CastSegment& cast) {
    return cast.hit.hit && !LooksForGround(robot.isectors[cast.isector].method);
  };
  response.contacts.assign(segments.size(), {});
  for (size_t i = 0; i < segments.size(); ++i) {
    if (!can_block(segments[i])) continue;
    response.contacts[i] = judge.JudgeAlone(segments[i], FindHeld(response, segments[i]));
  }
  Collect(robot, segments, response);

  const MotionSet left_over = demand.commanded & ~response.blocked;
  if ((left_over & (left_over - 1)) != 0) {
    for (size_t i = 0; i < segments.size(); ++i) {
      if (can_block(segments[i])) judge.JudgeTogether(segments[i], left_over, response.contacts[i]);
    }
    Collect(robot, segments, response);
  }
  Hold(robot, segments, response);
}

}  // namespace eod::sim
