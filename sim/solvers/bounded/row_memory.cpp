#include "sim/solvers/bounded/row_memory.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

void RowMemory::resize(std::size_t rows) {
  velocities.resize(rows);
  accelerations.resize(rows);
  deviations.resize(rows, 0.0F);
}

void RowMemory::observe(std::size_t rows, const Float4Array& before, const Float4Array& after, double observed_s,
                        float most_acceleration) {
  const auto per_s = static_cast<float>(1.0 / observed_s);
  for (std::size_t row = 0; row < rows; ++row) {
    const Float4 moved = scaled_sum(after[row], before[row], -1.0F);
    const Float4 velocity = times(moved, per_s);
    const Float4 change = scaled_sum(velocity, velocities[row], -1.0F);
    velocities[row] = velocity;
    const Float4 observed = no_longer_than(most_acceleration, times(change, per_s));
    accelerations[row] = times(scaled_sum(accelerations[row], observed, 1.0F), 0.5F);
  }
  elapsed_s = observed_s;
}

namespace {

/// Returns the value with this rank from below, of values of which few are above it: those are found by what some of
/// the values are, and put in order.
double ranked_near_the_top(std::vector<double>& values, std::size_t rank) {
  constexpr std::size_t sampled_every = 16;
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += sampled_every) some.push_back(values[i]);
  const std::size_t above = values.size() - rank;
  const std::size_t some_above = std::min(some.size(), 2 * above / sampled_every + 4);
  const auto at = some.end() - static_cast<std::ptrdiff_t>(some_above);
  std::nth_element(some.begin(), at, some.end());
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
    const Vec3 between = vector_of(scaled_sum(velocities[t[0]], velocities[t[1]], -1.0F));
    squares.push_back(glm::dot(between, between));
  }
  const auto rank = static_cast<std::size_t>(tuning::counted_part * static_cast<double>(squares.size()));
  return static_cast<float>(std::sqrt(ranked_near_the_top(squares, rank)));
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

}  // namespace taut::sim::bounded
