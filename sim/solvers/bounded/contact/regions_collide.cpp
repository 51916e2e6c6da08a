
#include "sim/contact/law.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

void Regions::add_touch(const RegionPair& pair, const std::array<float, 4>& weights, const RowMoves& rows) {
  const ContactPair& contact = pair.contact;
  const auto sign = [&](Index k) { return k < contact.near.first_count ? 1.0F : -1.0F; };
  float mobility = 0.0F;
  float distance = 0.0F;
  for (Index k = 0; k < 4; ++k) {
    mobility += weights[k] * weights[k] * rows.inverse_masses_per_kg[contact.near.rows[k]];
    distance += sign(k) * weights[k] * pair.heights[k];
  }
  if (!(mobility > 0.0F)) return;
  Touch touch{};
  glm::vec3 carried(0.0F);
  for (Index k = 0; k < 4; ++k) {
    const Index row = contact.near.rows[k];
    const float weight = sign(k) * weights[k];
    if (row < rows.cloth_count) {
      touch.rows[touch.count] = row;
      touch.weights[touch.count] = weight;
      touch.mobilities[touch.count] = weight * rows.inverse_masses_per_kg[row] / mobility;
      ++touch.count;
    } else {
      carried += weight * vec(planned_motions_[row]);
    }
  }
  const float wanted = std::min(contact.thickness_m, std::max(distance, 0.0F));
  const float lacking = contact.thickness_m - wanted;
  const float separation =
      std::min(lacking, std::max(tuning::separation_fraction * lacking, min_gap_fraction * contact.thickness_m));
  add(touch.normal, pair.normal);
  add(touch.kinematic_motion, carried - contact.surface_slide_m);
  touch.distance = distance;
  touch.target_distance = wanted;
  touch.rate = separation - glm::dot(pair.normal, carried);
  touch.friction = contact.friction;
  touches_.push_back(touch);
}

void Regions::make_touches(const RowMoves& rows) {
  touches_.clear();
  for (const RegionPair& pair : pairs_) {
    if (std::min(pair.distance, span_at_end(pair).apart()) > collision_distance_m(pair.contact.thickness_m)) continue;
    if (pair.contact.near.first_count < 3) {
      add_touch(pair, pair.weights, rows);
    } else {
      for (Index k = 0; k < 3; ++k) {
        std::array<float, 4> weights = {0.0F, 0.0F, 0.0F, 1.0F};
        weights[k] = 1.0F;
        add_touch(pair, weights, rows);
      }
    }
  }
}

void Regions::collide(const Touch& touch, float time, float step, const Float4* since, Float4* previous,
                      Float4* current) {
  Float4 moved{};
  for (std::size_t k = 0; k < touch.count; ++k) {
    const Index row = touch.rows[k];
    add_scaled(moved, scaled_sum(current[row], since[row], -1.0F), touch.weights[k]);
  }
  const float lacking = touch.target_distance + time * touch.rate - touch.distance - dot(touch.normal, moved);
  if (!(lacking > 0.0F)) return;
  const Float4 separation = multiply(touch.normal, lacking);
  Float4 sliding = scaled_sum(separation, touch.kinematic_motion, step);
  for (std::size_t k = 0; k < touch.count; ++k) {
    const Index row = touch.rows[k];
    add_scaled(sliding, scaled_sum(current[row], previous[row], -1.0F), touch.weights[k]);
  }
  const float away = dot(sliding, touch.normal);
  sliding = scaled_sum(sliding, touch.normal, -away);
  const float stopped = stopped_share(touch.friction, lacking, std::sqrt(dot(sliding, sliding)));
  const Float4 moves = scaled_sum(separation, sliding, -stopped);
  const Float4 unspent = multiply(touch.normal, std::clamp(away, 0.0F, lacking));
  for (std::size_t k = 0; k < touch.count; ++k) {
    add_scaled(current[touch.rows[k]], moves, touch.mobilities[k]);
    add_scaled(previous[touch.rows[k]], unspent, touch.mobilities[k]);
  }
}

void Regions::collide(float time, float step, const Float4Array& since, Float4Array& previous,
                      Float4Array& current) const {
  assert(step >= 0.0F);
  assert(since.size() == current.size());
  assert(previous.size() == current.size());
  for (const Touch& touch : touches_) {
    collide(touch, time, step, since.data(), previous.data(), current.data());
  }
  for (auto touch = touches_.rbegin(); touch != touches_.rend(); ++touch) {
    collide(*touch, time, step, since.data(), previous.data(), current.data());
  }
}

}  // namespace taut::sim::bounded
