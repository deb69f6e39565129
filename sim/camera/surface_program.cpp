#include "sim/camera/surface_program.h"

#include <algorithm>
#include <numbers>

#include "sim/camera/shaders.h"

namespace eod::sim {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

constexpr float kSunStrength = 1.45F;
constexpr float kSkyStrength = 0.62F;

void UploadBones(const GlFunctions& gl, GLint location, const BonePalette& palette) {
  gl.Uniform4fv(location, static_cast<GLsizei>(palette.size()), palette.front().data());
}

}  // namespace

void SetBone(const Eigen::Isometry3d& X_MB, size_t bone, BonePalette& palette) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    palette.at(3 * bone + static_cast<size_t>(row)) =
        X_MB.matrix().row(row).transpose().cast<float>();
  }
}

void HideBone(size_t bone, BonePalette& palette) {
  std::fill_n(palette.begin() + static_cast<std::ptrdiff_t>(3 * bone), 3, Eigen::Vector4f::Zero());
}

SurfaceProgram::SurfaceProgram(const GlFunctions& gl, Kind kind, const Atmosphere& atmosphere)
    : gl_(&gl),
      program_(MakeProgram(gl, kind == Kind::kGround ? "ground" : "surface", kSurfaceVertexShader,
                           kSurfaceFragmentShader, kind == Kind::kGround ? "#define GROUND" : "")),
      bones_(gl.GetUniformLocation(program_.id(), "u_bones")),
      view_projection_(gl.GetUniformLocation(program_.id(), "u_view_projection")),
      shadow_matrix_(gl.GetUniformLocation(program_.id(), "u_shadow_matrix")),
      eye_(gl.GetUniformLocation(program_.id(), "u_eye")) {
  const auto location = [&](const char* name) {
    return gl.GetUniformLocation(program_.id(), name);
  };
  const auto set = [&](const char* name, const Vector3f& value) {
    gl.Uniform3fv(location(name), 1, value.data());
  };
  gl.UseProgram(program_.id());
  gl.Uniform1i(location("u_texture"), kTextureUnit - GL_TEXTURE0);
  gl.Uniform1i(location("u_variation"), kVariationUnit - GL_TEXTURE0);
  gl.Uniform1i(location("u_shadow"), kShadowUnit - GL_TEXTURE0);
  set("u_to_sun", atmosphere.sun_direction.normalized());
  set("u_sun_light", atmosphere.sun_colour * kSunStrength);
  // Light from above is the sky's own colour paled by clouds; from below, what grass gives back.
  set("u_sky_light", (0.5F * atmosphere.sky_colour + Vector3f::Constant(0.34F)) * kSkyStrength);
  set("u_ground_light", Vector3f(0.20F, 0.20F, 0.15F));
  set("u_fog_colour", atmosphere.fog_colour);
  gl.Uniform1f(location("u_fog_density"), atmosphere.fog_density * std::numbers::log2e_v<float>);
}

void SurfaceProgram::Use(const View& camera, const View& sun) const {
  // Clip space of the sun, -1..1, to texture coordinates, 0..1.
  Eigen::Matrix4d texture_clip = Eigen::Matrix4d::Identity() * 0.5;
  texture_clip.topRightCorner<3, 1>().setConstant(0.5);
  texture_clip(3, 3) = 1;
  const Matrix4f clip = camera.clip.cast<float>();
  const Matrix4f shadow = (texture_clip * sun.clip).cast<float>();
  const Vector3f eye = camera.p_ME.cast<float>();
  gl_->UseProgram(program_.id());
  gl_->UniformMatrix4fv(view_projection_, 1, GL_FALSE, clip.data());
  gl_->UniformMatrix4fv(shadow_matrix_, 1, GL_FALSE, shadow.data());
  gl_->Uniform3fv(eye_, 1, eye.data());
}

void SurfaceProgram::SetBones(const BonePalette& palette) const {
  UploadBones(*gl_, bones_, palette);
}

ShadowProgram::ShadowProgram(const GlFunctions& gl)
    : gl_(&gl),
      program_(MakeProgram(gl, "shadow", kShadowVertexShader, kShadowFragmentShader)),
      bones_(gl.GetUniformLocation(program_.id(), "u_bones")),
      view_projection_(gl.GetUniformLocation(program_.id(), "u_view_projection")) {}

void ShadowProgram::Use(const View& sun, const BonePalette& palette) const {
  const Matrix4f clip = sun.clip.cast<float>();
  gl_->UseProgram(program_.id());
  gl_->UniformMatrix4fv(view_projection_, 1, GL_FALSE, clip.data());
  UploadBones(*gl_, bones_, palette);
}

}  // namespace eod::sim
