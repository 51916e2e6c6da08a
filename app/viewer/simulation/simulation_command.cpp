#include "app/viewer/simulation/simulation_command.hpp"

namespace taut::app {
namespace {

// Of cloth between the fingers. Smaller pulls the cloth out to a point, larger lifts a plate.
constexpr double reach_m = 0.03;
// How fast a garment on the hand's spring alone would swing, in rad/s. Higher follows the cursor closer and
// jerks harder.
constexpr double swing_rad_per_s = 60.0;
// In weights of the garment on Earth. More pulls a pinned garment harder against its stretch bound.
constexpr double strength = 5.0;
constexpr double earth_m_per_s2 = 9.81;
constexpr double arm_speed_m_per_s = 4.0;

// A coarse mesh has no neighbour within reach: then the nearest ones help.
double reach_around(const sim::Garment& garment, sim::Index vertex) {
  double shortest_m = reach_m;
  for (const sim::Index e : garment.adjacency.vertex_edges[vertex]) {
    const sim::Index other = sim::other_end(garment.adjacency.edges[e], vertex);
    const double length_m = glm::distance(garment.mesh.positions[vertex], garment.mesh.positions[other]);
    shortest_m = std::max(shortest_m, 1.05 * length_m);
  }
  return shortest_m;
}

}  // namespace

Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex) {
  const double reach = reach_around(garment, vertex);
  Grip grip;
  grip.target_m = positions[vertex];
  std::vector<sim::Index> found = {vertex};
  std::vector<bool> seen(positions.size(), false);
  seen[vertex] = true;
  double total = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const sim::Index at = found[i];
    const double distance_m = glm::distance(garment.mesh.positions[at], garment.mesh.positions[vertex]);
    const double weight = garment.masses_kg[at] * (1.0 - distance_m / reach);
    grip.vertices.push_back({at, weight, positions[at] - positions[vertex]});
    total += weight;
    for (const sim::Index e : garment.adjacency.vertex_edges[at]) {
      const sim::Index next = sim::other_end(garment.adjacency.edges[e], at);
      if (!seen[next] &&
          glm::distance(garment.mesh.positions[next], garment.mesh.positions[vertex]) < reach) {
        seen[next] = true;
        found.push_back(next);
      }
    }
  }
  for (GripVertex& held : grip.vertices) held.share = total > 0.0 ? held.share / total : 0.0;
  return grip;
}

std::vector<sim::HeldVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m,
                                           const sim::Garment& garment) {
  const double mass_kg = std::accumulate(garment.masses_kg.begin(), garment.masses_kg.end(), 0.0);
  const double stiffness_n_per_m = mass_kg * swing_rad_per_s * swing_rad_per_s;
  const double force_n = strength * mass_kg * earth_m_per_s2;
  std::vector<sim::HeldVertex> held;
  held.reserve(grip.vertices.size());
  for (const GripVertex& part : grip.vertices) {
    held.push_back(
        {part.vertex, hand_m + part.offset_m, stiffness_n_per_m * part.share, force_n * part.share});
  }
  return held;
}

sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s) {
  const sim::Vec3 way = target_m - hand_m;
  const double length_m = glm::length(way);
  const double reachable_m = arm_speed_m_per_s * time_s;
  return length_m <= reachable_m ? target_m : hand_m + way * (reachable_m / length_m);
}

}  // namespace taut::app
