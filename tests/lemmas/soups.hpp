#pragma once

#include <random>
#include <vector>

#include "sim/solvers/bounded/contact/regions.hpp"

namespace taut::sim::bounded {

struct SoupSettings {
  unsigned seed = 0;
  int cloth_triangles = 6;
  int body_triangles = 2;
  float thickness_m = 1e-3F;
  float move_m = 0.005F;    ///< largest coordinate of a vertex's predicted motion
  float radius_m = 0.002F;  ///< largest radius of a trust region
  float from_origin_m = 0.1F;
  bool has_pins = true;
  bool has_normals = true;  ///< applies to the cloth
};

/// Triangles of cloth and of a body, single ones and strips, that cross nowhere, with their predicted motion. Some
/// corners of the cloth are pins.
struct Soup {
  RowMoves rows;
  std::vector<Triangle> cloth;
  std::vector<Triangle> body;
  float thickness_m = 0.0F;
};

Soup make_soup(const SoupSettings& settings);

/// Returns the positions in m from the origin at a part of the time: cloth is moved by `displacements`, the body along
/// its chords.
std::vector<Vec3> soup_positions(const Soup& soup, double time, const Float4Array& displacements);

/// Returns the exact number of crossing pairs of triangles (app/verify), except those within the body.
std::size_t crossings(const Soup& soup, const std::vector<Vec3>& positions_m);

/// Returns the shortest vector from the second primitive to the first, and its length, in m.
Vec3 between_m(const NearPair& near, const std::vector<Vec3>& positions_m);
double distance_m(const NearPair& near, const std::vector<Vec3>& positions_m);

/// Returns the pairs that come within reach of each other (Regions::reach_m) anywhere on their paths.
std::vector<ContactPair> pairs_within_reach(const Soup& soup);

}  // namespace taut::sim::bounded
