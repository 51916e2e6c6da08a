#pragma once

namespace taut::app {

struct SpringKernel {
  int springs_per_repeat;
  // Both return a number that depends on every correction.
  double (*run)(int repeats);
  double (*run_without_root)(int repeats);
};

// Named by the springs corrected at once: one in double precision, several in single precision. Those of 8
// and 16 exist on x86 alone and need AVX2 and AVX-512.
SpringKernel spring_kernel_1();
SpringKernel spring_kernel_4();
SpringKernel spring_kernel_8();
SpringKernel spring_kernel_16();

}  // namespace taut::app
