#include "sim/solvers/bounded/kernels/kernels.hpp"

#include <stdexcept>
#include <string>

#include "sim/solvers/bounded/kernels/kernel_tables.hpp"

namespace taut::sim {

const char* name_of(VectorUnit unit) {
  switch (unit) {
    case VectorUnit::best:
      return "best";
    case VectorUnit::scalar:
      return "scalar";
    case VectorUnit::sse:
      return "sse";
    case VectorUnit::avx2:
      return "avx2";
    case VectorUnit::avx512:
      return "avx512";
  }
  return "";
}

std::vector<VectorUnit> available_vector_units() {
  std::vector<VectorUnit> units = {VectorUnit::best, VectorUnit::scalar};
  for (const VectorUnit unit : {VectorUnit::sse, VectorUnit::avx2, VectorUnit::avx512}) {
    if (bounded::vector_kernels(unit) != nullptr) {
      units.push_back(unit);
    }
  }
  return units;
}

namespace bounded {

const Kernels& kernels_for(VectorUnit unit) {
  if (unit == VectorUnit::scalar) {
    return emulated_kernels();
  }
  const Kernels* kernels = vector_kernels(unit);
  if (kernels == nullptr && unit == VectorUnit::best) {
    return emulated_kernels();
  }
  if (kernels == nullptr) {
    throw std::invalid_argument(std::string("this processor has no ") + name_of(unit) +
                                "; the solver's vector unit must be best or one it has");
  }
  return *kernels;
}

}  // namespace bounded
}  // namespace taut::sim
