#include "sim/camera/noise.h"

#include <cmath>

namespace eod::sim {
namespace {

// Avalanche of two multiplications (constants by C. Wellons, "lowbias32").
uint32_t Mix(uint32_t value) {
  value = (value ^ (value >> 16)) * 0x7feb352dU;
  value = (value ^ (value >> 15)) * 0x846ca68bU;
  return value ^ (value >> 16);
}

constexpr float kUnit = 1.0F / 16777216.0F;  // 2^-24: what a float's mantissa holds

int Wrap(int value, int period) {
  if (value >= 0 && value < period) return value;  // the common case, without a division
  const int rest = value % period;
  return rest < 0 ? rest + period : rest;
}

float Smooth(float t) { return t * t * (3.0F - 2.0F * t); }

}  // namespace

float LatticeValue(int x, int y, uint32_t seed) {
  const uint32_t key = static_cast<uint32_t>(x) * 0x8da6b343U ^
                       static_cast<uint32_t>(y) * 0xd8163841U ^ (seed + 1U) * 0xcb1ab31fU;
  return static_cast<float>(Mix(key) >> 8) * kUnit;
}

float TilingNoise(float x, float y, int period, uint32_t seed) {
  const float floor_x = std::floor(x);
  const float floor_y = std::floor(y);
  const float u = Smooth(x - floor_x);
  const float v = Smooth(y - floor_y);
  const int x0 = Wrap(static_cast<int>(floor_x), period);
  const int y0 = Wrap(static_cast<int>(floor_y), period);
  const int x1 = Wrap(x0 + 1, period);
  const int y1 = Wrap(y0 + 1, period);
  const float bottom = std::lerp(LatticeValue(x0, y0, seed), LatticeValue(x1, y0, seed), u);
  const float top = std::lerp(LatticeValue(x0, y1, seed), LatticeValue(x1, y1, seed), u);
  return std::lerp(bottom, top, v);
}

float TilingFbm(float x, float y, int period, int octaves, uint32_t seed) {
  float sum = 0;
  float weight = 0.5F;
  float total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * TilingNoise(x, y, period, seed + static_cast<uint32_t>(octave) * 101U);
    total += weight;
    weight *= 0.5F;
    x *= 2.0F;
    y *= 2.0F;
    period *= 2;
  }
  return sum / total;
}

float PaintRandom::Uniform(float low, float high) {
  state_ += 0x9e3779b9U;
  return low + (high - low) * (static_cast<float>(Mix(state_) >> 8) * kUnit);
}

}  // namespace eod::sim
