#include "sim/camera/sky_dome.h"

#include <cmath>
#include <numbers>

#include "sim/camera/render_target.h"
#include "sim/camera/shaders.h"
#include "sim/camera/sky_panorama.h"

namespace eod::sim {
namespace {

constexpr int kPanoramaWidth = 3072;
constexpr int kPanoramaHeight = 384;
constexpr int kColumns = 48;
constexpr int kRows = 16;

/// Dome of unit radius seen from inside; bands as the panorama's rows lie.
SurfaceMesh MakeDome() {
  SurfaceMesh dome;
  for (int row = 0; row <= kRows; ++row) {
    const float v = static_cast<float>(row) / kRows;
    const float elevation = PanoramaElevation(v);
    for (int column = 0; column <= kColumns; ++column) {
      const float u = static_cast<float>(column) / kColumns;
      const float azimuth = 2 * std::numbers::pi_v<float> * u;
      Vertex vertex{};
      vertex.position[0] = std::sin(azimuth) * std::cos(elevation);
      vertex.position[1] = std::cos(azimuth) * std::cos(elevation);
      vertex.position[2] = std::sin(elevation);
      vertex.uv[0] = u;
      vertex.uv[1] = v;
      dome.vertices.push_back(vertex);
    }
  }
  for (uint32_t row = 0; row < kRows; ++row) {
    for (uint32_t column = 0; column < kColumns; ++column) {
      const uint32_t corner = row * (kColumns + 1) + column;
      const uint32_t above = corner + kColumns + 1;
      dome.indices.insert(dome.indices.end(),
                          {corner, corner + 1, above + 1, corner, above + 1, above});
    }
  }
  return dome;
}

}  // namespace

SkyDome::SkyDome(const GlFunctions& gl)
    : gl_(&gl),
      program_(MakeProgram(gl, "sky", kSkyVertexShader, kSkyFragmentShader)),
      view_projection_(gl.GetUniformLocation(program_.id(), "u_view_projection")),
      grey_(gl.GetUniformLocation(program_.id(), "u_grey")),
      dome_(MakeDome()),
      mesh_(gl, dome_) {}

void SkyDome::SetLook(const SkyLook& look) {
  if (look_ == look) return;
  look_ = look;
  texture_.reset();
  texture_.emplace(UploadPanorama(*gl_, PaintSkyPanorama(look, kPanoramaWidth, kPanoramaHeight)));
}

int SkyDome::Draw(const View& view, bool is_infrared) const {
  // The dome is centred on the eye: directions only.
  Eigen::Matrix4d directions = view.clip;
  directions.col(3) += view.clip.leftCols<3>() * view.p_ME;
  const Eigen::Matrix4f clip = directions.cast<float>();
  gl_->UseProgram(program_.id());
  gl_->UniformMatrix4fv(view_projection_, 1, GL_FALSE, clip.data());
  gl_->Uniform1f(grey_, is_infrared ? 1.0F : 0.0F);
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, texture_->id());
  gl_->DepthFunc(GL_LEQUAL);
  gl_->Disable(GL_CULL_FACE);
  mesh_.Bind();
  const auto count = static_cast<GLsizei>(dome_.indices.size());
  gl_->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  gl_->Enable(GL_CULL_FACE);
  gl_->DepthFunc(GL_LESS);
  return count / 3;
}

}  // namespace eod::sim
