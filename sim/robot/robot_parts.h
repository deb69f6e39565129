#pragma once

#include "sim/robot/robot_model.h"
#include "sim/sdf/sdf_file.h"

namespace eod::sim {

/// The steps of LoadRobot; private to this folder. All throw "FILE:LINE: …".

/// Links in an order in which parents come first, and how they hang together.
/// `order[i]` is the index in sdf.links of links[i].
struct LinkTree {
  std::vector<LinkSpec> links;
  std::vector<int> order;
};
LinkTree ReadLinks(const SdfModel& sdf, const std::filesystem::path& file);

/// The nine joints, with their motions; sets LinkSpec::joint, scale and hand of the links they
/// move.
std::array<JointSpec, kJointCount> ReadJoints(const SdfModel& sdf,
                                              const std::filesystem::path& file,
                                              std::vector<LinkSpec>& links);

/// The poses that the box can ask for: `<eod:preset>`.
std::vector<PresetSpec> ReadPresets(const SdfModel& sdf,
                                    const std::array<JointSpec, kJointCount>& joints);

/// `<eod:payload>`.
PayloadSpec ReadPayload(const SdfModel& sdf);

/// `<eod:battery>`.
BatterySpec ReadBattery(const SdfModel& sdf);

/// An `<eod:isector>` of link `link`. Lines of TRIPOD and of height isectors reach from
/// `model.step_up_limit` above to `model.fall_search` below.
IsectorSpec ReadIsector(const CustomElement& element, int link, const RobotModel& model);

/// A spot light of link `link`, with `<eod:lamp>`.
SpotLightSpec ReadLight(const SdfLight& light, int link, const std::filesystem::path& file);

/// The `<eod:stance>` of a robot whose links are known. Throws too if a tilted outline or a number
/// is none.
StanceSpec ReadStance(const SdfModel& sdf, const RobotModel& model);

}  // namespace eod::sim
