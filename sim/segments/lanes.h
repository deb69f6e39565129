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
inline Lanes operator|(Lanes a, Lanes b) { return {_mm256_or_ps(a.v, b.v)}; }
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
inline Lanes operator|(Lanes a, Lanes b) { return {_mm_or_ps(a.v, b.v)}; }
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
inline Lanes operator|(Lanes a, Lanes b) { return FromWords(WordsOf(a) | WordsOf(b)); }
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

/// Four floats, such as x, y, z and whatever comes next.
using Four [[gnu::vector_size(16)]] = float;

inline void Store(Four v, float* to) { __builtin_memcpy(to, &v, sizeof v); }
#if defined(__SSE2__)
inline Four Least(Four a, Four b) { return _mm_min_ps(a, b); }
inline Four Largest(Four a, Four b) { return _mm_max_ps(a, b); }
#else
inline Four Least(Four a, Four b) { return a < b ? a : b; }
inline Four Largest(Four a, Four b) { return a > b ? a : b; }
#endif

#if defined(__AVX__)
/// a - b and a * factor of four doubles each, in double, then rounded.
inline Four RoundedDifference(const double* a, const double* b) {
  return _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(a), _mm256_loadu_pd(b)));
}
inline Four RoundedProduct(const double* a, double factor) {
  return _mm256_cvtpd_ps(_mm256_mul_pd(_mm256_loadu_pd(a), _mm256_set1_pd(factor)));
}
#elif defined(__SSE2__)
inline Four RoundedDifference(const double* a, const double* b) {
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(a), _mm_loadu_pd(b))),
                       _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(a + 2), _mm_loadu_pd(b + 2))));
}
inline Four RoundedProduct(const double* a, double factor) {
  const __m128d both = _mm_set1_pd(factor);
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_mul_pd(_mm_loadu_pd(a), both)),
                       _mm_cvtpd_ps(_mm_mul_pd(_mm_loadu_pd(a + 2), both)));
}
#else
inline Four RoundedDifference(const double* a, const double* b) {
  return {static_cast<float>(a[0] - b[0]), static_cast<float>(a[1] - b[1]),
          static_cast<float>(a[2] - b[2]), static_cast<float>(a[3] - b[3])};
}
inline Four RoundedProduct(const double* a, double factor) {
  return {static_cast<float>(a[0] * factor), static_cast<float>(a[1] * factor),
          static_cast<float>(a[2] * factor), static_cast<float>(a[3] * factor)};
}
#endif

/// Rows to columns.
inline void Transpose(const Four* rows, Four (&columns)[4]) {
  using Order [[gnu::vector_size(16)]] = int32_t;
  const Four xy_1 = __builtin_shuffle(rows[0], rows[1], Order{0, 4, 1, 5});
  const Four xy_2 = __builtin_shuffle(rows[2], rows[3], Order{0, 4, 1, 5});
  const Four zw_1 = __builtin_shuffle(rows[0], rows[1], Order{2, 6, 3, 7});
  const Four zw_2 = __builtin_shuffle(rows[2], rows[3], Order{2, 6, 3, 7});
  columns[0] = __builtin_shuffle(xy_1, xy_2, Order{0, 1, 4, 5});
  columns[1] = __builtin_shuffle(xy_1, xy_2, Order{2, 3, 6, 7});
  columns[2] = __builtin_shuffle(zw_1, zw_2, Order{0, 1, 4, 5});
  columns[3] = __builtin_shuffle(zw_1, zw_2, Order{2, 3, 6, 7});
}

inline float LeastOf(Four v) {
  using Order [[gnu::vector_size(16)]] = int32_t;
  v = Least(v, __builtin_shuffle(v, Order{2, 3, 0, 1}));
  return Least(v, __builtin_shuffle(v, Order{1, 0, 3, 2}))[0];
}
inline float LargestOf(Four v) { return -LeastOf(-v); }

/// Whether |v| <= limit everywhere; not if anything is NaN.
inline bool AllWithin(Four v, Four limit) {
#if defined(__SSE2__)
  return _mm_movemask_ps(_mm_and_ps(_mm_cmple_ps(v, limit), _mm_cmple_ps(-limit, v))) == 0xF;
#else
  bool all = true;
  for (int i = 0; i < 4; ++i) all = all && v[i] <= limit[i] && -limit[i] <= v[i];
  return all;
#endif
}

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
inline Points operator+(const Points& a, const Points& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
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
