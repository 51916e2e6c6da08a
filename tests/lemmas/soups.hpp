#pragma once

#include <random>
#include <vector>

#include "sim/solvers/bounded/contact/regions.hpp"

namespace taut::sim::bounded {

/// How a soup is made.
struct SoupSettings {
  unsigned seed = 0;
  int cloth_triangles = 6;
  int body_triangles = 2;
  float thickness_m = 1e-3F;
  float move_m = 0.005F;    ///< of each coordinate of a vertex, at most
  float radius_m = 0.002F;  ///< of a ball, at most
  float from_origin_m = 0.1F;
  bool has_pins = true;
  bool has_normals = true;  ///< of the cloth
};

/// Triangles of cloth and of a body that cross nowhere, and how they are expected to move. Single ones and
/// strips; some corners of the cloth are pins.
struct Soup {
  RowMoves rows;
  std::vector<Triangle> cloth;
  std::vector<Triangle> body;
  float thickness_m = 0.0F;
};

Soup make_soup(const SoupSettings& settings);

/// Where its rows are, in m from the origin, at a part of the time: the cloth's by displacements, the body's
/// on their chords.
std::vector<Vec3> positions_of(const Soup& soup, double time, const Float4Array& displacements);

/// Returns how many pairs of triangles cross, but for those within the body. Exact (app/verify).
std::size_t crossings(const Soup& soup, const std::vector<Vec3>& positions_m);

/// Returns the shortest way from the second thing to the first, and its length, in m.
Vec3 between_m(const NearPair& near, const std::vector<Vec3>& positions_m);
double distance_m(const NearPair& near, const std::vector<Vec3>& positions_m);

/// Returns the pairs within reach of each other, see Regions::reach_m, on all their ways.
std::vector<ContactPair> pairs_within_reach(const Soup& soup);

}  // namespace taut::sim::bounded
