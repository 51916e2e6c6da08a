// compare_pictures EXPECTED.png ACTUAL.png DIFFERENCE.png
// Exit code 0: alike; 1: different, then DIFFERENCE.png shows expected, actual and the difference.

#include <cstdio>
#include <exception>
#include <filesystem>

#include "support/picture_difference.hpp"

using namespace taut;

namespace {

int compare_files(const char* expected_path, const char* actual_path, const char* difference_path) {
  const renderer::Image actual = renderer::read_png(actual_path);
  if (!std::filesystem::exists(expected_path)) {
    std::printf("There is no baseline %s.\nLook at the candidate and accept it: cp %s %s\n", expected_path,
                actual_path, expected_path);
    return 1;
  }
  const renderer::Image expected = renderer::read_png(expected_path);
  const tests::PictureLimit limit;
  const tests::PictureDifference difference = tests::compare(expected, actual, limit);
  if (tests::passes(difference, limit)) {
    return 0;
  }
  std::printf("%s", tests::describe(difference, limit).c_str());
  if (difference.same_size) {
    renderer::write_png(difference_path, tests::side_by_side(expected, actual));
    std::printf("expected, actual, difference x16: %s\n", difference_path);
  }
  std::printf("If the picture was meant to change, look at it and accept it: cp %s %s\n", actual_path,
              expected_path);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: compare_pictures EXPECTED.png ACTUAL.png DIFFERENCE.png\n");
    return 2;
  }
  try {
    return compare_files(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_pictures: %s\n", error.what());
    return 1;
  }
}
