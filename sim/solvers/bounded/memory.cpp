#include "sim/solvers/bounded/memory.hpp"

namespace taut::sim::bounded {

namespace {

void save(const Float4Array& rows, std::size_t vertex_count, ByteWriter& bytes) {
  for (std::size_t row = 0; row < vertex_count; ++row) {
    for (const float coordinate : {rows[row].x, rows[row].y, rows[row].z}) bytes.put(coordinate);
  }
}

Float4Array restored_rows(std::size_t vertex_count, std::size_t row_count, const char* what, ByteReader& bytes) {
  Float4Array rows(row_count);
  for (std::size_t row = 0; row < vertex_count; ++row) {
    for (float* coordinate : {&rows[row].x, &rows[row].y, &rows[row].z}) *coordinate = bytes.get<float>(what);
  }
  return rows;
}

void save(const ContactMemory& memory, ByteWriter& bytes) {
  bytes.put<std::uint8_t>(memory.may_have_crossed ? 1 : 0);
  bytes.put<std::uint8_t>(memory.bodies ? 1 : 0);
  bytes.put<std::uint64_t>(memory.left_out.size());
  for (const LeftOutTriangle& t : memory.left_out) {
    bytes.put<std::uint64_t>(t.body ? *t.body + 1 : 0);
    bytes.put(t.triangle);
    bytes.put(t.group);
  }
}

void restore(const Frame& frame, ByteReader& bytes, ContactMemory& memory) {
  const std::vector<Body>& bodies = frame.surroundings.bodies;
  memory.may_have_crossed = bytes.get_bool("whether a crossing was accepted");
  if (bytes.get_bool("whether it is known what crosses")) memory.bodies = bodies;
  const auto count = bytes.get<std::uint64_t>("the number of triangles that are left out");
  memory.left_out.clear();
  for (std::uint64_t k = 0; k < count; ++k) {
    LeftOutTriangle t;
    if (const auto body = bytes.get<std::uint64_t>("a body of a triangle that is left out", 0, bodies.size());
        body > 0) {
      t.body = body - 1;
    }
    t.triangle = bytes.get<Index>("a triangle that is left out");
    t.group = bytes.get<Index>("the group of a triangle that is left out", 1);
    memory.left_out.push_back(t);
  }
}

void save(const ElasticMemory& memory, ByteWriter& bytes) {
  bytes.put<std::uint64_t>(memory.tension_n_per_m.size());
  for (const auto* blocks : {&memory.tension_n_per_m, &memory.held_n_per_m}) {
    for (const SurfaceSums& block : *blocks) {
      for (const auto* values : {&block.along, &block.across, &block.mixed}) {
        for (const float value : *values) bytes.put(value);
      }
    }
  }
}

// Cloth that had another law, or none, when it was saved begins without tension.
void restore(const Frame& frame, ByteReader& bytes, ElasticMemory& memory) {
  ElasticMemory saved;
  const auto count =
      bytes.get<std::uint64_t>("the number of blocks under tension", 0, frame.garment.mesh.triangles.size());
  for (auto* blocks : {&saved.tension_n_per_m, &saved.held_n_per_m}) {
    blocks->resize(count);
    for (SurfaceSums& block : *blocks) {
      for (auto* values : {&block.along, &block.across, &block.mixed}) {
        for (float& value : *values) value = bytes.get<float>("the tension of a triangle");
      }
    }
  }
  if (count == memory.tension_n_per_m.size()) memory = std::move(saved);
}

}  // namespace

void save(const Memory& memory, std::size_t vertex_count, ByteWriter& bytes) {
  bytes.put(memory.shift);
  bytes.put(memory.median_work);
  memory.control.save(bytes);
  save(memory.corrections, vertex_count, bytes);
  bytes.put<std::uint8_t>(memory.blown_m_per_s.empty() ? 0 : 1);
  if (!memory.blown_m_per_s.empty()) save(memory.blown_m_per_s, vertex_count, bytes);
  save(memory.elastic, bytes);
  const RowMemory& rows = memory.contact.rows;
  bytes.put<std::uint8_t>(rows.is_empty() ? 0 : 1);
  if (!rows.is_empty()) rows.save(vertex_count, bytes);
  save(memory.contact, bytes);
}

void restore(const Frame& frame, std::size_t row_count, ByteReader& bytes, Memory& memory) {
  const std::size_t vertex_count = frame.garment.mesh.positions.size();
  memory.shift = bytes.get("the last frame's shift", 0.0, std::numeric_limits<double>::max());
  memory.median_work = bytes.get("the work of a frame", 0.0, std::numeric_limits<double>::max());
  memory.control.restore(bytes);
  memory.corrections = restored_rows(vertex_count, row_count, "the last frame's correction", bytes);
  memory.blown_m_per_s.clear();
  if (bytes.get_bool("whether the wind was updated")) {
    memory.blown_m_per_s = restored_rows(vertex_count, row_count, "what the wind brings about", bytes);
  }
  restore(frame, bytes, memory.elastic);
  if (bytes.get_bool("whether anything could touch")) {
    memory.contact.rows.resize(row_count);
    memory.contact.rows.restore(vertex_count, bytes);
  }
  restore(frame, bytes, memory.contact);
}

}  // namespace taut::sim::bounded
