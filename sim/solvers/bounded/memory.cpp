#include "sim/solvers/bounded/memory.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

void save(const Float4Array& rows, std::size_t vertex_count, ByteWriter& bytes) {
  for (std::size_t row = 0; row < vertex_count; ++row) {
    for (const float coordinate : {rows[row].x, rows[row].y, rows[row].z}) bytes.put(coordinate);
  }
}

Float4Array restored_rows(std::size_t vertex_count, std::size_t row_count, const char* what, ByteReader& bytes) {
  assert(vertex_count <= row_count);
  Float4Array rows(row_count);
  for (std::size_t row = 0; row < vertex_count; ++row) {
    for (float* coordinate : {&rows[row].x, &rows[row].y, &rows[row].z}) *coordinate = bytes.get<float>(what);
  }
  return rows;
}

void save(const ContactMemory& memory, ByteWriter& bytes) {
  bytes.put<std::uint8_t>(memory.may_have_crossed ? 1 : 0);
  bytes.put<std::uint8_t>(memory.bodies ? 1 : 0);
  bytes.put<std::uint64_t>(memory.excluded_triangles.size());
  for (const ExcludedTriangle& t : memory.excluded_triangles) {
    bytes.put<std::uint64_t>(t.body ? *t.body + 1 : 0);
    bytes.put(t.triangle);
    bytes.put(t.group);
  }
}

/// Returns the numbers of triangles of the cloth and of each body; 0 for bodies that are no meshes.
std::vector<std::size_t> triangle_counts(const Frame& frame) {
  std::vector<std::size_t> counts = {frame.garment.mesh.triangles.size()};
  for (const Body& body : frame.surroundings.bodies) {
    const auto* mesh = std::get_if<BodyMesh>(&body.shape);
    counts.push_back(mesh != nullptr ? mesh->data->triangles.size() : 0);
  }
  return counts;
}

void restore(const Frame& frame, ByteReader& bytes, ContactMemory& memory) {
  const std::vector<Body>& bodies = frame.surroundings.bodies;
  const std::vector<std::size_t> counts = triangle_counts(frame);
  const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  memory.may_have_crossed = bytes.get_bool("whether a crossing was accepted");
  if (bytes.get_bool("whether it is known what crosses")) memory.bodies = bodies;
  const auto count = bytes.get<std::uint64_t>("the number of triangles that are left out", 0, all);
  memory.excluded_triangles.clear();
  for (std::uint64_t k = 0; k < count; ++k) {
    ExcludedTriangle t;
    const auto body = bytes.get<std::uint64_t>("a body of a triangle that is left out", 0, bodies.size());
    if (body > 0) t.body = body - 1;
    const std::size_t last = std::max<std::size_t>(counts[body], 1) - 1;
    t.triangle = bytes.get<Index>("a triangle that is left out", 0, static_cast<Index>(last));
    t.group = bytes.get<Index>("the group of a triangle that is left out", 1, static_cast<Index>(all));
    memory.excluded_triangles.push_back(t);
  }
}

void save(const ElasticMemory& memory, ByteWriter& bytes) {
  bytes.put<std::uint64_t>(memory.tension_n_per_m.size());
  for (const auto* blocks : {&memory.tension_n_per_m, &memory.shortening_n_per_m}) {
    for (const SurfaceSums& block : *blocks) {
      for (const auto* values : {&block.along, &block.across, &block.mixed}) {
        for (const float value : *values) bytes.put(value);
      }
    }
  }
}

// Cloth saved with another law, or none, begins without tension.
void restore(const Frame& frame, ByteReader& bytes, ElasticMemory& memory) {
  ElasticMemory saved;
  const auto count =
      bytes.get<std::uint64_t>("the number of blocks under tension", 0, frame.garment.mesh.triangles.size());
  for (auto* blocks : {&saved.tension_n_per_m, &saved.shortening_n_per_m}) {
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

void RowMemory::resize(std::size_t rows) {
  velocities.resize(rows);
  accelerations.resize(rows);
  deviations.resize(rows, 0.0F);
}

void RowMemory::observe(std::size_t rows, const Float4Array& before, const Float4Array& after, double observed_s,
                        float max_acceleration_m_per_s2) {
  assert(rows <= before.size() && before.size() == after.size());
  const auto per_s = static_cast<float>(1.0 / observed_s);
  for (std::size_t row = 0; row < rows; ++row) {
    const Float4 moved = scaled_sum(after[row], before[row], -1.0F);
    const Float4 velocity = multiply(moved, per_s);
    const Float4 change = scaled_sum(velocity, velocities[row], -1.0F);
    velocities[row] = velocity;
    const Float4 observed = limit_length(max_acceleration_m_per_s2, multiply(change, per_s));
    accelerations[row] = multiply(scaled_sum(accelerations[row], observed, 1.0F), 0.5F);
  }
  elapsed_s = observed_s;
}

namespace {

/// Returns the value of this rank from below, for a rank near the top. A sample of the values gives a threshold, and
/// only the values above it are sorted.
double upper_quantile(std::vector<double>& values, std::size_t rank) {
  assert(rank < values.size());
  constexpr std::size_t sampled_every = 16;
  std::vector<double> sample;
  for (std::size_t i = 0; i < values.size(); i += sampled_every) sample.push_back(values[i]);
  const std::size_t above = values.size() - rank;
  const std::size_t some_above = std::min(sample.size(), 2 * above / sampled_every + 4);
  const auto at = sample.end() - static_cast<std::ptrdiff_t>(some_above);
  std::nth_element(sample.begin(), at, sample.end());
  std::vector<double> top;
  std::copy_if(values.begin(), values.end(), std::back_inserter(top), [&](double value) { return value >= *at; });
  std::vector<double>& searched = top.size() >= above ? top : values;
  const auto found = searched.end() - static_cast<std::ptrdiff_t>(above);
  std::nth_element(searched.begin(), found, searched.end());
  return *found;
}

}  // namespace

double RowMemory::relative_speed_m_per_s(std::span<const Triangle> triangles) const {
  if (triangles.empty() || velocities.empty()) return 0.0;
  std::vector<double> squares;
  squares.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Vec3 between = to_vec3(scaled_sum(velocities[t[0]], velocities[t[1]], -1.0F));
    squares.push_back(glm::dot(between, between));
  }
  const auto rank = static_cast<std::size_t>(tuning::speed_quantile * static_cast<double>(squares.size()));
  return static_cast<float>(std::sqrt(upper_quantile(squares, rank)));
}

void RowMemory::save(std::size_t rows, ByteWriter& memory) const {
  memory.put<std::uint8_t>(is_touching ? 1 : 0);
  memory.put(elapsed_s);
  for (std::size_t row = 0; row < rows; ++row) {
    for (const Float4& v : {velocities[row], accelerations[row]}) {
      memory.put(v.x);
      memory.put(v.y);
      memory.put(v.z);
    }
    memory.put(deviations[row]);
  }
}

void RowMemory::restore(std::size_t rows, ByteReader& memory) {
  is_touching = memory.get_bool("whether something touched");
  elapsed_s = memory.get("the time of what was observed", 0.0, std::numeric_limits<double>::max());
  for (std::size_t row = 0; row < rows; ++row) {
    for (Float4* v : {&velocities[row], &accelerations[row]}) {
      for (float* value : {&v->x, &v->y, &v->z}) *value = memory.get<float>("how rows moved");
    }
    deviations[row] = memory.get<float>("how far rows went from where they were expected");
  }
}

void save(const Memory& memory, std::size_t vertex_count, ByteWriter& bytes) {
  bytes.put(memory.shift_ratio);
  bytes.put(memory.median_work);
  memory.control.save(bytes);
  save(memory.corrections, vertex_count, bytes);
  bytes.put<std::uint8_t>(memory.wind_velocity_m_per_s.empty() ? 0 : 1);
  if (!memory.wind_velocity_m_per_s.empty()) save(memory.wind_velocity_m_per_s, vertex_count, bytes);
  save(memory.elastic, bytes);
  const RowMemory& rows = memory.contact.rows;
  bytes.put<std::uint8_t>(rows.is_empty() ? 0 : 1);
  if (!rows.is_empty()) rows.save(vertex_count, bytes);
  save(memory.contact, bytes);
}

void restore(const Frame& frame, std::size_t row_count, ByteReader& bytes, Memory& memory) {
  const std::size_t vertex_count = frame.garment.mesh.positions.size();
  memory.shift_ratio = bytes.get("the last frame's shift", 0.0, std::numeric_limits<double>::max());
  memory.median_work = bytes.get("the work of a frame", 0.0, std::numeric_limits<double>::max());
  memory.control.restore(bytes);
  memory.corrections = restored_rows(vertex_count, row_count, "the last frame's correction", bytes);
  memory.wind_velocity_m_per_s.clear();
  if (bytes.get_bool("whether the wind was updated")) {
    memory.wind_velocity_m_per_s = restored_rows(vertex_count, row_count, "what the wind brings about", bytes);
  }
  restore(frame, bytes, memory.elastic);
  if (bytes.get_bool("whether anything could touch")) {
    memory.contact.rows.resize(row_count);
    memory.contact.rows.restore(vertex_count, bytes);
  }
  restore(frame, bytes, memory.contact);
}

}  // namespace taut::sim::bounded
