#pragma once

#include <filesystem>
#include <vector>

#include <sdf/Element.hh>
#include <sdf/Light.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/SemanticPose.hh>

#include "sim/sdf/sdf_file.h"

namespace eod::sim {

/// Translation from libsdformat's objects to ours; private to this folder.

int LineOf(const sdf::ElementPtr& element);
std::vector<CustomElement> CustomsOf(const sdf::ElementPtr& element,
                                     const std::filesystem::path& file);
Eigen::Isometry3d ToIsometry(const ignition::math::Pose3d& pose);
Eigen::Vector3f ToColour(const ignition::math::Color& colour);

/// Pose relative to `frame` ("" for the default). Throws "FILE:LINE: …" if it cannot be resolved.
Eigen::Isometry3d Resolve(const sdf::SemanticPose& pose, const std::string& frame,
                          const sdf::ElementPtr& element, const std::filesystem::path& file);

/// A light of the world keeps the pose that it is given in `relative_to`, one of a link has it in
/// the link's frame. Throws "FILE:LINE: …" for an attenuation without light or range, or a spot
/// whose cones are none.
SdfLight ToLight(const sdf::Light& light, bool is_of_world, const std::filesystem::path& file);
SdfLink ToLink(const sdf::Link& link, const std::filesystem::path& file);
SdfModel ToModel(const sdf::Model& model, const std::filesystem::path& file);

}  // namespace eod::sim
