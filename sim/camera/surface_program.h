#pragma once

#include <vector>

#include "sim/camera/gl_object.h"
#include "sim/camera/view.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Rows of the poses that vertices name by their bone: three vectors a bone.
using BonePalette = std::vector<Eigen::Vector4f>;
/// A palette is for the static world and 64 links, or for 64 movable objects.
inline constexpr size_t kMaxBones = 65;

/// Writes `X_MB` as bone number `bone`.
void SetBone(const Eigen::Isometry3d& X_MB, size_t bone, BonePalette& palette);
/// Draws nothing of bone number `bone`: all of it shrinks to a point.
void HideBone(size_t bone, BonePalette& palette);

/// The shader that lights textured surfaces, with the sun's shadow and fog.
class SurfaceProgram {
 public:
  enum class Kind { kTextured, kGround };

  /// Texture units as the program expects them.
  static constexpr GLenum kTextureUnit = GL_TEXTURE0, kVariationUnit = GL_TEXTURE1,
                          kShadowUnit = GL_TEXTURE2;

  SurfaceProgram(const GlFunctions& gl, Kind kind, const Atmosphere& atmosphere);

  /// Makes it current for pictures of `camera` with the shadow that `sun` cast.
  void Use(const View& camera, const View& sun) const;
  /// The program must be current.
  void SetBones(const BonePalette& palette) const;

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GLint bones_;
  GLint view_projection_;
  GLint shadow_matrix_;
  GLint eye_;
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
