#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "sim/camera/gl_object.h"
#include "sim/camera/light_probe.h"
#include "sim/camera/lighting.h"
#include "sim/camera/spot_lights.h"
#include "sim/camera/view.h"

namespace eod::sim {

/// What vertices name by their bone: three rows of its pose, and the light around it.
using BonePalette = std::vector<Eigen::Vector4f>;
inline constexpr size_t kBoneRows = 4;
/// A palette is for the static world and 59 links, or for 59 movable objects.
inline constexpr size_t kMaxBones = 60;

/// A palette of bones that stand at the origin under the open sky.
BonePalette MakePalette(size_t bones);
/// Writes `X_MB` as bone number `bone`.
void SetBone(const Eigen::Isometry3d& X_MB, size_t bone, BonePalette& palette);
/// Writes what shines on bone number `bone`, its vertices' own light apart.
void SetBoneLight(const PlaceLight& light, size_t bone, BonePalette& palette);
/// The box around `box` of bone number `bone`, in the frame that the palette poses it in.
Eigen::AlignedBox3f Placed(const Eigen::AlignedBox3f& box, size_t bone, const BonePalette& palette);
/// Draws nothing of bone number `bone`: all of it shrinks to a point.
void HideBone(size_t bone, BonePalette& palette);

/// What a surface shader can do beyond sun, sky, shadow and fog. What is not needed costs nothing.
struct SurfaceFeatures {
  bool is_ground = false;
  int spots = 0;  ///< spot lights, 0..kMaxSpots
  bool is_wet = false;
  bool is_infrared = false;
  auto operator<=>(const SurfaceFeatures&) const = default;
};

/// A shader that lights textured surfaces, with the sun's shadow and fog.
class SurfaceProgram {
 public:
  /// Texture units as the program expects them.
  static constexpr GLenum kTextureUnit = GL_TEXTURE0, kVariationUnit = GL_TEXTURE1,
                          kShadowUnit = GL_TEXTURE2;

  SurfaceProgram(const GlFunctions& gl, const SurfaceFeatures& features);

  /// Makes it current for pictures of `camera` with the shadow that `sun` cast. `spots` are as many
  /// as the features say.
  void Use(const View& camera, const View& sun, const Lighting& lighting,
           std::span<const ShiningSpot> spots) const;
  /// The program must be current.
  void SetBones(const BonePalette& palette) const;

 private:
  enum Uniform : size_t {
    kBones,
    kViewProjection,
    kShadowMatrix,
    kEye,
    kToSun,
    kSunLight,
    kSkyLight,
    kGroundLight,
    kFogColour,
    kFogDensity,
    kWetness,
    kSheen,
    kSpotPlace,
    kSpotWay,
    kSpotLight,
    kSpotFade,
    kUniforms
  };
  void SetLight(const Lighting& lighting) const;
  void SetSpots(std::span<const ShiningSpot> spots) const;

  const GlFunctions* gl_;
  bool is_infrared_;
  GlObject program_;
  std::array<GLint, kUniforms> locations_{};
};

/// The surface shaders, each made when it is asked for first.
class SurfacePrograms {
 public:
  explicit SurfacePrograms(const GlFunctions& gl) : gl_(&gl) {}
  const SurfaceProgram& Get(const SurfaceFeatures& features) {
    return programs_.try_emplace(features, *gl_, features).first->second;
  }

 private:
  const GlFunctions* gl_;
  std::map<SurfaceFeatures, SurfaceProgram> programs_;
};

/// The shader that only writes depth, for the shadow map.
class ShadowProgram {
 public:
  explicit ShadowProgram(const GlFunctions& gl);
  void Use(const View& sun, const BonePalette& palette) const;

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GLint bones_;
  GLint view_projection_;
};

}  // namespace eod::sim
