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

constexpr Target targets[] = {{"arrays", taut::test::fuzz_arrays},
                              {"bvh", taut::test::fuzz_bvh},
                              {"checkpoint", taut::test::fuzz_checkpoint},
                              {"fabric", taut::test::fuzz_fabric},
                              {"library", taut::test::fuzz_library},
                              {"mesh", taut::test::fuzz_mesh},
                              {"obj", taut::test::fuzz_obj},
                              {"pattern", taut::test::fuzz_pattern},
                              {"pc2", taut::test::fuzz_pc2},
                              {"picture", taut::test::fuzz_picture},
                              {"scene", taut::test::fuzz_scene},
                              {"session", taut::test::fuzz_session}};

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
