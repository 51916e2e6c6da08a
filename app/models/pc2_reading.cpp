#include "app/models/pc2_reading.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "sim/bytes.hpp"

namespace taut::app {
namespace {

constexpr std::string_view signature{"POINTCACHE2", 12};  // with the zero at its end
constexpr std::size_t header_bytes = 32;
constexpr std::size_t position_bytes = 12;

std::vector<sim::Vec3> read_frame(std::size_t frame, std::size_t vertices, sim::ByteReader& in) {
  std::vector<sim::Vec3> positions(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    try {
      for (int axis = 0; axis < 3; ++axis) {
        positions[v][axis] = static_cast<double>(in.get<float>("a coordinate"));
      }
    } catch (const sim::BadBytes& error) {
      throw sim::BadBytes(fmt::format("frame {}, vertex {}: {}", frame, v, error.what()));
    }
  }
  return positions;
}

}  // namespace

std::vector<std::vector<sim::Vec3>> read_pc2(const std::filesystem::path& file) {
  const std::string bytes = read_text_file(file);
  try {
    sim::ByteReader in(bytes);
    in.require_text("what the file is", signature);
    in.get<std::int32_t>("the version", 1, 1);
    const auto vertices = static_cast<std::size_t>(in.get<std::int32_t>("the number of vertices", 1));
    in.get<float>("the first frame");
    in.get<float>("the rate");
    const auto frames = static_cast<std::size_t>(in.get<std::int32_t>("the number of frames", 1));
    const std::size_t expected = header_bytes + frames * vertices * position_bytes;
    if (bytes.size() != expected) {
      throw sim::BadBytes(fmt::format("found {} bytes, expected {} for {} frames of {} vertices",
                                      bytes.size(), expected, frames, vertices));
    }
    std::vector<std::vector<sim::Vec3>> positions;
    for (std::size_t frame = 0; frame < frames; ++frame) {
      positions.push_back(read_frame(frame, vertices, in));
    }
    return positions;
  } catch (const sim::BadBytes& error) {
    throw InputError("cannot read frames from '" + file.string() + "': " + error.what());
  }
}

}  // namespace taut::app
