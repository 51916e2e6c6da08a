#include "sim/solvers/bounded/kernels/kernels.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "sim/solvers/bounded/kernels/kernel_tables.hpp"

namespace taut::sim {

const char* to_name(VectorUnit unit) {
  constexpr std::array names = {"best", "scalar", "sse", "avx2", "avx512"};
  return names[static_cast<std::size_t>(unit)];
}

std::vector<VectorUnit> available_vector_units() {
  std::vector<VectorUnit> units = {VectorUnit::best, VectorUnit::scalar};
  for (const VectorUnit unit : {VectorUnit::sse, VectorUnit::avx2, VectorUnit::avx512}) {
    if (bounded::vector_kernels(unit) != nullptr) units.push_back(unit);
  }
  return units;
}

namespace bounded {

const Kernels& kernels_for(VectorUnit unit) {
  if (unit == VectorUnit::scalar) return emulated_kernels();
  const Kernels* kernels = vector_kernels(unit);
  if (kernels == nullptr && unit == VectorUnit::best) return emulated_kernels();
  if (kernels == nullptr) {
    throw std::invalid_argument(std::string("this processor has no ") + to_name(unit) +
                                "; the solver's vector unit must be best or one it has");
  }
  return *kernels;
}

}  // namespace bounded
}  // namespace taut::sim
