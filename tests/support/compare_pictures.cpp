// compare_pictures EXPECTED.png ACTUAL.png FOLDER [CHANNEL FRACTION MEAN]
//     Compares two pictures by the limits of PictureLimit, or by the given ones. If they differ, prints the
//     differences and writes FOLDER/difference.png and FOLDER/side_by_side.png. Exit code 0: equal; 1: different;
//     2: error.
// compare_pictures propose PICTURE.png PICTURE.png...
//     Proposes limits for pictures that should be alike, such as those of other processors: twice what the first one and
//     the others differ by.
// compare_pictures repack FROM.png TO.png
//     Writes the same pixels in the fewest bytes and without texts, for a baseline.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "renderer/page/png.hpp"
#include "support/picture_difference.hpp"
#include "support/picture_reading.hpp"

using namespace taut;

namespace {

tests::PictureLimit parse_limit(int argc, char** argv) {
  tests::PictureLimit limit;
  if (argc == 7) {
    limit = {std::stoi(argv[4]), std::stod(argv[5]), std::stod(argv[6])};
  }
  return limit;
}

void write(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    throw std::runtime_error("cannot write '" + path.string() + "'");
  }
}

int compare_files(const std::string& expected_path, const std::string& actual_path,
                  const std::filesystem::path& folder, const tests::PictureLimit& limit) {
  const renderer::Image actual = tests::read_png(actual_path);
  const renderer::Image expected = tests::read_png(expected_path);
  const tests::PictureDifference difference = tests::compare(expected, actual, limit);
  if (tests::passes(difference, limit)) {
    return 0;
  }
  std::printf("%s", tests::describe(difference, limit).c_str());
  if (difference.same_size) {
    write(folder / "difference.png", renderer::encode_png(tests::amplified_difference(expected, actual)));
    write(folder / "side_by_side.png", renderer::encode_png(tests::side_by_side(expected, actual)));
  }
  return 1;
}

int propose(const std::vector<std::string>& files) {
  const renderer::Image first = tests::read_png(files[0]);
  std::vector<renderer::Image> others;
  for (std::size_t k = 1; k < files.size(); ++k) others.push_back(tests::read_png(files[k]));
  const tests::PictureLimit limit = tests::propose_limit(first, others);
  std::printf("LIMIT %d %.3g %.3g\n", limit.channel_difference, limit.differing_fraction, limit.mean_difference);
  return 0;
}

int repack(const char* from, const char* to) {
  write(to, renderer::encode_png(tests::read_png(from)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc >= 4 && std::string(argv[1]) == "propose") {
      return propose({argv + 2, argv + argc});
    }
    if (argc == 4 && std::string(argv[1]) == "repack") {
      return repack(argv[2], argv[3]);
    }
    if (argc == 4 || argc == 7) {
      return compare_files(argv[1], argv[2], argv[3], parse_limit(argc, argv));
    }
    std::fprintf(stderr,
                 "usage: compare_pictures EXPECTED.png ACTUAL.png FOLDER [CHANNEL FRACTION MEAN]\n"
                 "       compare_pictures propose PICTURE.png PICTURE.png...\n"
                 "       compare_pictures repack FROM.png TO.png\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_pictures: %s\n", error.what());
  }
  return 2;
}
