#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/visual.h"
#include "sim/robot/motion_id.h"
#include "sim/robot/robot_lights.h"
#include "sim/robot/robot_state.h"
#include "sim/segments/isector_method.h"
#include "sim/segments/segment.h"
#include "sim/segments/shape.h"

namespace eod::sim {

/// An acceleration without a limit.
inline constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// One of the nine joints. Revolute joints in [rad], J7 in [m] of opening per hand.
struct JointSpec {
  std::string name;  ///< "J1_front_flipper"
  double lower = 0;
  double upper = 0;
  double rate = 0;                ///< at 100 % [rad/s] or [m/s]
  double acceleration = kAtOnce;  ///< of rate, up and down [rad/s^2] or [m/s^2]
  double home = 0;
  int positive_motion = 0;  ///< MotionId that makes the coordinate grow
  int negative_motion = 0;
};

/// A convex solid on a link.
struct LinkSolid {
  Shape shape;
  Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
};

/// A rigid part. Links stand in an order in which parents come first; link 0 is the chassis.
struct LinkSpec {
  enum class Kind : uint8_t { kFixed, kRevolute, kPrismatic };
  enum class Hand : uint8_t { kNone, kLeft, kRight };
  std::string name;
  Eigen::Isometry3d X_PL = Eigen::Isometry3d::Identity();  ///< in the parent, at coordinate 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();         ///< in the link's frame
  /// Coordinate of the link = scale * coordinate of the joint; 2/3 for the crossbeam, which slides
  /// back (Eq. 6).
  double scale = 1;
  int parent = -1;
  int joint = -1;  ///< JointId that moves it; -1 for fixed links
  Kind kind = Kind::kFixed;
  double mass = 0;                                 ///< [kg]
  Eigen::Vector3d p_LC = Eigen::Vector3d::Zero();  ///< centre of mass in the link [m]
  std::vector<LinkSolid> solids = {};              ///< what pushes movable things
  /// The hands use their own opening, not the joint's (each stops on its own).
  Hand hand = Hand::kNone;
};

/// One line of an isector, in the isector's own frame.
struct SegmentSpec {
  std::string name;  ///< "+Y", "l1", ...
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit
  double length = 0;                                     ///< [m]
  double d0 = 0;                    ///< [m] D0 of Eq. 2, carrier's own size included
  double skin = 0.02;               ///< [m] part of d0 beyond the carrier: V0 = skin / dt
  MotionSet motions = kAllMotions;  ///< live only while one of these is commanded
  MotionSet blocks = kAllMotions;   ///< those of `motions` that it may stop; for the rest it only
                                    ///< tells how near a thing is
  bool enabled = true;              ///< never cast if not
};

/// An isector on a link.
struct IsectorSpec {
  std::string name;  ///< "B1" .. "B7", "TRIPOD", "LOS_FRONT", ...
  IsectorMethod method = IsectorMethod::kBump;
  int link = 0;
  Eigen::Isometry3d X_LI = Eigen::Isometry3d::Identity();
  uint32_t class_mask = 0;  ///< proxy and object classes it looks for, module bit apart
  FaceRule face_rule = FaceRule::kTwoSided;
  HitRule hit_rule = HitRule::kNearest;
  MotionSet motions = kAllMotions;  ///< active while one of these is commanded; kAlways: ever
  Part part = Part::kChassis;       ///< part that an alarm names
  bool extended = false;  ///< beyond the source paper's set, see Coverage in isector_set.h
  std::vector<SegmentSpec> segments;
};

/// A pose of the joints that the box can ask for. Joints without a target stay where they are.
struct PresetSpec {
  int index = 0;  ///< number in box_command_t.preset, 1..7
  std::string name;
  std::array<std::optional<double>, kJointCount> joint;  ///< [rad]; J7 [m]
};

/// What the arm can carry, by how far it reaches. 0 kg: it says nothing about it.
struct PayloadSpec {
  double folded = 0;     ///< [kg] never more than this
  double stretched = 0;  ///< [kg] at full stretch
};

/// What feeds the robot. A capacity of 0: a battery that never runs down.
struct BatterySpec {
  double full = 25.6;        ///< [V] of the source, full ...
  double empty = 25.6;       ///< ... and empty
  double capacity = 0;       ///< [C]
  double resistance = 0;     ///< [Ohm]
  double idle_current = 0;   ///< [A] of computer and radio
  double drive_current = 0;  ///< [A] of driving, or turning, at full rate
  double joint_current = 0;  ///< [A] of a joint at full rate
  double low = 0;            ///< [V] below it the operator is told
};

/// A point of the robot's underside, which ground can carry.
struct SupportPoint {
  int link = 0;
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();    ///< [m]
  Eigen::Vector3d n_L = -Eigen::Vector3d::UnitZ();  ///< outwards, unit
  uint32_t group = 0;  ///< of one outline at one x: neighbours, looked for together
};

/// How the robot stands on any ground, see stance.h.
struct StanceSpec {
  std::vector<SupportPoint> points;
  double friction = 0;     ///< Coulomb, tracks on ground
  double pitch_limit = 0;  ///< [rad] no drive motion increases the pitch beyond it, up or down ...
  double roll_limit = 0;   ///< [rad] ... nor the roll, to either side
  double overturned = 0;   ///< [rad] tilt at which a robot that rolled over lies
  double press_on_s = 0;   ///< a flipper pressed on the ground for so long begins to bear
  double lift_off = 0;     ///< [m] and ends when all its points are that far above the ground
  double reach_up = 0;     ///< [m] ground is looked for from this far above a point ...
  double reach_down = 0;   ///< [m] ... to this far below
  double rise_speed = 0;   ///< [m/s] at which ground lifts a point of a robot that stands
  double rise_per_metre = 0;  ///< and how much more for each metre that it drives
};

/// A camera on a link: looks along +Y of its frame, Z up.
struct CameraSpec {
  std::string name;  ///< "drive", "gripper", "mast", "rear"
  int link = 0;
  Eigen::Isometry3d X_LC = Eigen::Isometry3d::Identity();
  double horizontal_fov = 1.3;  ///< [rad]
  double near = 0.06;           ///< [m] what is nearer is not seen
  /// Magnification of the lens when zoomed in, 1: it does not zoom. The angle of view shrinks by
  /// tan(fov / 2) = tan(horizontal_fov / 2) / magnification.
  double zoom_most = 1;
  double zoom_per_s = 1;  ///< factor by which the magnification grows in a second
  int width = 640;
  int height = 480;
};

/// A visual shape on a link.
struct LinkVisual {
  int link = 0;
  Visual visual;
};

/// The robot as its SDFormat file describes it. Plain data.
struct RobotModel {
  std::filesystem::path file;
  std::string name;
  std::vector<LinkSpec> links;
  std::array<JointSpec, kJointCount> joints;
  std::vector<IsectorSpec> isectors;
  std::vector<CameraSpec> cameras;
  std::vector<SpotLightSpec> lights;
  std::vector<LinkVisual> visuals;
  std::array<double, 3> drive_speed{};  ///< [m/s] creep, low, high
  double track = 0.6;                   ///< [m] between the middles of the tracks
  double turn_rate = 0;                 ///< [rad/s] at 100 %, any range
  double drive_acceleration = kAtOnce;  ///< [m/s^2]
  double turn_acceleration = kAtOnce;   ///< [rad/s^2]
  std::vector<PresetSpec> presets;
  PayloadSpec payload;
  BatterySpec battery;
  double step_up_limit = 0.45;  ///< [m] ground is looked for from this far above the wheels ...
  double fall_search = 3.0;     ///< [m] ... to this far below
  StanceSpec stance;
};

/// Reads and checks a robot. Throws std::runtime_error with one line "FILE:LINE: …": not nine
/// joints with 22 motions, a link, joint or camera that is missing, a bad number, an unknown eod:
/// element.
RobotModel LoadRobot(const std::filesystem::path& file);

/// State at the home pose, standing at the origin.
RobotState HomeState(const RobotModel& model);

/// Index of the link of this name, -1 if there is none.
int FindLink(const RobotModel& model, std::string_view name);

/// Index of the isector of this name, -1 if there is none.
int FindIsector(const RobotModel& model, std::string_view name);

/// Pose of every link in the frame that `state` is given in; same order as model.links.
/// `poses` keeps its memory between calls.
void LinkPoses(const RobotModel& model, const RobotState& state,
               std::vector<Eigen::Isometry3d>& poses);

}  // namespace eod::sim
