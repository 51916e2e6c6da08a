#include "sim/solvers/bounded/memory.hpp"

#include <limits>

namespace taut::sim::bounded {

void save(const Memory& memory, std::size_t vertex_count, ByteWriter& bytes) {
  bytes.put(memory.shift);
  memory.control.save(bytes);
  for (std::size_t row = 0; row < vertex_count; ++row) {
    const Float4& correction = memory.corrections[row];
    for (const float coordinate_m : {correction.x, correction.y, correction.z}) {
      bytes.put(coordinate_m);
    }
  }
  for (const Float4& drift : memory.elastic.drift_m_per_s) {
    for (const float coordinate : {drift.x, drift.y, drift.z}) {
      bytes.put(coordinate);
    }
  }
  for (const SurfaceSums& tension : memory.elastic.tension_n_per_m) {
    for (const auto* values : {&tension.along, &tension.across, &tension.mixed}) {
      for (const float value : *values) {
        bytes.put(value);
      }
    }
  }
  const RowMemory& rows = memory.contact.rows;
  bytes.put<std::uint8_t>(rows.is_empty() ? 0 : 1);
  if (!rows.is_empty()) {
    rows.save(vertex_count, bytes);
  }
}

void restore(std::size_t vertex_count, std::size_t row_count, ByteReader& bytes, Memory& memory) {
  memory.shift = bytes.get("the last frame's shift", 0.0, std::numeric_limits<double>::max());
  memory.control.restore(bytes);
  memory.corrections.assign(row_count, Float4{});
  for (std::size_t row = 0; row < vertex_count; ++row) {
    Float4& correction = memory.corrections[row];
    for (float* coordinate_m : {&correction.x, &correction.y, &correction.z}) {
      *coordinate_m = bytes.get<float>("the last frame's correction");
    }
  }
  for (Float4& drift : memory.elastic.drift_m_per_s) {
    for (float* coordinate : {&drift.x, &drift.y, &drift.z}) {
      *coordinate = bytes.get<float>("the drift of a vertex");
    }
  }
  for (SurfaceSums& tension : memory.elastic.tension_n_per_m) {
    for (auto* values : {&tension.along, &tension.across, &tension.mixed}) {
      for (float& value : *values) {
        value = bytes.get<float>("the tension of a triangle");
      }
    }
  }
  if (bytes.get_bool("whether anything could touch")) {
    memory.contact.rows.resize(row_count);
    memory.contact.rows.restore(vertex_count, bytes);
  }
}

}  // namespace taut::sim::bounded
