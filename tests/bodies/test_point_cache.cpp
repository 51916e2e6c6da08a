// Point caches: files that hold the vertices of each frame.

#include <array>
#include <bit>
#include <cmath>
#include <thread>

#include "app/bodies/frame_source.hpp"
#include "app/models/reading/import_process.hpp"
#include "loading.hpp"
#include "sim/bytes.hpp"

namespace taut::app {
namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron = corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// Frames of the tetrahedron, which moves along x by `step_m` in each frame.
std::string pc2(std::size_t frames, double step_m) {
  std::string bytes = pc2_header({4, frames, 0});
  for (std::size_t k = 0; k < frames; ++k) {
    std::vector<sim::Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (sim::Vec3& position : positions) position.x += static_cast<double>(k) * step_m;
    bytes += pc2_frame(positions);
  }
  return bytes;
}

struct PointCaches : testing::Test {
  BodySource source_of(const std::string& name, const std::string& bytes) const {
    BodySource source;
    source.file = folder.write("body.obj", tetrahedron);
    source.motion = folder.write(name, bytes);
    return source;
  }
  test::TemporaryFolder folder;
};

TEST_F(PointCaches, AFrameInWhichAVertexJumpsIsNamed) {
  EXPECT_EQ(error_text(source_of("walk.PC2", pc2(3, 0.1))), "");
  EXPECT_CONTAINS(error_text(source_of("walk.pc2", pc2(3, 1.5))),
                  "walk.pc2': frame 1, vertex 0: found at [1.5, 0, 0] m, 1.5 m from where");
}

TEST_F(PointCaches, OneFrameIsSaid) {
  EXPECT_CONTAINS(load(source_of("walk.pc2", pc2(1, 0.1))).said(), "its motion has 1 frame, in which");
}

TEST_F(PointCaches, OtherEndingsAreRefused) {
  EXPECT_CONTAINS(error_text(source_of("walk.abc", "x")), "walk.abc': expected a motion that ends in .pc2 or .bvh");
}

TEST_F(PointCaches, AFileThatShrinksDuringTheRunIsNamed) {
  const BodySource source = source_of("walk.pc2", pc2(5, 0.1));
  const auto frames = open_pc2(source.motion);
  std::vector<sim::Vec3> positions(4);
  frames->read(4, positions);
  std::filesystem::resize_file(source.motion, 200);
  EXPECT_CONTAINS(test::error_message<InputError>([&] { frames->read(4, positions); }),
                  "walk.pc2': found 0 bytes from byte 224 on, expected 48; it was changed while it was read");
}

std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  file >> total >> resident;
  return resident * static_cast<std::size_t>(::getpagesize());
}

TEST_F(PointCaches, MemoryDoesNotGrowWithTheLengthOfAMotion) {
  constexpr std::size_t frames = 100'000;
  BodySource source = source_of("long.pc2", "");
  std::string header("POINTCACHE2\0", 12);
  for (const std::int32_t number : {1, 4, 0, std::bit_cast<std::int32_t>(1.0F), static_cast<std::int32_t>(frames)}) {
    const auto bytes = sim::little_endian(number);
    header.append(bytes.begin(), bytes.end());
  }
  std::ofstream(source.motion, std::ios::binary) << header;
  std::filesystem::resize_file(source.motion, header.size() + frames * 4 * 12);  // the added bytes are zeros
  const std::size_t before = resident_bytes();
  const auto cache = open_pc2(source.motion);
  std::vector<sim::Vec3> positions(4, sim::Vec3(1.0));
  for (std::size_t frame = 0; frame < cache->frames(); ++frame) {
    cache->read(frame, positions);
  }
  EXPECT_EQ(positions.back(), sim::Vec3(0.0));
  const auto placed = placed_frames(source.motion, open_pc2(source.motion), {{0, 1, 2, 3}, {}}, 60.0, 0);
  for (std::size_t frame = 0; frame < placed->count(); ++frame) {
    placed->positions_in(frame, positions);
  }
  // All frames together take at least 12 MB. Sanitizers keep memory that was freed.
  if (memory_is_limited) {
    EXPECT_LT(resident_bytes(), before + 2'000'000);
  }
}

TEST_F(PointCaches, SeveralThreadsMayAskAtOnce) {
  const LoadedBody body = load(source_of("walk.pc2", pc2(50, 0.5)));
  std::vector<std::jthread> threads;
  std::array<int, 4> wrong = {};
  for (int& count : wrong) {
    threads.emplace_back([&count, &body, first = &count - wrong.data()] {
      std::vector<sim::Vec3> positions(4);
      for (std::size_t k = 0; k < 500; ++k) {
        const std::size_t frame = (k + 13 * static_cast<std::size_t>(first)) % 50;
        body.mesh().frames->positions_in(frame, positions);
        count += positions[0] == sim::Vec3(0.5 * static_cast<double>(frame), 0, 0) ? 0 : 1;
      }
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

}  // namespace
}  // namespace taut::app
