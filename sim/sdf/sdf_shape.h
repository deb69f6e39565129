#pragma once

#include <filesystem>
#include <vector>

#include <sdf/Element.hh>
#include <sdf/Geometry.hh>
#include <sdf/Material.hh>

#include "sim/sdf/sdf_file.h"

namespace eod::sim {

/// A shape that both a visual and a collision can have; private to this folder.
struct Shape {
  Visual::Shape kind = Visual::Shape::kMesh;
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  Mesh mesh;
};

/// `customs` may say that a cylinder tapers to a cone (`<eod:cone/>`), and how finely a plane is
/// cut
/// (`<eod:grid cell="2"/>`). Throws "FILE:LINE: …" for a shape that is not supported.
Shape ToShape(const sdf::Geometry& geometry, const std::vector<CustomElement>& customs,
              const sdf::ElementPtr& owner, const std::filesystem::path& file);

/// Colour of `material`, texture of `surface`; either may be null.
Material ToMaterial(const sdf::Material* material, const CustomElement* surface);

}  // namespace eod::sim
