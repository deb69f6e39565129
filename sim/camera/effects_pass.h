#pragma once

#include <Eigen/Geometry>

#include "sim/camera/gl_object.h"
#include "sim/plume/picture_effects.h"

namespace eod::sim {

/// How far the camera is shaken out of its place: X_CS, a rotation by at most `effects.shake` about
/// each axis.
Eigen::Isometry3d ShakeOf(const PictureEffects& effects);

/// Noise and flash over the whole picture.
class EffectsPass {
 public:
  explicit EffectsPass(const GlFunctions& gl);

  /// Over a picture of `height` pixels; grains are as large in every size. Nothing without effects.
  /// Leaves blending off and the depth test on.
  void Draw(const PictureEffects& effects, int height) const;

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GlObject grains_;
  GlObject array_;  ///< without attributes: the shader knows its three corners
  GLint noise_;
  GLint flash_;
  GLint shift_;
  GLint scale_;
};

}  // namespace eod::sim
