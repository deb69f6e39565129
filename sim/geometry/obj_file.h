#pragma once

#include <filesystem>

#include "sim/geometry/mesh.h"

namespace eod::sim {

/// Reads the triangles of a Wavefront OBJ file: `v` and `f` lines, polygons cut into fans; names,
/// normals, texture coordinates and groups are passed over.
/// Throws std::runtime_error "FILE:LINE: …".
Mesh ReadObj(const std::filesystem::path& file);

}  // namespace eod::sim
