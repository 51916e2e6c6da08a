// The kernels compiled again, with vectors of four floats made of ordinary instructions, for processors without
// vectors.
#define HWY_COMPILE_ONLY_EMU128
// Highway disables its emulation for GCC before 12.3, which miscompiles products of integers. The kernels
// have none, and a test compares all results with loops over single numbers.
#define HWY_BROKEN_EMU128 0
#include "kernels_vector.cpp"
