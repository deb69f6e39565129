#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/isectors/isector_set.h"
#include "sim/motion/motion.h"

namespace eod::sim {

/// How one cast segment was judged.
struct SegmentContact {
  double threshold = 0;  ///< [m] D of Eq. 2 in this step; D0 while nothing moves
  bool contact = false;  ///< hit and nearer than threshold
  MotionSet blocks = 0;  ///< motions that would shorten it
};

/// A contact that blocked a motion. It stands, commanded or not, until the robot has moved away:
/// the operator's lamp does not go out because he lets go of the button.
struct HeldContact {
  int isector = 0;
  int segment = 0;
  double threshold = 0;  ///< [m] D at which it was made
  MotionSet blocks = 0;
};

/// Where the robot may go: direction-aware blocking (3.3 of the design). Carries the contacts that
/// stand from one step to the next; a fresh one knows of none.
struct Response {
  std::vector<SegmentContact> contacts;  ///< one a cast segment, same order
  std::vector<HeldContact> held;         ///< of this step, in the order of `contacts`
  MotionSet blocked = 0;                 ///< motions to be left out
  MotionSet left_hand_blocked = 0;       ///< of M17 and M18: the left hand stands still (3.4)
  MotionSet right_hand_blocked = 0;
  uint32_t contact_parts = 0;  ///< parts with a blocking contact, bits of Part
  int first_contact = -1;      ///< index in `contacts` of the first blocking one; -1 if none

  /// Motions whose isectors have to be cast, commanded or not, so that held contacts can end.
  MotionSet Watched() const;
};

/// How the distance D comes about, below which a hit is a contact.
struct DistanceLaw {
  double dt_s = 0;          ///< a step
  bool with_factor = true;  ///< grows with the speed by Eq. 2; otherwise it is always d0
};

/// D = d0 up to V0 = skin/dt, d0 + v dt beyond (Eq. 2); v is the speed of the isector's own origin.
double DistanceThreshold(const SegmentSpec& segment, double speed_mps, const DistanceLaw& law);

/// A line that may not stop all motions which it is cast for: l3, l6 and l9 of the hand. They tell
/// how near a thing between the hands is.
bool TellsNearness(const SegmentSpec& segment);

/// Judges the segments that were cast from the current pose against `demand`: a motion is blocked
/// iff a segment in contact would get shorter by it. Each motion is judged alone, then all
/// together. Only motions for which a segment is loaded (2.5), and which it `blocks`, can be
/// blocked by it. Lines of a hand stop that hand alone while the gripper opens or closes; both
/// hands stopped block the motion. A line that tells nearness is in contact with a charge at D, as
/// with all else, but a charge stops motions no sooner than its `skin` (3.4: l3, l6 and l9 alone
/// are no contact; it could not get between the hands otherwise). A line that starts within a thing
/// that can be pushed is in contact with it at distance 0.
///
/// `response` is the one of the step before (its `held` contacts matter) and is overwritten. No
/// allocation once its vectors have grown.
void Respond(const RobotModel& robot, const RobotState& state,
             std::span<const Eigen::Isometry3d> X_ML, std::span<const CastSegment> segments,
             const MotionDemand& demand, const DistanceLaw& law, Response& response);

}  // namespace eod::sim
