#include "sim/solvers/bounded/contacts.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/contact/layers.hpp"

namespace taut::sim::bounded {
namespace {

/// Only vertices that could reach a body within the frame are checked. It is assumed that speeds grow to
/// at most this many times their value in a frame, and that vertices move by this much more, in m. Larger
/// values check more vertices; smaller ones let fast vertices enter bodies.
constexpr double reach_factor = 2.0;
constexpr double extra_reach_m = 0.02;

/// The fraction of an overlap that one parting removes. A larger value pulls more at the springs.
constexpr double parted_at_once = 0.3;

double largest_speed(const Float4Array& velocities) {
  double largest = 0.0;
  for (const Float4& v : velocities) {
    largest = std::max(largest, glm::length(vector_of(v)));
  }
  return largest;
}

bool is_near_any(const std::vector<Shape>& shapes, const Vec3& position_m, double reach_m) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const Shape& shape) {
    return nearest_surface(shape, position_m).distance_m < reach_m;
  });
}

void add(Float4& row, const Vec3& v) {
  row.x += static_cast<float>(v.x);
  row.y += static_cast<float>(v.y);
  row.z += static_cast<float>(v.z);
}

}  // namespace

void Contacts::begin_frame(const Garment& garment, const Pins& pins, const Layout& layout,
                           const Surroundings& surroundings, const Motion& motion,
                           const Float4Array& velocities, double time_s, double frame_time_s) {
  near_rows_.clear();
  near_inverse_masses_per_kg_.clear();
  if (surroundings.bodies.empty()) {
    return;
  }
  bool any_moves = false;
  std::vector<Shape> shapes;
  for (const Body& body : surroundings.bodies) {
    any_moves = any_moves || is_moving_after(body, time_s);
    shapes.push_back(shape_at(body, time_s));
  }
  const double gravity = glm::length(surroundings.forces.gravity_m_per_s2);
  const double travel_m = frame_time_s * (largest_speed(velocities) + gravity * frame_time_s);
  const double reach_m = garment.material.thickness_m + reach_factor * travel_m + extra_reach_m;
  for (Index row = static_cast<Index>(layout.pin_count); row < layout.vertex_count(); ++row) {
    if (any_moves || is_near_any(shapes, motion.start_m[row], reach_m)) {
      near_rows_.push_back(row);
      near_inverse_masses_per_kg_.push_back(pins.inverse_masses_per_kg[layout.vertex_of_row[row]]);
    }
  }
  near_current_m_.resize(near_rows_.size());
  near_predicted_m_.resize(near_rows_.size());
}

void Contacts::push_out(const Material& cloth, const Surroundings& surroundings, const TimeSpan& step,
                        Motion& motion) {
  if (near_rows_.empty()) {
    return;
  }
  for (std::size_t k = 0; k < near_rows_.size(); ++k) {
    const Index row = near_rows_[k];
    near_current_m_[k] = motion.start_m[row] + vector_of(motion.previous[row]);
    near_predicted_m_[k] = motion.start_m[row] + vector_of(motion.current[row]);
  }
  push_out_of_bodies(surroundings.bodies, {cloth.thickness_m, cloth.friction}, step,
                     near_inverse_masses_per_kg_, near_current_m_, near_predicted_m_);
  for (std::size_t k = 0; k < near_rows_.size(); ++k) {
    const Index row = near_rows_[k];
    motion.current[row] = float4_of(near_predicted_m_[k] - motion.start_m[row]);
  }
}

void Contacts::part_layers(const Garment& garment, const Layout& layout, double layer_distance_m,
                           Motion& motion) {
  positions_m_.resize(layout.vertex_count());
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    positions_m_[layout.vertex_of_row[row]] = motion.start_m[row] + vector_of(motion.current[row]);
  }
  layers_.update(garment.mesh.positions, positions_m_, layer_distance_m);
  const LayerParting little_by_little = {layer_distance_m, parted_at_once, false};
  for (const auto& [a, b] : layers_.pairs()) {
    const Index i = layout.row_of_vertex[a];
    const Index j = layout.row_of_vertex[b];
    const double w_i = layout.inverse_masses_per_kg[i];
    const double w_j = layout.inverse_masses_per_kg[j];
    const Vec3 now_i = vector_of(motion.current[i]);
    const Vec3 now_j = vector_of(motion.current[j]);
    const Vec3 between = (motion.start_m[i] + now_i) - (motion.start_m[j] + now_j);
    const Vec3 moved = (now_i - vector_of(motion.previous[i])) - (now_j - vector_of(motion.previous[j]));
    if (const auto parted = part(little_by_little, between, moved, w_i + w_j)) {
      add(motion.current[i], w_i * parted->current);
      add(motion.previous[i], w_i * parted->previous);
      add(motion.current[j], -w_j * parted->current);
      add(motion.previous[j], -w_j * parted->previous);
    }
  }
}

}  // namespace taut::sim::bounded
