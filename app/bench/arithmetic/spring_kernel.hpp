#pragma once

// Included by one source file for each kind of vector unit, each compiled for that unit alone. Everything
// here has to stay within that file: a function shared with the rest of the program could end up in it
// compiled for instructions the processor lacks. So: an unnamed namespace, and no standard headers.

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace taut::app {
namespace {

#if defined(TAUT_LANES) && TAUT_LANES > 1
using Pack = float __attribute__((vector_size(4 * TAUT_LANES)));
constexpr int lanes = TAUT_LANES;
#else
using Pack = double;
constexpr int lanes = 1;
#endif

inline Pack root_of(Pack x) {
#if !defined(TAUT_LANES) || TAUT_LANES == 1
  return __builtin_sqrt(x);
#elif TAUT_LANES == 16 && defined(__AVX512F__)
  return reinterpret_cast<Pack>(_mm512_sqrt_ps(reinterpret_cast<__m512>(x)));
#elif TAUT_LANES == 8 && defined(__AVX__)
  return reinterpret_cast<Pack>(_mm256_sqrt_ps(reinterpret_cast<__m256>(x)));
#elif TAUT_LANES == 4 && defined(__SSE2__)
  return reinterpret_cast<Pack>(_mm_sqrt_ps(reinterpret_cast<__m128>(x)));
#else
  for (int lane = 0; lane < lanes; ++lane) {
    x[lane] = __builtin_sqrtf(x[lane]);
  }
  return x;
#endif
}

struct SpringPack {
  Pack i[3];
  Pack j[3];
  Pack rest_m;
  Pack share_i;
  Pack share_j;
};

// The error over the length: as eq. (3) has it, or to the second order without a root (Jakobsen 2001), as
// `bounded` and Bullet do.
template <bool has_root>
inline Pack relative_error(Pack squared_m2, Pack rest_m) {
  if constexpr (has_root) {
    const Pack length_m = root_of(squared_m2);
    return (length_m - rest_m) / length_m;
  } else {
    return (squared_m2 - rest_m) / (squared_m2 + rest_m);
  }
}

// One correction of the strong constraint; the ends' shares are known beforehand.
template <bool has_root>
inline void project(SpringPack& s) {
  const Pack x = s.i[0] - s.j[0], y = s.i[1] - s.j[1], z = s.i[2] - s.j[2];
  const Pack scale = relative_error<has_root>(x * x + y * y + z * z, s.rest_m);
  const Pack on_i = s.share_i * scale, on_j = s.share_j * scale;
  s.i[0] -= on_i * x;
  s.i[1] -= on_i * y;
  s.i[2] -= on_i * z;
  s.j[0] += on_j * x;
  s.j[1] += on_j * y;
  s.j[2] += on_j * z;
}

// A correction takes some fifty cycles from its first operation to its last, a vector unit begins the next
// after about ten: with six none waits for another. With more the compiled loop waits for what it has just
// stored.
constexpr int packs = 6;

template <bool has_root>
double project_repeatedly(int repeats) {
  SpringPack springs[packs];
  for (int p = 0; p < packs; ++p) {
    const Pack one = Pack{} + 1;
    for (int axis = 0; axis < 3; ++axis) {
      springs[p].i[axis] = one * static_cast<float>(axis + p);
      springs[p].j[axis] = one * static_cast<float>(axis * p + 5);
    }
    springs[p].rest_m = one;
    springs[p].share_i = springs[p].share_j = one / 2;
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (int p = 0; p < packs; ++p) {
      project<has_root>(springs[p]);
    }
  }
  Pack sum = {};
  for (int p = 0; p < packs; ++p) {
    sum += springs[p].i[0];
  }
#if defined(TAUT_LANES) && TAUT_LANES > 1
  return static_cast<double>(sum[0]);
#else
  return sum;
#endif
}

constexpr int springs_per_repeat = packs * lanes;

}  // namespace
}  // namespace taut::app
