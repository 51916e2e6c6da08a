#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "taut.h"

namespace taut::test {

template <class T, class Init> T make_struct(const Init& init) {
  T value;
  init(&value, sizeof(value));
  return value;
}

/// A level square of quads with its sides along x and z, and the options to make it a cloth.
struct Square {
  explicit Square(std::uint32_t a_side = 9, double size_m = 0.4, double height_m = 0.0) : side(a_side) {
    for (std::uint32_t v = 0; v < side * side; ++v) {
      const double step_m = size_m / (side - 1);
      positions.push_back({step_m * (v % side) - 0.5 * size_m, height_m, step_m * (v / side) - 0.5 * size_m});
    }
    for (std::uint32_t row = 0; row + 1 < side; ++row) {
      for (std::uint32_t column = 0; column + 1 < side; ++column) {
        const std::uint32_t v = row * side + column;
        corners.insert(corners.end(), {v, v + side, v + side + 1, v + 1});
      }
    }
    sizes.assign(corners.size() / 4, 4);
    mesh = make_struct<TautMesh>(taut_mesh_init);
    mesh.positions = points();
    mesh.corners = corners.data();
    mesh.corner_count = corners.size();
    mesh.corners_per_face = sizes.data();
    mesh.face_count = sizes.size();
    options = make_struct<TautOptions>(taut_options_init);
    options.mesh = &mesh;
  }
  Square(const Square&) = delete;

  TautPoints points() const {
    return {positions.data(), positions.size(), sizeof(positions[0]), TAUT_DOUBLE};
  }

  std::uint32_t side;
  std::vector<std::array<double, 3>> positions;
  std::vector<std::uint32_t> corners, sizes;
  TautMesh mesh;
  TautOptions options;
};

/// A closed box.
struct Box {
  explicit Box(double height_m) {
    for (int v = 0; v < 8; ++v) {
      positions.push_back({v & 1 ? 0.1 : -0.1, height_m + (v & 2 ? 0.1 : -0.1), v & 4 ? 0.1 : -0.1});
    }
    mesh = make_struct<TautMesh>(taut_mesh_init);
    mesh.positions = {positions.data(), 8, sizeof(positions[0]), TAUT_DOUBLE};
    mesh.corners = corners;
    mesh.corner_count = 24;
    mesh.corners_per_face = sizes;
    mesh.face_count = 6;
    body = make_struct<TautBody>(taut_body_init);
    body.mesh = &mesh;
    body.name = "box";
  }
  Box(const Box&) = delete;

  void lift(double by_m) {
    for (auto& position : positions) {
      position[1] += by_m;
    }
  }

  std::vector<std::array<double, 3>> positions;
  const std::uint32_t corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  const std::uint32_t sizes[6] = {4, 4, 4, 4, 4, 4};
  TautMesh mesh;
  TautBody body;
};

/// A cloth that is destroyed with this object.
struct OwnCloth {
  explicit OwnCloth(const TautOptions& options) {
    auto error = make_struct<TautError>(taut_error_init);
    result = taut_create(&options, &cloth, &error);
    text = error.text;
  }
  explicit OwnCloth(const char* scene, std::int32_t threads = 0) : OwnCloth(options_of(scene, threads)) {}
  ~OwnCloth() { taut_destroy(cloth); }
  OwnCloth(const OwnCloth&) = delete;
  operator TautCloth() const { return cloth; }

  static TautOptions options_of(const char* scene, std::int32_t threads = 0) {
    auto options = make_struct<TautOptions>(taut_options_init);
    options.scene = scene;
    options.threads = threads;
    return options;
  }

  TautFrame step(int frames = 1) {
    auto frame = make_struct<TautFrame>(taut_frame_init);
    for (int k = 0; k < frames && result == TAUT_OK; ++k) {
      result = taut_step(cloth, &frame);
    }
    return frame;
  }
  std::uint64_t hash() const {
    std::uint64_t value = 0;
    taut_state_hash(cloth, &value);
    return value;
  }
  TautInfo info() const {
    auto value = make_struct<TautInfo>(taut_info_init);
    taut_get_info(cloth, &value);
    return value;
  }
  std::vector<std::array<double, 3>> positions() const {
    std::vector<std::array<double, 3>> values(info().vertex_count);
    const TautPointsOut out = {values.data(), values.size(), sizeof(values[0]), TAUT_DOUBLE};
    taut_get_positions(cloth, &out);
    return values;
  }
  std::string error() const { return taut_last_error(cloth); }

  TautCloth cloth = {};
  TautResult result = TAUT_OK;
  std::string text;  ///< reason why it was not made
};

}  // namespace taut::test
