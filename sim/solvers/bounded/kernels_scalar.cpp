#include <algorithm>
#include <cmath>

#include "sim/solvers/bounded/kernel_tables.hpp"
#include "sim/solvers/bounded/kernels.hpp"

namespace taut::sim::bounded {
namespace {

struct Spring {
  float x, y, z;
  float squared_length;
};

Row& row_at(Row* rows, std::uint32_t at) {
  return rows[at / 4];
}

Spring spring_between(const SpringBlock& block, std::size_t k, const Row* rows) {
  const Row& i = rows[block.at_i[k] / 4];
  const Row& j = rows[block.at_j[k] / 4];
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
                    float share_i, Row* rows) {
  Row& i = row_at(rows, block.at_i[k]);
  Row& j = row_at(rows, block.at_j[k]);
  j.x = j.x + shorten_along(spring.x * fraction, share_i, i.x);
  j.y = j.y + shorten_along(spring.y * fraction, share_i, i.y);
  j.z = j.z + shorten_along(spring.z * fraction, share_i, i.z);
}

float predicted(float current, float previous, float decay, float acceleration, float dt_squared) {
  return current + ((current - previous) * decay + acceleration * dt_squared);
}

void predict(std::size_t begin, std::size_t end, float decay, float dt_squared, const Row* accelerations,
             const Row* current, Row* previous) {
  for (std::size_t r = begin; r < end; ++r) {
    const Row& d = current[r];
    const Row& a = accelerations[r];
    Row& p = previous[r];
    p = {predicted(d.x, p.x, decay, a.x, dt_squared), predicted(d.y, p.y, decay, a.y, dt_squared),
         predicted(d.z, p.z, decay, a.z, dt_squared), 0.0F};
  }
}

void sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Row* rows) {
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

void hold(const TetherLanes& tethers, std::size_t begin, std::size_t end, const Row& pin_moved, Row* rows) {
  for (std::size_t r = begin; r < end; ++r) {
    const float x = (rows[r].x - pin_moved.x) + tethers.start[r].x;
    const float y = (rows[r].y - pin_moved.y) + tethers.start[r].y;
    const float z = (rows[r].z - pin_moved.z) + tethers.start[r].z;
    const float squared = (x * x + y * y) + z * z;
    const float excess = squared - tethers.squared_length[r];
    if (excess > 0.0F) {
      const float error = excess / (squared + tethers.squared_length[r]);
      rows[r] = {rows[r].x - x * error, rows[r].y - y * error, rows[r].z - z * error, 0.0F};
    }
  }
}

void shorten(const SpringLanes& springs, std::size_t begin, std::size_t end, float squared_bound,
             float relaxation, Row* rows) {
  for (std::size_t b = begin; b < end; ++b) {
    const SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; ++k) {
      const Spring spring = spring_between(block, k, rows);
      const float limit = block.squared_rest[k] * squared_bound;
      const float excess = spring.squared_length - limit;
      if (excess > 0.0F) {
        const float error = excess / (spring.squared_length + std::sqrt(spring.squared_length * limit));
        shorten_spring(block, k, spring, error * relaxation, springs.certificate_share_i[b * block_size + k],
                       rows);
      }
    }
  }
}

void largest_ratios(const SpringLanes& springs, std::size_t begin, std::size_t end, const Row* rows,
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

Triple sum(const Row& a, const Row& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Triple difference(const Row& a, const Row& b) {
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
          const Row* start, const Row* current, const Row* previous, Row* corner_forces) {
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
    const float held = air.time_per_density * 2.0F;
    const Triple per_area = along_normal * (pressure / (1.0F + held * pressure)) +
                            (u - along_normal) * (friction / (1.0F + held * friction));
    const Triple share = per_area * (doubled_size / 6.0F);
    corner_forces[t] = {share.x, share.y, share.z, 0.0F};
  }
}

void add_scaled(const Triple& x, float factor, Row& total) {
  total.x = total.x + x.x * factor;
  total.y = total.y + x.y * factor;
  total.z = total.z + x.z * factor;
}

void add_product(const RowMatrix& matrix, std::size_t begin, std::size_t end, const Row* positions,
                 Row* result) {
  for (std::size_t r = begin; r < end; ++r) {
    const Row& x = positions[r];
    Row even;
    Row odd;
    for (std::uint32_t k = matrix.begin[r]; k < matrix.begin[r + 1]; k += 2) {
      add_scaled(difference(positions[matrix.column[k]], x), matrix.value[k], even);
      add_scaled(difference(positions[matrix.column[k + 1]], x), matrix.value[k + 1], odd);
    }
    Row& sum_of = result[r];
    sum_of = {sum_of.x + (even.x + odd.x), sum_of.y + (even.y + odd.y), sum_of.z + (even.z + odd.z), 0.0F};
  }
}

}  // namespace

const Kernels& scalar_kernels() {
  static constexpr Kernels table = {predict, sweep, hold, shorten, largest_ratios, wind, add_product};
  return table;
}

}  // namespace taut::sim::bounded
