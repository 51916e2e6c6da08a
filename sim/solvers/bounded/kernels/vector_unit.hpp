#pragma once

#include <array>
#include <vector>

namespace taut::sim {

/// Instructions of the vector kernels. All give the same bits.
enum class VectorUnit {
  best,    ///< widest unit of the processor
  scalar,  ///< ordinary instructions, which every processor has; 4 springs at once
  sse,     ///< SSSE3 or SSE4; 4 springs at once
  avx2,    ///< 8 springs at once
  avx512,  ///< 16 springs at once
};

inline constexpr std::array all_vector_units = {VectorUnit::best, VectorUnit::scalar, VectorUnit::sse, VectorUnit::avx2,
                                                VectorUnit::avx512};

/// Returns the name in files and messages.
const char* to_name(VectorUnit unit);

/// Returns the units of this processor; `best` and `scalar` are always among them.
std::vector<VectorUnit> available_vector_units();

}  // namespace taut::sim
