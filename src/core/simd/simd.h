// One number for each of several vertices at once, in one register: the thin layer over vector
// instructions. Everything here is per lane and exact by IEEE 754 (no sum across lanes, no fused
// multiply-add), so that any number of lanes gives the same bits.
//
// A source file that is compiled for one set of instructions defines, before including this,
//   PLANISH_LANES  lanes in a register: 2 (any processor), 4 (AVX2), 8 (AVX-512)
//   PLANISH_ISA    namespace of all that is compiled for them. Nothing inline from other namespaces
//                  may be called there: the linker could keep this file's copy of it for all.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if !defined(PLANISH_LANES) || !defined(PLANISH_ISA)
#error "define PLANISH_LANES and PLANISH_ISA first"
#endif

namespace planish::PLANISH_ISA {

constexpr int k_lanes = PLANISH_LANES;

using Real = double __attribute__((vector_size(8 * PLANISH_LANES)));
using Bits = std::int64_t __attribute__((vector_size(8 * PLANISH_LANES)));
/// All bits of a lane set or none.
using Mask = decltype(Real{} < Real{});

inline Real broadcast(double x) {
  return Real{} + x;
}

inline Real select(Mask mask, Real yes, Real no) {
  return mask ? yes : no;
}

inline Real absolute(Real x) {
  return (Real)((Bits)x & (Bits{} + INT64_MAX));
}

/// Of -0 too.
inline Mask is_negative(Real x) {
  return (Bits)x < 0;
}

inline Real min(Real a, Real b) {
  return select(a < b, a, b);
}

inline Real max(Real a, Real b) {
  return select(a > b, a, b);
}

inline Real square_root(Real x) {
#if defined(__AVX512DQ__) && PLANISH_LANES == 8
  return (Real)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif defined(__AVX__) && PLANISH_LANES == 4
  return (Real)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__) && PLANISH_LANES == 2
  return (Real)_mm_sqrt_pd((__m128d)x);
#else
  Real root{};
  for (int lane = 0; lane < k_lanes; ++lane)
    root[lane] = __builtin_sqrt(x[lane]);
  return root;
#endif
}

inline bool any(Mask mask) {
#if defined(__AVX512DQ__) && PLANISH_LANES == 8
  return _mm512_movepi64_mask((__m512i)mask) != 0;
#elif defined(__AVX__) && PLANISH_LANES == 4
  return _mm256_movemask_pd((__m256d)mask) != 0;
#elif defined(__SSE2__) && PLANISH_LANES == 2
  return _mm_movemask_pd((__m128d)mask) != 0;
#else
  std::int64_t bits = 0;
  for (int lane = 0; lane < k_lanes; ++lane)
    bits |= mask[lane];
  return bits != 0;
#endif
}

/// A power of two by which x has an exponent near 0; finite for every x.
inline Real exponent_off(Real x) {
  constexpr std::int64_t exponent = 0x7fe0000000000000;
  return (Real)((Bits{} + exponent) - ((Bits)x & (Bits{} + exponent)));
}

struct Vector {
  Real x, y, z;
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Real& s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Real dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector select(Mask mask, const Vector& yes, const Vector& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// Four neighbouring doubles for each lane, 32 bytes aligned, taken apart by column.
struct Columns {
  Real c0, c1, c2, c3;
};

inline Columns load_columns(const double* const* rows) {
#if defined(__AVX512DQ__) && PLANISH_LANES == 8
  const auto pair = [rows](int lane) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(rows[lane])),
                              _mm256_load_pd(rows[lane + 4]), 1);
  };
  const __m512d a = pair(0), b = pair(1), c = pair(2), d = pair(3);
  const __m512d low = _mm512_unpacklo_pd(a, b), low_next = _mm512_unpacklo_pd(c, d);
  const __m512d high = _mm512_unpackhi_pd(a, b), high_next = _mm512_unpackhi_pd(c, d);
  const __m512i first = _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0);
  const __m512i second = _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2);
  return {(Real)_mm512_permutex2var_pd(low, first, low_next),
          (Real)_mm512_permutex2var_pd(high, first, high_next),
          (Real)_mm512_permutex2var_pd(low, second, low_next),
          (Real)_mm512_permutex2var_pd(high, second, high_next)};
#elif defined(__AVX__) && PLANISH_LANES == 4
  const __m256d a = _mm256_load_pd(rows[0]), b = _mm256_load_pd(rows[1]);
  const __m256d c = _mm256_load_pd(rows[2]), d = _mm256_load_pd(rows[3]);
  const __m256d low = _mm256_unpacklo_pd(a, b), low_next = _mm256_unpacklo_pd(c, d);
  const __m256d high = _mm256_unpackhi_pd(a, b), high_next = _mm256_unpackhi_pd(c, d);
  return {(Real)_mm256_permute2f128_pd(low, low_next, 0x20),
          (Real)_mm256_permute2f128_pd(high, high_next, 0x20),
          (Real)_mm256_permute2f128_pd(low, low_next, 0x31),
          (Real)_mm256_permute2f128_pd(high, high_next, 0x31)};
#else
  Columns columns{};
  for (int lane = 0; lane < k_lanes; ++lane) {
    columns.c0[lane] = rows[lane][0], columns.c1[lane] = rows[lane][1];
    columns.c2[lane] = rows[lane][2], columns.c3[lane] = rows[lane][3];
  }
  return columns;
#endif
}

/// The first three doubles of each row alone: the fourth, which another thread may be writing, is
/// not touched.
inline Vector load_vectors(const double* const* rows) {
  Vector vectors{};
#if defined(__AVX512DQ__) && PLANISH_LANES == 8
  const auto pair = [rows](int lane) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_maskz_load_pd(7, rows[lane])),
                              _mm256_maskz_load_pd(7, rows[lane + 4]), 1);
  };
  const __m512d a = pair(0), b = pair(1), c = pair(2), d = pair(3);
  const __m512d low = _mm512_unpacklo_pd(a, b), low_next = _mm512_unpacklo_pd(c, d);
  const __m512d high = _mm512_unpackhi_pd(a, b), high_next = _mm512_unpackhi_pd(c, d);
  const __m512i first = _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0);
  const __m512i second = _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2);
  vectors.x = (Real)_mm512_permutex2var_pd(low, first, low_next);
  vectors.y = (Real)_mm512_permutex2var_pd(high, first, high_next);
  vectors.z = (Real)_mm512_permutex2var_pd(low, second, low_next);
#elif defined(__AVX__) && PLANISH_LANES == 4
  const __m256i three = _mm256_set_epi64x(0, -1, -1, -1);
  const __m256d a = _mm256_maskload_pd(rows[0], three), b = _mm256_maskload_pd(rows[1], three);
  const __m256d c = _mm256_maskload_pd(rows[2], three), d = _mm256_maskload_pd(rows[3], three);
  const __m256d low = _mm256_unpacklo_pd(a, b), low_next = _mm256_unpacklo_pd(c, d);
  const __m256d high = _mm256_unpackhi_pd(a, b), high_next = _mm256_unpackhi_pd(c, d);
  vectors.x = (Real)_mm256_permute2f128_pd(low, low_next, 0x20);
  vectors.y = (Real)_mm256_permute2f128_pd(high, high_next, 0x20);
  vectors.z = (Real)_mm256_permute2f128_pd(low, low_next, 0x31);
#else
  for (int lane = 0; lane < k_lanes; ++lane) {
    vectors.x[lane] = rows[lane][0], vectors.y[lane] = rows[lane][1];
    vectors.z[lane] = rows[lane][2];
  }
#endif
  return vectors;
}

}  // namespace planish::PLANISH_ISA
