// Some floats side by side, for the kernels alone: each translation unit is compiled for another
// instruction set, so everything here is local to it.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace eod::sim {
namespace {

#if defined(__AVX2__)

struct Lanes {
  static constexpr int kWidth = 8;
  __m256 v;

  static Lanes Load(const float* from) { return {_mm256_loadu_ps(from)}; }
  static Lanes All(float value) { return {_mm256_set1_ps(value)}; }
  void Store(float* to) const { _mm256_storeu_ps(to, v); }
};
inline Lanes operator+(Lanes a, Lanes b) { return {_mm256_add_ps(a.v, b.v)}; }
inline Lanes operator-(Lanes a, Lanes b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline Lanes operator*(Lanes a, Lanes b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline Lanes operator&(Lanes a, Lanes b) { return {_mm256_and_ps(a.v, b.v)}; }
inline Lanes operator^(Lanes a, Lanes b) { return {_mm256_xor_ps(a.v, b.v)}; }
inline Lanes AndNot(Lanes not_a, Lanes b) { return {_mm256_andnot_ps(not_a.v, b.v)}; }
inline Lanes operator<=(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
inline Lanes Least(Lanes a, Lanes b) { return {_mm256_min_ps(a.v, b.v)}; }
inline Lanes Largest(Lanes a, Lanes b) { return {_mm256_max_ps(a.v, b.v)}; }
inline uint32_t Bits(Lanes mask) { return static_cast<uint32_t>(_mm256_movemask_ps(mask.v)); }

#elif defined(__SSE2__)

struct Lanes {
  static constexpr int kWidth = 4;
  __m128 v;

  static Lanes Load(const float* from) { return {_mm_loadu_ps(from)}; }
  static Lanes All(float value) { return {_mm_set1_ps(value)}; }
  void Store(float* to) const { _mm_storeu_ps(to, v); }
};
inline Lanes operator+(Lanes a, Lanes b) { return {_mm_add_ps(a.v, b.v)}; }
inline Lanes operator-(Lanes a, Lanes b) { return {_mm_sub_ps(a.v, b.v)}; }
inline Lanes operator*(Lanes a, Lanes b) { return {_mm_mul_ps(a.v, b.v)}; }
inline Lanes operator&(Lanes a, Lanes b) { return {_mm_and_ps(a.v, b.v)}; }
inline Lanes operator^(Lanes a, Lanes b) { return {_mm_xor_ps(a.v, b.v)}; }
inline Lanes AndNot(Lanes not_a, Lanes b) { return {_mm_andnot_ps(not_a.v, b.v)}; }
inline Lanes operator<=(Lanes a, Lanes b) { return {_mm_cmple_ps(a.v, b.v)}; }
inline Lanes Least(Lanes a, Lanes b) { return {_mm_min_ps(a.v, b.v)}; }
inline Lanes Largest(Lanes a, Lanes b) { return {_mm_max_ps(a.v, b.v)}; }
inline uint32_t Bits(Lanes mask) { return static_cast<uint32_t>(_mm_movemask_ps(mask.v)); }

#else

/// Four floats that any compiler can keep in a register of NEON and its like.
struct Lanes {
  static constexpr int kWidth = 4;
  using Floats [[gnu::vector_size(16)]] = float;
  using Words [[gnu::vector_size(16)]] = int32_t;
  Floats v;

  static Lanes Load(const float* from) { return {Floats{from[0], from[1], from[2], from[3]}}; }
  static Lanes All(float value) { return {Floats{value, value, value, value}}; }
  void Store(float* to) const {
    for (int i = 0; i < kWidth; ++i) to[i] = v[i];
  }
};
inline Lanes FromWords(Lanes::Words words) { return {reinterpret_cast<Lanes::Floats>(words)}; }
inline Lanes::Words WordsOf(Lanes a) { return reinterpret_cast<Lanes::Words>(a.v); }
inline Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
inline Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
inline Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
inline Lanes operator&(Lanes a, Lanes b) { return FromWords(WordsOf(a) & WordsOf(b)); }
inline Lanes operator^(Lanes a, Lanes b) { return FromWords(WordsOf(a) ^ WordsOf(b)); }
inline Lanes AndNot(Lanes not_a, Lanes b) { return FromWords(~WordsOf(not_a) & WordsOf(b)); }
inline Lanes operator<=(Lanes a, Lanes b) { return FromWords(a.v <= b.v); }
inline Lanes Least(Lanes a, Lanes b) { return {a.v < b.v ? a.v : b.v}; }
inline Lanes Largest(Lanes a, Lanes b) { return {a.v > b.v ? a.v : b.v}; }
inline uint32_t Bits(Lanes mask) {
  const Lanes::Words words = WordsOf(mask);
  uint32_t bits = 0;
  for (int i = 0; i < Lanes::kWidth; ++i) bits |= (words[i] < 0 ? 1u : 0u) << i;
  return bits;
}

#endif

/// Three coordinates of some points.
struct Points {
  Lanes x, y, z;
};

inline Points LoadPoints(const float (&from)[3][8], int at) {
  return {Lanes::Load(from[0] + at), Lanes::Load(from[1] + at), Lanes::Load(from[2] + at)};
}
inline Points LoadPoints(const float (&from)[3][16], int at) {
  return {Lanes::Load(from[0] + at), Lanes::Load(from[1] + at), Lanes::Load(from[2] + at)};
}
inline Points AllPoints(const float* xyz) {
  return {Lanes::All(xyz[0]), Lanes::All(xyz[1]), Lanes::All(xyz[2])};
}
inline Points operator-(const Points& a, const Points& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Lanes Dot(const Points& a, const Points& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Points Cross(const Points& a, const Points& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace
}  // namespace eod::sim
