#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <sdf/Element.hh>
#include <sdf/Geometry.hh>
#include <sdf/Material.hh>

#include "sim/sdf/sdf_file.h"

namespace eod::sim {

/// What both a visual and a collision can look like; private to this folder.
struct SdfGeometry {
  Visual::Shape kind = Visual::Shape::kMesh;
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  Mesh mesh;
  std::optional<Primitive> solid;  ///< exactly what the file says; none of plane, mesh and cone
};

/// `customs` may say that a cylinder tapers to a cone (`<eod:cone/>`), and how finely a plane is
/// cut (`<eod:grid cell="2"/>`). Throws "FILE:LINE: …" for a shape that is not supported.
SdfGeometry ToGeometry(const sdf::Geometry& geometry, const std::vector<CustomElement>& customs,
                       const sdf::ElementPtr& owner, const std::filesystem::path& file);

/// Colour of `material`, texture of `surface`; either may be null.
Material ToMaterial(const sdf::Material* material, const CustomElement* surface);

}  // namespace eod::sim
