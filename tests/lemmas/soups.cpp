#include "soups.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/verify/crossing_pairs.hpp"
#include "sim/solvers/bounded/contact/contact_mesh.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float min_gap_m = 2e-6F;

Float4 some_vector(std::mt19937& random, float size) {
  std::uniform_real_distribution<float> number(-size, size);
  const float x = number(random);
  const float y = number(random);
  return {x, y, number(random), 0.0F};
}

/// Returns all pairs of the soup without a common vertex, except those within the body.
std::vector<NearPair> all_pairs(const Soup& soup) {
  const ContactMesh mesh = make_contact_mesh(soup.cloth, soup.body);
  std::vector<NearPair> pairs;
  const auto add = [&](const std::array<Index, 4>& rows, Index first_count) {
    const auto shares = [&](Index k, Index l) { return rows[k] == rows[l]; };
    for (Index k = 0; k < first_count; ++k) {
      for (Index l = first_count; l < 4; ++l) {
        if (shares(k, l)) {
          return;
        }
      }
    }
    pairs.push_back({rows, first_count});
  };
  const auto add_vertices = [&](const Primitives& vertices, const Primitives& triangles) {
    for (const auto& [v] : vertices.vertices) {
      for (const Triangle& t : triangles.triangles) {
        add({v, t[0], t[1], t[2]}, 1);
      }
    }
  };
  add_vertices(mesh.cloth, mesh.cloth);
  add_vertices(mesh.cloth, mesh.bodies);
  add_vertices(mesh.bodies, mesh.cloth);
  std::vector<Edge> edges = mesh.cloth.edges;
  edges.insert(edges.end(), mesh.bodies.edges.begin(), mesh.bodies.edges.end());
  for (std::size_t i = 0; i < mesh.cloth.edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      add({edges[i][0], edges[i][1], edges[j][0], edges[j][1]}, 2);
    }
  }
  return pairs;
}

bool is_apart(const Soup& soup) {
  const std::vector<Vec3> positions_m = soup_positions(soup, 0.0, soup.rows.positions);
  const std::vector<NearPair> pairs = all_pairs(soup);
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const NearPair& near) { return distance_m(near, positions_m) > min_gap_m; }) &&
         crossings(soup, positions_m) == 0;
}

Index add_row(const Float4& position, const Float4& move, float radius, float inverse_mass, RowMoves& rows) {
  rows.positions.push_back(position);
  rows.moves.push_back(move);
  rows.radii.push_back(radius);
  rows.inverse_masses_per_kg.push_back(inverse_mass);
  return static_cast<Index>(rows.radii.size() - 1);
}

/// Adds a triangle, which shares an edge with the last one in half of all cases.
void add_triangle(const SoupSettings& settings, bool is_body, std::mt19937& random, Soup& soup) {
  std::uniform_real_distribution<float> part(0.0F, 1.0F);
  std::vector<Triangle>& triangles = is_body ? soup.body : soup.cloth;
  const bool goes_on = !triangles.empty() && part(random) < 0.5F;
  const Float4 centre = goes_on ? soup.rows.positions[triangles.back()[2]] : some_vector(random, 0.012F);
  Triangle t{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (goes_on && k < 2) {
      t[k] = triangles.back()[k + 1];
      continue;
    }
    const Float4 position = scaled_sum(centre, some_vector(random, 0.01F), 1.0F);
    const bool is_free = !is_body && !(settings.has_pins && part(random) < 0.1F);
    t[k] = add_row(position, some_vector(random, is_free ? settings.move_m : 0.2F * settings.move_m),
                   is_free ? settings.radius_m * part(random) : 0.0F, is_free ? 1e4F * (1.0F + part(random)) : 0.0F,
                   soup.rows);
  }
  triangles.push_back(t);
}

void add_where_apart(const SoupSettings& settings, bool is_body, std::mt19937& random, Soup& soup) {
  constexpr int max_tries = 20;
  for (int k = 0; k < max_tries; ++k) {
    const Soup before = soup;
    add_triangle(settings, is_body, random, soup);
    if (is_apart(soup)) {
      return;
    }
    soup = before;
  }
}

}  // namespace

Soup make_soup(const SoupSettings& settings) {
  std::mt19937 random(settings.seed);
  Soup soup;
  soup.thickness_m = settings.thickness_m;
  for (int k = 0; k < settings.cloth_triangles; ++k) {
    add_where_apart(settings, false, random, soup);
  }
  while (soup.rows.radii.size() % block_size != 0) {
    add_row({}, {}, 0.0F, 0.0F, soup.rows);
  }
  soup.rows.cloth_count = soup.rows.radii.size();
  if (settings.has_normals) {
    soup.rows.normals.resize(soup.rows.cloth_count);
    add_normals(soup.cloth, soup.rows.positions, soup.rows.normals);
  }
  for (int k = 0; k < settings.body_triangles; ++k) {
    add_where_apart(settings, true, random, soup);
  }
  // Rounding may make the soup cross at this distance from the origin; the soup then stays near the origin.
  const RowMoves near = soup.rows;
  const Float4 away = some_vector(random, settings.from_origin_m);
  for (Float4& position : soup.rows.positions) {
    position = scaled_sum(position, away, 1.0F);
  }
  if (!is_apart(soup)) {
    soup.rows = near;
  }
  return soup;
}

std::vector<Vec3> soup_positions(const Soup& soup, double time, const Float4Array& displacements) {
  const RowMoves& rows = soup.rows;
  std::vector<Vec3> positions_m;
  for (std::size_t row = 0; row < rows.positions.size(); ++row) {
    const Vec3 moved =
        row < rows.cloth_count && time > 0.0 ? to_vec3(displacements[row]) : time * to_vec3(rows.moves[row]);
    positions_m.push_back(to_vec3(rows.positions[row]) + moved);
  }
  return positions_m;
}

std::size_t crossings(const Soup& soup, const std::vector<Vec3>& positions_m) {
  const sim::Surface cloth = {positions_m, soup.cloth};
  return app::crossing_pairs(cloth).size() +
         (soup.body.empty() ? 0 : app::crossing_pairs(cloth, {positions_m, soup.body}).size());
}

namespace {

const Vec3& shorter(const Vec3& a, const Vec3& b) { return glm::length(a) <= glm::length(b) ? a : b; }

/// Returns the shortest vector from the segment to p.
Vec3 from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double squared = glm::dot(b - a, b - a);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
  return p - (a + t * (b - a));
}

Vec3 from_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = glm::cross(b - a, c - a);
  const auto is_left_of = [&](const Vec3& from, const Vec3& to) {
    return glm::dot(glm::cross(normal, to - from), p - from) >= 0.0;
  };
  if (is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a) && glm::length(normal) > 0.0) {
    return glm::dot(normal, p - a) / glm::dot(normal, normal) * normal;
  }
  return shorter(from_segment(p, a, b), shorter(from_segment(p, b, c), from_segment(p, c, a)));
}

/// Returns the shortest vector from the second segment to the first.
Vec3 between_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 normal = glm::cross(b - a, d - c);
  const double squared = glm::dot(normal, normal);
  const double s = glm::dot(glm::cross(c - a, d - c), normal) / squared;
  const double t = glm::dot(glm::cross(c - a, b - a), normal) / squared;
  if (squared > 0.0 && s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
    return glm::dot(normal, a - c) / squared * normal;
  }
  return shorter(shorter(from_segment(a, c, d), from_segment(b, c, d)),
                 shorter(-from_segment(c, a, b), -from_segment(d, a, b)));
}

}  // namespace

Vec3 between_m(const NearPair& near, const std::vector<Vec3>& positions_m) {
  const auto p = [&](Index k) { return positions_m[near.rows[k]]; };
  return near.first_count == 1 ? from_triangle(p(0), p(1), p(2), p(3)) : between_segments(p(0), p(1), p(2), p(3));
}

double distance_m(const NearPair& near, const std::vector<Vec3>& positions_m) {
  return glm::length(between_m(near, positions_m));
}

std::vector<ContactPair> pairs_within_reach(const Soup& soup) {
  const std::vector<Vec3> positions_m = soup_positions(soup, 0.0, soup.rows.positions);
  std::vector<ContactPair> pairs;
  for (const NearPair& near : all_pairs(soup)) {
    std::array<double, 2> reach_m = {0.0, 0.0};
    for (Index k = 0; k < 4; ++k) {
      const Index row = near.rows[k];
      double& reach = reach_m[k < near.first_count ? 0 : 1];
      const float move_m = vector_length(soup.rows.moves[row]);
      const float error_m = distance_error_m({vector_length(soup.rows.positions[row]), 0.1F, move_m, 0.0F});
      reach = std::max<double>(reach, move_m + Regions::reach_m(soup.rows.radii[row], soup.thickness_m, error_m));
    }
    if (distance_m(near, positions_m) <= reach_m[0] + reach_m[1]) {
      pairs.push_back({near, soup.thickness_m, 0.3F});
    }
  }
  return pairs;
}

}  // namespace taut::sim::bounded
