#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

namespace eod::sim {

/// Throws std::runtime_error "FILE:LINE: TEXT"; without a line if it is 0.
[[noreturn]] void FailAt(const std::filesystem::path& file, int line, const std::string& text);

/// An element of our own in an SDFormat file: `<eod:NAME attribute="…">`, which other tools pass
/// over. What SDFormat has no word for is said with them:
///
///   visual     <eod:surface texture="brick" tile="0.75"/>: texture by name, size of a tile [m]
///   visual, collision  <eod:cone/>: the cylinder tapers to its top; <eod:grid cell="2"/>: how
///              finely a plane is cut [m]
///   collision  <eod:proxy kind="clamp|bump|both"/>: stood on, run into, or both (default)
///   world      <eod:module id name frame size_x_m size_y_m start_heading_deg/>: a training area;
///              its models are posed relative_to its frame, whose origin is the start pad
///   model      <eod:movable friction="0.6" rolling_m="0.0005"/>: it is not static; Coulomb
///   friction
///              and lever of rolling resistance; <eod:explosive/>: it is a charge;
///              <eod:vessel kind="drum" inner_radius_m net_m rim_m/>,
///              <eod:vessel kind="chamber" inner_x_m inner_y_m net_m rim_m/>: a static model that
///              a charge is disposed of in; heights above the model's origin
///   model      <eod:chassis creep_mps low_mps high_mps turn_deg_per_s accel_mps2
///              turn_accel_deg_per_s2 step_up_m fall_search_m track_m/>; <eod:payload folded_kg
///              stretched_kg/>: what the arm can carry; <eod:battery full_v empty_v
///              capacity_ah resistance_ohm idle_a drive_a joint_a low_v/>; <eod:preset index name
///              J1_deg .. J7_m ..
///              />: a pose that the box can ask for, joints left out stay where they are;
///              <eod:stance friction pitch_limit_deg roll_limit_deg .../> with <eod:support link x
///              outline/>: how it stands on any ground; an outline is a closed polygon y z y z ...
///              in the link's plane at each x, counter-clockwise seen from +X
///   joint      <eod:motion index positive negative home_deg|home_m accel_deg_per_s2|accel_mps2/>:
///              this is J1..J9, and the two motions that move it; <eod:follows joint scale hand/>:
///              moved by another joint
///   light      <eod:lamp switch="drive|gripper|infrared"/>: of the robot: what turns it on
///   sensor     <eod:zoom narrowest_deg="6" factor_per_s="1.8"/>: the camera zooms from its
///              horizontal_fov to that angle, its magnification growing by the factor each second
///   link       <eod:isector name method part motions pose coverage face hit classes> with
///              <eod:segment name start direction length d0 skin motions blocks enabled/>:
///              `motions` (loaded for) and `blocks` (may stop) are "M01 M03", "all" or "always";
///              face="two_sided|front_only", hit="nearest|highest|all", classes are some of "bump
///              clamp bomb movable vessel", enabled="true|false"
struct CustomElement {
  std::filesystem::path file;
  int line = 0;
  std::string name;  ///< without the prefix
  std::map<std::string, std::string> attributes;
  std::vector<CustomElement> children;

  bool Has(const std::string& attribute) const { return attributes.contains(attribute); }
  /// The getters throw std::runtime_error "FILE:LINE: …" if the attribute is missing or bad.
  const std::string& Text(const std::string& attribute) const;
  double Number(const std::string& attribute, double lowest, double highest) const;
  int Integer(const std::string& attribute, int lowest, int highest) const;
  Eigen::Vector3d Vector(const std::string& attribute) const;
  /// Any number of numbers, none too.
  std::vector<double> Numbers(const std::string& attribute) const;
  /// Six numbers as in an SDFormat pose: x y z [m], roll pitch yaw about fixed X Y Z [deg].
  Eigen::Isometry3d Pose(const std::string& attribute) const;

  /// Throws unless every attribute is one of `allowed`, and `children` are only where allowed.
  void AllowAttributes(std::initializer_list<std::string_view> allowed) const;
  [[noreturn]] void Fail(const std::string& text) const { FailAt(file, line, text); }
};

/// Throws "FILE:LINE: …" for the first element whose name is not in `allowed`; `where` names the
/// owner.
void AllowElements(const std::vector<CustomElement>& elements,
                   std::initializer_list<std::string_view> allowed, std::string_view where);

/// The only element of this name, or nullptr. Throws if there are two.
const CustomElement* FindElement(const std::vector<CustomElement>& elements, std::string_view name);

}  // namespace eod::sim
