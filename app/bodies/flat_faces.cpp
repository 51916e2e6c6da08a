#include "app/bodies/flat_faces.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using Places = std::vector<sim::Index>;

/// Several in a row need several rounds.
constexpr int most_rounds = 8;

bool is_flat(const sim::Mesh& soup, const sim::Triangle& t) {
  const sim::Vec3 area = sim::doubled_area_vector(soup.positions, t);
  return !(glm::dot(area, area) > 0.0);
}

/// The triangle with the corner first that its longest edge does not touch.
sim::Triangle from_middle(const sim::Mesh& soup, const sim::Triangle& t) {
  const auto across = [&](std::size_t k) {
    return glm::distance(soup.positions[t[(k + 1) % 3]], soup.positions[t[(k + 2) % 3]]);
  };
  const std::size_t k = across(0) >= across(1) && across(0) >= across(2) ? 0 : across(1) >= across(2) ? 1 : 2;
  return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
}

/// The triangles at each edge, by the places of its ends.
std::map<sim::Edge, std::vector<std::size_t>> triangles_of_edges(const sim::Mesh& soup,
                                                                 const Places& places) {
  std::map<sim::Edge, std::vector<std::size_t>> triangles;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const auto [low, high] = std::minmax(places[from], places[to]);
      triangles[{low, high}].push_back(t);
    }
  }
  return triangles;
}

/// Makes one vertex of the ends of each edge without length, and leaves out the triangles at it.
std::size_t left_out(const Places& places, sim::Mesh& soup) {
  sim::Groups same(soup.positions.size());
  for (const auto& [a, b, c] : soup.triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (places[from] == places[to]) {
        same.join(from, to);
      }
    }
  }
  for (sim::Triangle& t : soup.triangles) {
    t = {same.find(t[0]), same.find(t[1]), same.find(t[2])};
  }
  return std::erase_if(soup.triangles,
                       [](const sim::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

std::size_t turn_once(const Places& places, sim::Mesh& soup) {
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (is_flat(soup, soup.triangles[t])) {
      flat.push_back(t);
    }
  }
  if (flat.empty()) {
    return 0;
  }
  const auto triangles = triangles_of_edges(soup, places);
  std::vector<char> is_changed(soup.triangles.size(), 0);
  std::size_t turned = 0;
  for (const std::size_t t : flat) {
    const auto [middle, from, to] = from_middle(soup, soup.triangles[t]);
    const auto [low, high] = std::minmax(places[from], places[to]);
    const std::vector<std::size_t>& both = triangles.at({low, high});
    if (both.size() != 2 || is_changed[both[0]] || is_changed[both[1]]) {
      continue;
    }
    const std::size_t across = both[0] == t ? both[1] : both[0];
    const sim::Triangle& other = soup.triangles[across];
    const auto far = std::find_if(other.begin(), other.end(), [&, from = from, to = to](sim::Index v) {
      return places[v] != places[from] && places[v] != places[to];
    });
    if (far == other.end()) {
      continue;
    }
    const sim::Triangle first = {from, *far, middle};
    const sim::Triangle second = {*far, to, middle};
    if (is_flat(soup, first) && is_flat(soup, second)) {
      continue;
    }
    soup.triangles[t] = first;
    soup.triangles[across] = second;
    is_changed[t] = is_changed[across] = 1;
    ++turned;
  }
  return turned;
}

}  // namespace

FlatFaces mend_flat_faces(sim::Mesh& soup) {
  const Places places = sim::first_at_same_position(soup.positions);
  FlatFaces mended{left_out(places, soup), 0};
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t now = turn_once(places, soup);
    mended.turned += now;
    if (now == 0) {
      break;
    }
  }
  return mended;
}

}  // namespace taut::app
