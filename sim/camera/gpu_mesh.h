#pragma once

#include <span>

#include "sim/camera/gl_object.h"
#include "sim/camera/surface_mesh.h"

namespace eod::sim {

/// A mesh in OpenGL's memory. Attributes: 0 position, 1 normal, 2 bone, 3 uv, 4 diffuse and
/// specular, 5 lamps and sky.
class GpuMesh {
 public:
  GpuMesh(const GlFunctions& gl, const SurfaceMesh& mesh);
  void Bind() const;

 private:
  const GlFunctions* gl_;
  GlObject array_;
  GlObject vertices_;
  GlObject indices_;
};

/// Triangles that change with every picture: positions (attribute 0) and colours (attribute 1).
struct ColourVertex {
  float position[3];
  uint8_t colour[4];
};

class ColourTriangles {
 public:
  explicit ColourTriangles(const GlFunctions& gl);
  /// Uploads and draws; returns nothing to keep.
  void Draw(std::span<const ColourVertex> vertices) const;

 private:
  const GlFunctions* gl_;
  GlObject array_;
  GlObject vertices_;
};

}  // namespace eod::sim
