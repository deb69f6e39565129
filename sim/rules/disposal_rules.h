#pragma once

#include <Eigen/Core>

namespace eod::sim {

/// When a charge counts as grasped, and how it is lost again (3.4 of the design).
struct GraspRules {
  double pad = 0;                ///< [m] thickness of a pad: it yields by as much and no more
  double pad_half_height = 0;    ///< [m] of a pad, across the finger
  double surface_tolerance = 0;  ///< [m] of Eq. 8: a hit this near to the surface lies on it
  double opposed_below = 0;      ///< product of the contacts' normals, guarded
  double across = 0;             ///< [rad] the charge's axis against across the jaws, guarded
  double relative_speed = 0;     ///< [m/s] between charge and gripper, guarded
  double tilt = 0;               ///< [rad] of the charge, guarded
  double close_memory = 0;       ///< [s] since closing was commanded, guarded
  int steps = 0;                 ///< for so many the lines have to say so
  double release = 0;            ///< [m] the opening grows by this, then it is let go
  double squeeze = 0;            ///< [s] pressed from both sides without a grasp: it goes off
  double slip_speed = 0;         ///< [m/s] downwards, held badly or too heavy
  double slip = 0;               ///< [s] of slipping, then it falls
};

/// What a charge bears.
struct ChargeRules {
  double disturbed = 0;     ///< [rad] tilt beyond this is told
  double unstable = 0;      ///< [rad] tilt beyond this too
  double drop = 0;          ///< [m] a deeper fall sets it off
  double lethal = 0;        ///< [m] a robot nearer to the blast than this is lost
  double push_through = 0;  ///< [s] a motion that a charge stops goes on when held so long
  double push_share = 0;    ///< of the rated speed then; drive goes at creep
  double carried = 0;       ///< [m] moved so far in the hand it is carried
  double probe_skin = 0;    ///< [m] D0 of the held charge's own lines beyond its surface
  double probe_inset = 0;   ///< [m] these start so deep below the surface
};

struct VesselRules {
  double rim_strike = 0;  ///< [m/s] at which the held charge may touch a vessel
  double net_sag = 0;     ///< [m] below the net still counts as inside
};

/// The fire circuit (rule 7 of 6.3 of the design), the barrel and its shot.
struct DisrupterRules {
  double arm = 0;                                    ///< [s] key armed before buttons count
  double both_within = 0;                            ///< [s] between the presses of the buttons
  double hold = 0;                                   ///< [s] both held
  double time_out = 0;                               ///< [s] armed without a shot
  Eigen::Vector3d muzzle = Eigen::Vector3d::Zero();  ///< [m] in the wrist's frame; shoots along +Y
  double min_range = 0;                              ///< [m] nearer sets the charge off
  double max_range = 0;                              ///< [m] farther too ...
  double reach = 0;                                  ///< [m] ... up to here
  double aim_offset = 0;                             ///< [m] of the shot's line from the centre
  double aim_angle = 0;                              ///< [rad] from the normal of the surface
  double impulse = 0;                                ///< [N s] on the charge
};

}  // namespace eod::sim
