#include "sim/camera/surface_program.h"

#include <algorithm>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "sim/camera/shaders.h"

namespace eod::sim {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using Eigen::Vector4f;

// How much of the sky wet surfaces mirror at a grazing angle: grass hardly, asphalt much.
constexpr float kGroundSheen = 0.12F;
constexpr float kSurfaceSheen = 0.75F;

void UploadBones(const GlFunctions& gl, GLint location, const BonePalette& palette) {
  gl.Uniform4fv(location, static_cast<GLsizei>(palette.size()), palette.front().data());
}

std::string DefinesOf(const SurfaceFeatures& features) {
  std::string defines;
  if (features.is_ground) defines += "#define GROUND\n";
  if (features.spots > 0) defines += fmt::format("#define SPOTS {}\n", features.spots);
  if (features.is_wet) {
    defines += fmt::format("#define WET {}\n", features.is_ground ? kGroundSheen : kSurfaceSheen);
  }
  if (features.is_infrared) defines += "#define INFRARED\n";
  return defines;
}

}  // namespace

BonePalette MakePalette(size_t bones) {
  BonePalette palette(kBoneRows * bones);
  for (size_t bone = 0; bone < bones; ++bone) {
    SetBone(Eigen::Isometry3d::Identity(), bone, palette);
    SetBoneLight({}, bone, palette);
  }
  return palette;
}

void SetBone(const Eigen::Isometry3d& X_MB, size_t bone, BonePalette& palette) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    palette.at(kBoneRows * bone + static_cast<size_t>(row)) =
        X_MB.matrix().row(row).transpose().cast<float>();
  }
}

void SetBoneLight(const PlaceLight& light, size_t bone, BonePalette& palette) {
  palette.at(kBoneRows * bone + 3) << light.lamps, light.sky;
}

Eigen::AlignedBox3f Placed(const Eigen::AlignedBox3f& box, size_t bone,
                           const BonePalette& palette) {
  const Vector3f centre = box.center();
  const Vector3f half = box.sizes() / 2;
  Vector3f middle;
  Vector3f reach;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Eigen::Vector4f& pose = palette.at(kBoneRows * bone + static_cast<size_t>(row));
    middle[row] = pose.dot(centre.homogeneous());
    reach[row] = pose.head<3>().cwiseAbs().dot(half);
  }
  return {middle - reach, middle + reach};
}

void HideBone(size_t bone, BonePalette& palette) {
  std::fill_n(palette.begin() + static_cast<std::ptrdiff_t>(kBoneRows * bone), 3, Vector4f::Zero());
}

SurfaceProgram::SurfaceProgram(const GlFunctions& gl, const SurfaceFeatures& features)
    : gl_(&gl),
      is_infrared_(features.is_infrared),
      program_(MakeProgram(gl, features.is_ground ? "ground" : "surface", kSurfaceVertexShader,
                           kSurfaceFragmentShader, DefinesOf(features))) {
  // In the order of Uniform; those that the features do not need are -1, which OpenGL passes over.
  constexpr std::array<const char*, kUniforms> kNames{
      "u_bones",      "u_view_projection", "u_shadow_matrix", "u_eye",
      "u_to_sun",     "u_sun_light",       "u_sky_light",     "u_ground_light",
      "u_fog_colour", "u_fog_density",     "u_wetness",       "u_sheen",
      "u_spot_place", "u_spot_way",        "u_spot_light",    "u_spot_fade"};
  std::transform(kNames.begin(), kNames.end(), locations_.begin(),
                 [&](const char* name) { return gl.GetUniformLocation(program_.id(), name); });
  const auto set_unit = [&](const char* name, GLenum unit) {
    gl.Uniform1i(gl.GetUniformLocation(program_.id(), name),
                 static_cast<GLint>(unit - GL_TEXTURE0));
  };
  gl.UseProgram(program_.id());
  set_unit("u_texture", kTextureUnit);
  set_unit("u_variation", kVariationUnit);
  set_unit("u_shadow", kShadowUnit);
}

void SurfaceProgram::Use(const View& camera, const View& sun, const Lighting& lighting,
                         std::span<const ShiningSpot> spots) const {
  // Clip space of the sun, -1..1, to texture coordinates, 0..1.
  Eigen::Matrix4d texture_clip = Eigen::Matrix4d::Identity() * 0.5;
  texture_clip.topRightCorner<3, 1>().setConstant(0.5);
  texture_clip(3, 3) = 1;
  const Matrix4f clip = camera.clip.cast<float>();
  const Matrix4f shadow = (texture_clip * sun.clip).cast<float>();
  const Vector3f eye = camera.p_ME.cast<float>();
  gl_->UseProgram(program_.id());
  gl_->UniformMatrix4fv(locations_[kViewProjection], 1, GL_FALSE, clip.data());
  gl_->UniformMatrix4fv(locations_[kShadowMatrix], 1, GL_FALSE, shadow.data());
  gl_->Uniform3fv(locations_[kEye], 1, eye.data());
  SetLight(lighting);
  if (!spots.empty()) SetSpots(spots);
}

void SurfaceProgram::SetLight(const Lighting& lighting) const {
  const auto set = [this](Uniform uniform, const Vector3f& value) {
    gl_->Uniform3fv(locations_[uniform], 1, value.data());
  };
  const Vector3f fog =
      is_infrared_ ? Vector3f::Constant(lighting.fog_colour.mean()) : lighting.fog_colour;
  set(kToSun, lighting.to_sun);
  set(kSunLight, lighting.sun_light);
  set(kSkyLight, lighting.sky_light);
  set(kGroundLight, lighting.ground_light);
  set(kFogColour, fog);
  set(kSheen, lighting.fog_colour.cwiseAbs2());
  gl_->Uniform1f(locations_[kWetness], lighting.wetness);
  gl_->Uniform1f(locations_[kFogDensity], lighting.fog_density * std::numbers::log2e_v<float>);
}

void SurfaceProgram::SetSpots(std::span<const ShiningSpot> spots) const {
  std::array<Vector4f, kMaxSpots> place, way, light;
  std::array<Vector3f, kMaxSpots> fade;
  for (size_t i = 0; i < spots.size(); ++i) {
    const ShiningSpot& spot = spots[i];
    const Falloff& falloff = spot.light.falloff;
    place.at(i) << spot.p_M, static_cast<float>(1 / (falloff.range * falloff.range));
    way.at(i) << spot.direction, spot.dark_cosine;
    light.at(i) << spot.light.colour, 1 / (spot.bright_cosine - spot.dark_cosine);
    fade.at(i) = Eigen::Vector3d(falloff.constant, falloff.linear, falloff.quadratic).cast<float>();
  }
  const auto count = static_cast<GLsizei>(spots.size());
  gl_->Uniform4fv(locations_[kSpotPlace], count, place.front().data());
  gl_->Uniform4fv(locations_[kSpotWay], count, way.front().data());
  gl_->Uniform4fv(locations_[kSpotLight], count, light.front().data());
  gl_->Uniform3fv(locations_[kSpotFade], count, fade.front().data());
}

void SurfaceProgram::SetBones(const BonePalette& palette) const {
  UploadBones(*gl_, locations_[kBones], palette);
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
