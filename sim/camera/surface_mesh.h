#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/visual.h"

namespace eod::sim {

/// Lamps may be up to this bright on a surface, see Vertex::lamps.
inline constexpr float kBrightest = 4;

/// One corner as the vertex shader reads it: 36 bytes.
struct Vertex {
  float position[3];   ///< in the frame of its bone
  int16_t normal[3];   ///< unit vector times 32767
  uint16_t bone;       ///< index of the pose to apply; 0 for the static world
  float uv[2];         ///< in texture tiles
  uint8_t diffuse[3];  ///< square root of the linear colour, times 255
  uint8_t specular;    ///< 0..255
  uint8_t lamps[3];    ///< square root of the linear light that fast lamps give, and that it has of
                       ///< its own, over kBrightest, times 255
  uint8_t sky;         ///< share of the sky that shines on it, 0..255
};
static_assert(sizeof(Vertex) == 36);

/// Triangles over shared vertices, counter-clockwise seen from outside.
struct SurfaceMesh {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
};

/// How finely shapes are cut into triangles.
struct Detail {
  double chamfer = 0;     ///< [m] on edges of boxes that are large enough: they catch light
  int max_segments = 24;  ///< of a full circle
  double min_extent = 0;  ///< [m] shapes smaller than this in every direction are left out
  double cluster = 0;     ///< [m] corners of a mesh this near to each other become one
};

/// Largest length of a shape along its own axes [m].
double Extent(const Visual& visual);

/// Adds the triangles of `visual`, placed by `X_BO` in the frame of bone `bone`. Texture
/// coordinates run in metres over the surface, divided by the material's tile size.
void AppendVisual(const Visual& visual, const Eigen::Isometry3d& X_BO, int bone,
                  const Detail& detail, SurfaceMesh& mesh);

}  // namespace eod::sim
