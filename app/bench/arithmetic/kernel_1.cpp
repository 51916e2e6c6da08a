#define TAUT_LANES 1
#include "app/bench/arithmetic/kernels.hpp"
#include "app/bench/arithmetic/spring_kernel.hpp"

namespace taut::app {

SpringKernel spring_kernel_1() {
  return {springs_per_repeat, project_repeatedly<true>, project_repeatedly<false>};
}

}  // namespace taut::app
