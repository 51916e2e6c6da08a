// All targets of libFuzzer in one program, as each of their own would be linked with all of Taut. The first argument
// names the target; the others are libFuzzer's.
#include "fuzz.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

struct Target {
  std::string_view name;
  void (*run)(const std::uint8_t* data, std::size_t size);
};

#define TAUT_NAME(name) Target{#name, taut::test::fuzz_##name},
constexpr Target targets[] = {TAUT_EACH_TARGET(TAUT_NAME)};
#undef TAUT_NAME

// libFuzzer calls its entries without an argument for what is theirs.
const Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  for (const Target& target : targets) {
    if (*count > 1 && target.name == (*arguments)[1]) chosen = &target;
  }
  if (chosen == nullptr) {
    std::fprintf(stderr, "fuzz: expected the name of a target first, one of:");
    for (const Target& target : targets) std::fprintf(stderr, " %s", target.name.data());
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  (*arguments)[1] = (*arguments)[0];
  ++*arguments;
  --*count;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run(data, size);
  return 0;
}
