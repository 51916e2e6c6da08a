// The kernels once more, with vectors of four floats made of ordinary instructions: for processors without
// any.
#define HWY_COMPILE_ONLY_EMU128
// Highway does without its emulation where the compiler is GCC before 12.3, which gets products of whole
// numbers wrong. There are none in the kernels, and a test holds all they give against loops over single
// numbers.
#define HWY_BROKEN_EMU128 0
#include "kernels_vector.cpp"
