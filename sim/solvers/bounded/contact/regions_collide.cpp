#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/solvers/bounded/contact/regions.hpp"

namespace taut::sim::bounded {
namespace {

/// Of what two things lack to the thickness, so much is asked for while regions last, and no less than this,
/// in m. More throws them apart; less lets a pile sink into itself.
constexpr float parted_at_once = 0.2F;
constexpr float least_parted_m = 1e-4F;
/// What is expected to come no nearer than this to touching is left to its planes, in m.
constexpr float may_touch_within_m = 2e-4F;

}  // namespace

void Regions::add_touch(const Pair& pair, const std::array<float, 4>& weights,
                        std::span<const float> inverse_masses) {
  const ContactPair& contact = pair.contact;
  float mobility = 0.0F;
  float distance = 0.0F;
  std::array<float, 4> signed_weights{};
  for (Index k = 0; k < 4; ++k) {
    signed_weights[k] = k < contact.near.first_count ? weights[k] : -weights[k];
    mobility += weights[k] * weights[k] * inverse_masses[contact.near.rows[k]];
    distance += signed_weights[k] * pair.heights[k];
  }
  if (!(mobility > 0.0F)) {
    return;
  }
  std::array<float, 4> mobilities{};
  for (Index k = 0; k < 4; ++k) {
    mobilities[k] = signed_weights[k] * inverse_masses[contact.near.rows[k]] / mobility;
  }
  const float wanted = std::min(contact.thickness_m, std::max(distance, 0.0F));
  const float lacking = contact.thickness_m - wanted;
  const float parted = std::min(lacking, std::max(parted_at_once * lacking, least_parted_m));
  touches_.push_back({contact.near.rows, signed_weights, mobilities, pair.normal, distance, wanted, parted,
                      contact.friction, contact.surface_slides});
}

void Regions::make_touches(std::span<const float> inverse_masses) {
  touches_.clear();
  for (const Pair& pair : pairs_) {
    if (std::min(pair.distance, span_at_end(pair).apart()) > pair.contact.thickness_m + may_touch_within_m) {
      continue;
    }
    if (pair.contact.near.first_count < 3) {
      add_touch(pair, pair.weights, inverse_masses);
    } else {
      for (Index k = 0; k < 3; ++k) {
        std::array<float, 4> weights = {0.0F, 0.0F, 0.0F, 1.0F};
        weights[k] = 1.0F;
        add_touch(pair, weights, inverse_masses);
      }
    }
  }
}

void Regions::collide(const Touch& touch, float time, float step, const Float4Array& since,
                      Float4Array& previous, Float4Array& current) const {
  // Rows of bodies are not among the displacements.
  const auto is_cloth = [&](Index row) { return row < since.size(); };
  glm::vec3 moved(0.0F);
  for (std::size_t k = 0; k < 4; ++k) {
    const Index row = touch.rows[k];
    moved +=
        touch.weights[k] * (is_cloth(row) ? vec(current[row]) - vec(since[row]) : time * vec(moves_[row]));
  }
  const float lacking = touch.wanted + time * touch.rate - touch.distance - glm::dot(touch.normal, moved);
  if (!(lacking > 0.0F)) {
    return;
  }
  glm::vec3 slid = lacking * touch.normal - step * touch.slides;
  for (std::size_t k = 0; k < 4; ++k) {
    const Index row = touch.rows[k];
    slid +=
        touch.weights[k] * (is_cloth(row) ? vec(current[row]) - vec(previous[row]) : step * vec(moves_[row]));
  }
  const float away = glm::dot(slid, touch.normal);
  slid -= away * touch.normal;
  const float length = glm::length(slid);
  const float stopped = length > 0.0F ? std::min(1.0F, touch.friction * lacking / length) : 0.0F;
  const glm::vec3 moves = lacking * touch.normal - stopped * slid;
  const glm::vec3 unspent = std::clamp(away, 0.0F, lacking) * touch.normal;
  for (std::size_t k = 0; k < 4; ++k) {
    const Index row = touch.rows[k];
    if (is_cloth(row)) {
      add(current[row], touch.mobilities[k] * moves);
      add(previous[row], touch.mobilities[k] * unspent);
    }
  }
}

void Regions::collide(float time, float step, const Float4Array& since, Float4Array& previous,
                      Float4Array& current) const {
  for (const Touch& touch : touches_) {
    collide(touch, time, step, since, previous, current);
  }
  for (auto touch = touches_.rbegin(); touch != touches_.rend(); ++touch) {
    collide(*touch, time, step, since, previous, current);
  }
}

}  // namespace taut::sim::bounded
