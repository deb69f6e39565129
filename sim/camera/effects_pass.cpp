#include "sim/camera/effects_pass.h"

#include <cmath>

#include "sim/camera/noise.h"
#include "sim/camera/render_target.h"
#include "sim/camera/shaders.h"

namespace eod::sim {
namespace {

constexpr int kGrains = 128;       // a side of the texture
constexpr float kGrainRows = 160;  // of grains over the height of a picture
constexpr float kLow = 0.12F;      // darkest and lightest grain
constexpr float kHigh = 0.62F;

Image PaintGrains() {
  Canvas canvas(kGrains, kGrains);
  for (int y = 0; y < kGrains; ++y) {
    for (int x = 0; x < kGrains; ++x) {
      canvas.At(x, y) = Eigen::Vector3f::Constant(std::lerp(kLow, kHigh, LatticeValue(x, y, 5)));
    }
  }
  return canvas.ToImage();
}

}  // namespace

Eigen::Isometry3d ShakeOf(const PictureEffects& effects) {
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  if (effects.shake == 0) return X_CS;
  for (int axis = 0; axis < 3; ++axis) {
    const float share = 2 * LatticeValue(axis, 0, effects.seed) - 1;
    X_CS.rotate(
        Eigen::AngleAxisd(static_cast<double>(effects.shake * share), Eigen::Vector3d::Unit(axis)));
  }
  return X_CS;
}

EffectsPass::EffectsPass(const GlFunctions& gl)
    : gl_(&gl),
      program_(MakeProgram(gl, "effects", kEffectsVertexShader, kEffectsFragmentShader)),
      grains_(UploadPanorama(gl, PaintGrains())),
      array_(MakeVertexArray(gl)),
      noise_(gl.GetUniformLocation(program_.id(), "u_noise")),
      flash_(gl.GetUniformLocation(program_.id(), "u_flash")),
      shift_(gl.GetUniformLocation(program_.id(), "u_shift")),
      scale_(gl.GetUniformLocation(program_.id(), "u_scale")) {
  gl.BindTexture(GL_TEXTURE_2D, grains_.id());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl.UseProgram(program_.id());
  gl.Uniform1i(gl.GetUniformLocation(program_.id(), "u_grains"), 0);
}

void EffectsPass::Draw(const PictureEffects& effects, int height) const {
  if (effects.noise == 0 && effects.flash == 0) return;
  const Eigen::Vector3f shift(LatticeValue(3, 0, effects.seed), LatticeValue(4, 0, effects.seed),
                              LatticeValue(5, 0, effects.seed));
  gl_->UseProgram(program_.id());
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, grains_.id());
  gl_->BindVertexArray(array_.id());
  gl_->Uniform1f(noise_, effects.noise);
  gl_->Uniform1f(flash_, effects.flash);
  gl_->Uniform3fv(shift_, 1, shift.data());
  gl_->Uniform1f(scale_, kGrainRows / kGrains / static_cast<float>(height));
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Disable(GL_BLEND);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace eod::sim
