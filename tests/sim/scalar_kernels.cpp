#include "scalar_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "sim/solvers/bounded/kernels/kernel_tables.hpp"

namespace taut::sim::bounded {
namespace {

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

/// Moves end i along one axis by its share. Returns the rest, by which end j moves the other way.
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

float predict(float current, float previous, float decay, float acceleration, float dt_squared) {
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
    p = {predict(d.x, p.x, decay, a.x, dt_squared), predict(d.y, p.y, decay, a.y, dt_squared),
         predict(d.z, p.z, decay, a.z, dt_squared), 0.0F};
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

void find_max_ratios(const SpringLanes& springs, std::size_t begin, std::size_t end, const Float4* rows,
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

void add(Float4& row, const Triple& v) {
  row = {row.x + v.x, row.y + v.y, row.z + v.z, 0.0F};
}
void subtract(Float4& row, const Triple& v) {
  row = {row.x - v.x, row.y - v.y, row.z - v.z, 0.0F};
}

struct Gradient {
  Triple along, across;
};

/// The squared singular values, half their difference (`radius`), and the products of `radius` with the cosine and the
/// sine of twice the angle of the largest value's direction.
struct Principal {
  float largest, smallest;
  float radius, difference, product;
};

Triple lane_triple(const std::array<SurfaceBlock::Of<float>, 3>& values, std::size_t k) {
  return {values[0][k], values[1][k], values[2][k]};
}

Gradient compute_gradient(const SurfaceBlock& block, std::size_t k, const Triple& e1, const Triple& e2) {
  return {e1 * block.along_per_m[k], e2 * block.across_per_m[k] - e1 * block.skew_per_m[k]};
}

Gradient gradient_now(const SurfaceBlock& block, std::size_t k, const Float4* rows) {
  const Float4& a = rows[block.at[0][k] / 4];
  const Gradient moved =
      compute_gradient(block, k, difference(rows[block.at[1][k] / 4], a), difference(rows[block.at[2][k] / 4], a));
  return {moved.along + lane_triple(block.start_along, k), moved.across + lane_triple(block.start_across, k)};
}

Principal compute_principal(const Gradient& gradient) {
  const float a = dot(gradient.along, gradient.along);
  const float b = dot(gradient.along, gradient.across);
  const float c = dot(gradient.across, gradient.across);
  const float mean = (a + c) * 0.5F;
  const float difference = (a - c) * 0.5F;
  const float radius = std::max(std::sqrt(difference * difference + b * b), min_radius);
  return {mean + radius, mean - radius, radius, difference, b};
}

struct Divisors {
  float first, second;
};

Divisors compute_divisors(const SurfaceMobility& mobility, std::size_t k, const Principal& v) {
  const float middle = v.radius * (0.5F + min_mobility);
  const float to_first = mobility.along_less_across[k] * v.difference + mobility.skew[k] * v.product;
  return {middle + to_first, middle - to_first};
}

struct Symmetric {
  float along, across, mixed;
};

Symmetric symmetric(const Principal& v, float first, float second) {
  const float mean = ((first + second) * 0.5F) * v.radius;
  const float half_difference = (first - second) * 0.5F;
  return {mean + half_difference * v.difference, mean - half_difference * v.difference,
          half_difference * v.product};
}

void move_corners(const SurfaceBlock& block, std::size_t k, const Gradient& gradient, const Principal& v,
                  float first, float second, const SurfaceMobility& mobility, Float4* rows) {
  const auto [s11, s22, s12] = symmetric(v, first, second);
  const float along = block.along_per_m[k];
  const float across = block.across_per_m[k];
  const float skew = block.skew_per_m[k];
  const Triple b = gradient.along * (along * s11 - skew * s12) + gradient.across * (along * s12 - skew * s22);
  const Triple c = gradient.along * (across * s12) + gradient.across * (across * s22);
  add(row_at(rows, block.at[0][k]), (b + c) * mobility.corners[0][k]);
  subtract(row_at(rows, block.at[1][k]), b * mobility.corners[1][k]);
  subtract(row_at(rows, block.at[2][k]), c * mobility.corners[2][k]);
}

void start_surface(const StartRows& start, std::size_t begin, std::size_t end, SurfaceLanes& triangles) {
  const auto from = [&](std::size_t i, std::size_t j) {
    const Triple coarse = difference(start.high[j], start.high[i]);
    const Triple fine = difference(start.low[j], start.low[i]);
    return coarse + fine;
  };
  for (std::size_t lane = begin * block_size; lane < end * block_size; ++lane) {
    SurfaceBlock& block = triangles.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    const std::size_t a = block.at[0][k] / 4;
    const Gradient gradient = compute_gradient(block, k, from(a, block.at[1][k] / 4), from(a, block.at[2][k] / 4));
    const std::array<float, 3> along_now = {gradient.along.x, gradient.along.y, gradient.along.z};
    const std::array<float, 3> across_now = {gradient.across.x, gradient.across.y, gradient.across.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.start_along[axis][k] = along_now[axis];
      block.start_across[axis][k] = across_now[axis];
    }
  }
}

void sweep_surface(const SurfaceLanes& triangles, const BlockRange& range, SurfaceSums* sums, Float4* rows) {
  for (std::size_t lane = range.begin * block_size; lane < range.end * block_size; ++lane) {
    const SurfaceBlock& block = triangles.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    const Gradient gradient = gradient_now(block, k, rows);
    const Principal s = compute_principal(gradient);
    const Divisors divisors = compute_divisors(block.mobility, k, s);
    const float first_divisor = (s.largest + 1.0F) * divisors.first;
    const float second_divisor = (s.smallest + 1.0F) * divisors.second;
    const float per_both = 1.0F / (first_divisor * second_divisor);
    const float first = ((s.largest - 1.0F) * second_divisor) * per_both;
    const float second = ((s.smallest - 1.0F) * first_divisor) * per_both;
    const float share = range.is_repeat ? 0.0F : block.short_share[k];
    const float shared_first = std::max(first * triangles.relaxation, first * share);
    const float shared_second = std::max(second * triangles.relaxation, second * share);
    if (sums != nullptr) {
      const Symmetric change = symmetric(s, shared_first * (s.largest * 0.5F + 0.5F),
                                         shared_second * (s.smallest * 0.5F + 0.5F));
      sums[lane / block_size].along[k] += change.along;
      sums[lane / block_size].across[k] += change.across;
      sums[lane / block_size].mixed[k] += change.mixed;
    }
    move_corners(block, k, gradient, s, shared_first, shared_second, block.mobility, rows);
  }
}

float excess_over(float squared, float squared_bound, float relaxation, float divisor) {
  const float excess = squared - squared_bound;
  const float whole = (squared + std::sqrt(squared * squared_bound)) * divisor;
  return excess > 0.0F ? (excess * relaxation) / whole : 0.0F;
}

void shorten_surface(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks,
                     float squared_bound, float relaxation, Float4* rows) {
  for (const std::uint32_t b : blocks) {
    for (std::size_t k = 0; k < block_size; ++k) {
      const SurfaceBlock& block = triangles.blocks[b];
      const Gradient gradient = gradient_now(block, k, rows);
      const Principal s = compute_principal(gradient);
      if (s.largest > squared_bound) {
        const SurfaceMobility& mobility = triangles.projection_mobility[b];
        const Divisors divisors = compute_divisors(mobility, k, s);
        move_corners(block, k, gradient, s, excess_over(s.largest, squared_bound, relaxation, divisors.first),
                     excess_over(s.smallest, squared_bound, relaxation, divisors.second), mobility, rows);
      }
    }
  }
}

void find_max_surface_ratios(const SurfaceLanes& triangles, std::size_t begin, std::size_t end, const Float4* rows,
                             float* squared_ratios) {
  for (std::size_t b = begin; b < end; ++b) {
    float largest = 0.0F;
    for (std::size_t k = 0; k < block_size; ++k) {
      largest = std::max(largest, compute_principal(gradient_now(triangles.blocks[b], k, rows)).largest);
    }
    squared_ratios[b] = largest;
  }
}

void wind(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
          const Float4* start, const Float4* current, const Float4* previous, const Float4* opposed,
          Float4* corner_forces) {
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
    const Triple u = flow * air.fractions[t] - moved * third_per_step;

    const Triple doubled_area = cross(edge_b, edge_c);
    const float doubled_size = std::sqrt(dot(doubled_area, doubled_area));
    const Triple normal = doubled_area * (1.0F / std::max(doubled_size, min_doubled_area_m2));
    const float u_n = dot(u, normal);
    const float speed = std::sqrt(dot(u, u));
    constexpr float pi = 3.14159265F;
    const float sine = std::abs(u_n) / std::max(speed, min_air_speed_m_per_s);
    const float per_divisor = 1.0F / (4.0F + pi * sine);
    const float drag = (air.half_density_pressure * (4.0F + pi)) * (speed * per_divisor);
    const float slope = drag * ((4.0F + (sine * sine) * (4.0F + (2.0F * pi) * sine)) * per_divisor);
    const float pressure = drag * std::abs(u_n);
    const float friction = air.half_density_friction * speed;
    const Triple others = sum(opposed[a], opposed[b]) + sum(opposed[c], {});
    const float movable = std::max((opposed[a].fourth + opposed[b].fourth) + opposed[c].fourth, 1.0F);
    const float along = dot(others, normal) / movable;
    const float against = std::min(std::max(u_n < 0.0F ? along : -along, 0.0F),
                                   air.time_per_density * pressure);
    const float held = (pressure + slope * against) / (1.0F + air.time_per_density * slope);
    const Triple per_area = normal * std::copysign(held, u_n) +
                            (u - normal * u_n) * (friction / (1.0F + air.time_per_density * (friction + friction)));
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
  static constexpr Kernels table = {predict,       start_springs,   sweep,
                                    shorten,       find_max_ratios, start_surface,
                                    sweep_surface, shorten_surface, find_max_surface_ratios,
                                    wind,          add_product,     {}};
  return table;
}

}  // namespace taut::sim::bounded
