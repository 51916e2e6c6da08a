#pragma once

#include <array>
#include <vector>

namespace taut::sim {

/// The instructions the vector loops are made of. All give the same bits.
enum class VectorUnit {
  best,    ///< the widest the processor has
  scalar,  ///< none: 4 springs by ordinary instructions, which every processor has
  sse,     ///< 4 springs (SSSE3 or SSE4)
  avx2,    ///< 8
  avx512,  ///< 16
};

inline constexpr std::array all_vector_units = {VectorUnit::best, VectorUnit::scalar, VectorUnit::sse,
                                                VectorUnit::avx2, VectorUnit::avx512};

const char* name_of(VectorUnit unit);

/// Those this processor has, `best` and `scalar` among them.
std::vector<VectorUnit> available_vector_units();

}  // namespace taut::sim
