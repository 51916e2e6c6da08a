#include "scalar_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "sim/solvers/bounded/kernels/kernel_tables.hpp"

namespace taut::sim::bounded {
namespace {

struct Spring {
  float x, y, z;
  float squared_length;
};

Float4& row_at(Float4* rows, std::uint32_t at) {
  return rows[at / 4];
}

Spring spring_between(const SpringBlock& block, std::size_t k, const Float4* rows) {
  const Float4& i = rows[block.at_i[k] / 4];
  const Float4& j = rows[block.at_j[k] / 4];
  const float x = (i.x - j.x) + block.start_x[k];
  const float y = (i.y - j.y) + block.start_y[k];
  const float z = (i.z - j.z) + block.start_z[k];
  return {x, y, z, (x * x + y * y) + z * z};
}

/// What end j moves by along one axis, where end i has moved the other way by the rest of it.
float shorten_along(float whole, float share_i, float& i) {
  const float part_i = whole * share_i;
  i = i - part_i;
  return whole - part_i;
}

void shorten_spring(const SpringBlock& block, std::size_t k, const Spring& spring, float fraction,
                    float share_i, Float4* rows) {
  Float4& i = row_at(rows, block.at_i[k]);
  Float4& j = row_at(rows, block.at_j[k]);
  j.x = j.x + shorten_along(spring.x * fraction, share_i, i.x);
  j.y = j.y + shorten_along(spring.y * fraction, share_i, i.y);
  j.z = j.z + shorten_along(spring.z * fraction, share_i, i.z);
}

float predicted(float current, float previous, float decay, float acceleration, float dt_squared) {
  return current + ((current - previous) * decay + acceleration * dt_squared);
}

void hold(const Tether& tether, const Float4& pin_moved, Float4& row) {
  const float x = (row.x - pin_moved.x) + tether.start_x;
  const float y = (row.y - pin_moved.y) + tether.start_y;
  const float z = (row.z - pin_moved.z) + tether.start_z;
  const float squared = (x * x + y * y) + z * z;
  const float excess = squared - tether.squared_length;
  if (excess > 0.0F) {
    const float error = excess / (squared + tether.squared_length);
    row = {row.x - x * error, row.y - y * error, row.z - z * error, 0.0F};
  }
}

void predict(std::size_t begin, std::size_t end, const Prediction& prediction, const Tether* tethers,
             const Float4* accelerations, const Float4* current, Float4* previous) {
  const auto [decay, dt_squared, pins_moved] = prediction;
  for (std::size_t r = begin; r < end; ++r) {
    const Float4& d = current[r];
    const Float4& a = accelerations[r];
    Float4& p = previous[r];
    p = {predicted(d.x, p.x, decay, a.x, dt_squared), predicted(d.y, p.y, decay, a.y, dt_squared),
         predicted(d.z, p.z, decay, a.z, dt_squared), 0.0F};
    if (tethers != nullptr) {
      hold(tethers[r], pins_moved, p);
    }
  }
}

void start_springs(const StartRows& start, std::size_t begin, std::size_t end, SpringLanes& springs) {
  const auto& [high, low] = start;
  for (std::size_t b = begin; b < end; ++b) {
    SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; ++k) {
      const std::uint32_t i = block.at_i[k] / 4;
      const std::uint32_t j = block.at_j[k] / 4;
      block.start_x[k] = (high[i].x - high[j].x) + (low[i].x - low[j].x);
      block.start_y[k] = (high[i].y - high[j].y) + (low[i].y - low[j].y);
      block.start_z[k] = (high[i].z - high[j].z) + (low[i].z - low[j].z);
    }
  }
}

void sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Float4* rows) {
  for (std::size_t b = begin; b < end; ++b) {
    const SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; ++k) {
      const Spring spring = spring_between(block, k, rows);
      const float error =
          (spring.squared_length - block.squared_rest[k]) / (spring.squared_length + block.squared_rest[k]);
      shorten_spring(block, k, spring, std::max(error, error * block.short_share[k]), block.share_i[k], rows);
    }
  }
}

void shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
             float relaxation, Float4* rows) {
  for (const std::uint32_t b : blocks) {
    const SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; ++k) {
      const Spring spring = spring_between(block, k, rows);
      const float limit = block.squared_rest[k] * squared_bound;
      const float excess = spring.squared_length - limit;
      if (excess > 0.0F) {
        const float error = excess / (spring.squared_length + std::sqrt(spring.squared_length * limit));
        shorten_spring(block, k, spring, error * relaxation, springs.projection_share_i[b * block_size + k],
                       rows);
      }
    }
  }
}

void largest_ratios(const SpringLanes& springs, std::size_t begin, std::size_t end, const Float4* rows,
                    float* squared_ratios) {
  for (std::size_t b = begin; b < end; ++b) {
    const SpringBlock& block = springs.blocks[b];
    float largest = 0.0F;
    for (std::size_t k = 0; k < block_size; ++k) {
      largest = std::max(largest, spring_between(block, k, rows).squared_length / block.squared_rest[k]);
    }
    squared_ratios[b] = largest;
  }
}

struct Triple {
  float x, y, z;
};

Triple sum(const Float4& a, const Float4& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Triple difference(const Float4& a, const Float4& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Triple operator*(const Triple& a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
float dot(const Triple& a, const Triple& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void wind(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
          const Float4* start, const Float4* current, const Float4* previous, Float4* corner_forces) {
  for (std::size_t t = begin; t < end; ++t) {
    const std::uint32_t a = triangles.at[0][t] / 4;
    const std::uint32_t b = triangles.at[1][t] / 4;
    const std::uint32_t c = triangles.at[2][t] / 4;
    const Triple at = sum(start[a], current[a]);
    const Triple edge_b = sum(start[b], current[b]) - at;
    const Triple edge_c = sum(start[c], current[c]) - at;
    const Triple moved = (difference(current[a], previous[a]) + difference(current[b], previous[b])) +
                         difference(current[c], previous[c]);
    const float third_per_step = air.per_time_step / 3.0F;
    const Triple flow = {air.velocity_m_per_s[0], air.velocity_m_per_s[1], air.velocity_m_per_s[2]};
    const Triple u = flow - moved * third_per_step;

    const Triple doubled_area = cross(edge_b, edge_c);
    const float doubled_size = std::sqrt(dot(doubled_area, doubled_area));
    const Triple normal = doubled_area * (1.0F / std::max(doubled_size, smallest_doubled_area_m2));
    const float u_n = dot(u, normal);
    const Triple along_normal = normal * u_n;
    const float pressure = air.half_density_pressure * std::abs(u_n);
    const float friction = air.half_density_friction * std::sqrt(dot(u, u));
    const float twice_per_density = air.time_per_density * 2.0F;
    const Triple per_area = along_normal * (pressure / (1.0F + twice_per_density * pressure)) +
                            (u - along_normal) * (friction / (1.0F + twice_per_density * friction));
    const Triple share = per_area * (doubled_size / 6.0F);
    corner_forces[t] = {share.x, share.y, share.z, 0.0F};
  }
}

void add_scaled(const Triple& x, float factor, Float4& total) {
  total.x = total.x + x.x * factor;
  total.y = total.y + x.y * factor;
  total.z = total.z + x.z * factor;
}

void add_product(const SlicedMatrix& matrix, std::size_t begin, std::size_t end, const Float4* positions,
                 Float4* result) {
  for (std::size_t lane = begin * block_size; lane < end * block_size; ++lane) {
    const std::size_t slice = lane / block_size;
    const std::uint32_t row = matrix.row_at[lane] / 4;
    Float4 sum;
    for (std::uint32_t b = matrix.begin[slice]; b < matrix.begin[slice + 1]; ++b) {
      const std::size_t entry = b * block_size + lane % block_size;
      add_scaled(difference(positions[matrix.column_at[entry] / 4], positions[row]), matrix.value[entry],
                 sum);
    }
    result[row] = scaled_sum(result[row], sum, 1.0F);
  }
}

}  // namespace

const Kernels& scalar_kernels() {
  static constexpr Kernels table = {predict,        start_springs, sweep,      shorten,
                                    largest_ratios, wind,          add_product};
  return table;
}

}  // namespace taut::sim::bounded
