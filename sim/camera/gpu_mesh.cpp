#include "sim/camera/gpu_mesh.h"

#include <cstddef>

namespace eod::sim {
GpuMesh::GpuMesh(const GlFunctions& gl, const SurfaceMesh& mesh)
    : gl_(&gl), array_(MakeVertexArray(gl)), vertices_(MakeBuffer(gl)), indices_(MakeBuffer(gl)) {
  constexpr GLsizei kStride = sizeof(Vertex);
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                mesh.vertices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                mesh.indices.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                         BufferOffset(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 3, GL_SHORT, GL_TRUE, kStride, BufferOffset(offsetof(Vertex, normal)));
  gl.VertexAttribIPointer(2, 1, GL_UNSIGNED_SHORT, kStride, BufferOffset(offsetof(Vertex, bone)));
  gl.VertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, kStride, BufferOffset(offsetof(Vertex, uv)));
  gl.VertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                         BufferOffset(offsetof(Vertex, diffuse)));
  gl.VertexAttribPointer(5, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                         BufferOffset(offsetof(Vertex, lamps)));
  for (GLuint attribute = 0; attribute < 6; ++attribute) gl.EnableVertexAttribArray(attribute);
}

void GpuMesh::Bind() const { gl_->BindVertexArray(array_.id()); }

ColourTriangles::ColourTriangles(const GlFunctions& gl)
    : gl_(&gl), array_(MakeVertexArray(gl)), vertices_(MakeBuffer(gl)) {
  constexpr GLsizei kStride = sizeof(ColourVertex);
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                         BufferOffset(offsetof(ColourVertex, position)));
  gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                         BufferOffset(offsetof(ColourVertex, colour)));
  gl.EnableVertexAttribArray(0);
  gl.EnableVertexAttribArray(1);
}

void ColourTriangles::Draw(std::span<const ColourVertex> vertices) const {
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                  GL_STREAM_DRAW);
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace eod::sim
