#include "sim/contact/triangle_tree.hpp"

#include <hwy/highway.h>

#include <bit>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Bound of a missing triangle: its box overlaps none, not even an infinite one.
constexpr float no_bound = std::numeric_limits<float>::quiet_NaN();
/// Largest error of rounding to single precision, as a fraction of the largest coordinate.
constexpr double rounding = 1e-6;
/// Largest number of triangles at a vertex that are known as neighbours. Where more meet, each pair is looked at.
constexpr std::size_t max_known_neighbours = 32;

bool share_vertex(const Triangle& s, const Triangle& t) {
  const auto has = [&](Index v) { return t[0] == v || t[1] == v || t[2] == v; };
  return has(s[0]) || has(s[1]) || has(s[2]);
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles, std::span<const Vec3> positions_m)
    : order_(triangles.size()) {
  assert(are_below(triangles, positions_m.size()));
  std::vector<Vec3> middles_m;
  for (const Triangle& t : triangles) {
    middles_m.push_back((positions_m[t[0]] + positions_m[t[1]] + positions_m[t[2]]) / 3.0);
  }
  std::iota(order_.begin(), order_.end(), 0U);
  order(0, order_.size(), middles_m);
  for (const Index t : order_) triangles_.push_back(triangles[t]);
  leaves_.resize((triangles.size() + lanes - 1) / lanes);
  places_.resize(triangles.size());
  boxes_.resize(2 * leaves_.size());
  exclude_neighbours(positions_m.size());
}

// Bits of a leaf and itself also leave out each triangle with itself, and each pair once.
void TriangleTree::exclude_neighbours(std::size_t vertices) {
  const CompressedRows places = at_vertices(vertices, triangles_);
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
    excluded_begin_.push_back(excluded_.size());
    excluded_.push_back({leaf, 0});
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      excluded_.back().bits |= ((std::uint64_t{2} << lane) - 1) << lane * lanes;
    }
    const std::size_t end = std::min((leaf + 1) * lanes, triangles_.size());
    for (std::size_t place = leaf * lanes; place < end; ++place) {
      for (const Index vertex : triangles_[place]) {
        const std::span<const Index> others = places[vertex];
        if (others.size() > max_known_neighbours) continue;
        for (const Index other : others) exclude(place, other);
      }
    }
  }
  excluded_begin_.push_back(excluded_.size());
}

void TriangleTree::exclude(std::size_t place, std::size_t other) {
  const std::size_t leaf = other / lanes;
  auto at = std::find_if(excluded_.begin() + static_cast<std::ptrdiff_t>(excluded_begin_.back()), excluded_.end(),
                         [&](const ExcludedLanes& lanes_of) { return lanes_of.other == leaf; });
  if (at == excluded_.end()) at = excluded_.insert(at, {leaf, 0});
  at->bits |= std::uint64_t{1} << (place % lanes * lanes + other % lanes);
}

std::uint64_t TriangleTree::excluded_between(std::size_t leaf, std::size_t other) const {
  const auto end = excluded_.begin() + static_cast<std::ptrdiff_t>(excluded_begin_[leaf + 1]);
  const auto at = std::find_if(excluded_.begin() + static_cast<std::ptrdiff_t>(excluded_begin_[leaf]), end,
                               [&](const ExcludedLanes& lanes_of) { return lanes_of.other == other; });
  return at == end ? 0 : at->bits;
}

// Splits into halves of whole leaves along the longest axis of the middles; the index breaks ties.
void TriangleTree::order(std::size_t begin, std::size_t end, std::span<const Vec3> middles_m) {
  assert(begin <= end && end <= order_.size());
  if (end - begin <= lanes) return;
  Extent extent;
  for (std::size_t i = begin; i < end; ++i) extent.add(middles_m[order_[i]]);
  const int axis = long_axis(extent);
  const auto is_before = [&](Index s, Index t) {
    return middles_m[s][axis] != middles_m[t][axis] ? middles_m[s][axis] < middles_m[t][axis] : s < t;
  };
  const std::size_t middle = begin + (end - begin + lanes - 1) / lanes / 2 * lanes;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), is_before);
  order(begin, middle, middles_m);
  order(middle, end, middles_m);
}

void TriangleTree::fit_leaf(std::size_t leaf, std::span<const std::array<float, 3>> corners) {
  Leaf& boxes = leaves_[leaf];
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t place = leaf * lanes + lane;
    if (place >= triangles_.size()) {
      for (int k = 0; k < 3; ++k) {
        boxes.lower[k][lane] = no_bound;
        boxes.upper[k][lane] = no_bound;
      }
      continue;
    }
    const auto& [i, j, l] = triangles_[place];
    TreeTriangle& of = places_[place];
    float* const rows[3] = {of.x, of.y, of.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const float a = corners[i][k], b = corners[j][k], c = corners[l][k];
      boxes.lower[k][lane] = std::min(a, std::min(b, c)) - 0.5F * reach_m_;
      boxes.upper[k][lane] = std::max(a, std::max(b, c)) + 0.5F * reach_m_;
      rows[k][0] = a;
      rows[k][1] = b;
      rows[k][2] = c;
      rows[k][3] = (a + b + c) * (1.0F / 3.0F);
    }
  }
}

std::uint32_t TriangleTree::find_overlaps(const Leaf& leaf, const TreeBox& box) {
  const hn::CappedTag<float, lanes> f;
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < lanes; k += hn::Lanes(f)) {
    const auto overlaps = [&](std::size_t axis) {
      return hn::And(hn::Le(hn::LoadU(f, &leaf.lower[axis][k]), hn::Set(f, box.upper[axis])),
                     hn::Le(hn::Set(f, box.lower[axis]), hn::LoadU(f, &leaf.upper[axis][k])));
    };
    std::uint8_t some = 0;
    hn::StoreMaskBits(f, hn::And(hn::And(overlaps(0), overlaps(1)), overlaps(2)), &some);
    bits |= std::uint32_t{some} << k;
  }
  return bits;
}

TriangleTree::TreeBox TriangleTree::fit(const TreeNode& node) {
  TreeBox box;
  if (node.size() == 1) {
    // The first lane is never missing, and no other number is less or greater than NaN.
    const Leaf& leaf = leaves_[node.begin];
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = *std::min_element(leaf.lower[k], leaf.lower[k] + lanes);
      box.upper[k] = *std::max_element(leaf.upper[k], leaf.upper[k] + lanes);
    }
  } else {
    const TreeBox first = fit(node.first()), second = fit(node.second());
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::min(first.lower[k], second.lower[k]);
      box.upper[k] = std::max(first.upper[k], second.upper[k]);
    }
  }
  return boxes_[node.at] = box;
}

void TriangleTree::fit(std::span<const Vec3> positions_m, const Vec3& origin_m, double reach_m) {
  assert(reach_m >= 0.0);
  assert(is_finite(origin_m));
  std::vector<std::array<float, 3>> corners(positions_m.size());
  float max_coordinate = 0.0F;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const Vec3 p = positions_m[v] - origin_m;
    corners[v] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    for (const float x : corners[v]) max_coordinate = std::max(max_coordinate, std::abs(x));
  }
  reach_m_ = static_cast<float>(reach_m + rounding * max_coordinate);
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) fit_leaf(leaf, corners);
  if (!leaves_.empty()) fit(root());
}

void TriangleTree::search_marked(std::span<const std::uint8_t> is_marked) {
  searched_.assign(boxes_.size(), 0);
  if (!leaves_.empty()) mark(root(), is_marked);
}

bool TriangleTree::mark(const TreeNode& node, std::span<const std::uint8_t> is_marked) {
  if (node.size() == 1) {
    for (std::size_t place = node.begin * lanes; place < std::min(node.end * lanes, order_.size()); ++place) {
      searched_[node.at] |= is_marked[order_[place]];
    }
  } else {
    const bool first = mark(node.first(), is_marked), second = mark(node.second(), is_marked);
    searched_[node.at] = first || second ? 1 : 0;
  }
  return searched_[node.at] != 0;
}

void TriangleTree::find_near(std::vector<TriangleCouple>& pairs) const {
  if (!leaves_.empty()) find_within(root(), pairs);
}

void TriangleTree::find_near(const TriangleTree& other, std::vector<TriangleCouple>& pairs) const {
  if (!leaves_.empty() && !other.leaves_.empty()) find_between(root(), other, other.root(), pairs);
}

void TriangleTree::find_within(const TreeNode& node, std::vector<TriangleCouple>& pairs) const {
  if (!may_search(node)) return;
  if (node.size() == 1) {
    compare(node, *this, node, pairs);
    return;
  }
  find_within(node.first(), pairs);
  find_within(node.second(), pairs);
  find_between(node.first(), *this, node.second(), pairs);
}

void TriangleTree::find_between(const TreeNode& node, const TriangleTree& other, const TreeNode& others,
                                std::vector<TriangleCouple>& pairs) const {
  if (!may_search(node) && (this != &other || !may_search(others))) return;
  const TreeBox& a = boxes_[node.at];
  const TreeBox& b = other.boxes_[others.at];
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return;
  }
  if (node.size() == 1 && others.size() == 1) {
    compare(node, other, others, pairs);
  } else if (node.size() >= others.size()) {
    find_between(node.first(), other, others, pairs);
    find_between(node.second(), other, others, pairs);
  } else {
    find_between(node, other, others.first(), pairs);
    find_between(node, other, others.second(), pairs);
  }
}

// Triangles meet only in the intersection of the boxes of both leaves.
void TriangleTree::compare(const TreeNode& node, const TriangleTree& other, const TreeNode& others,
                           std::vector<TriangleCouple>& pairs) const {
  const std::size_t leaf = node.begin;
  TreeBox both = boxes_[node.at];
  for (std::size_t k = 0; k < 3; ++k) {
    both.lower[k] = std::max(both.lower[k], other.boxes_[others.at].lower[k]);
    both.upper[k] = std::min(both.upper[k], other.boxes_[others.at].upper[k]);
  }
  const Leaf& a = leaves_[leaf];
  const Leaf& b = other.leaves_[others.begin];
  std::uint32_t meets = find_overlaps(a, both);
  const std::uint32_t others_meet = meets == 0 ? 0 : find_overlaps(b, both);
  if (others_meet == 0) return;
  const bool is_within = this == &other;
  const std::uint64_t excluded = is_within ? excluded_between(leaf, others.begin) : 0;
  for (; meets != 0; meets &= meets - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(meets));
    const std::size_t s = leaf * lanes + i;
    std::uint32_t is_near = others_meet & ~static_cast<std::uint32_t>(excluded >> i * lanes);
    if (is_near == 0) continue;
    is_near &= find_overlaps(
        b, {{a.lower[0][i], a.lower[1][i], a.lower[2][i]}, {a.upper[0][i], a.upper[1][i], a.upper[2][i]}});
    for (; is_near != 0; is_near &= is_near - 1) {
      const std::size_t t = others.begin * lanes + static_cast<std::size_t>(std::countr_zero(is_near));
      if (!(is_within && share_vertex(triangles_[s], other.triangles_[t])) && may_be_near(s, other, t)) {
        pairs.push_back({order_[s], other.order_[t]});
      }
    }
  }
}

// False if a plane at right angles to the line between their means separates them by the reach.
bool TriangleTree::may_be_near(std::size_t place, const TriangleTree& other, std::size_t others) const {
  const TreeTriangle& s = places_[place];
  const TreeTriangle& t = other.places_[others];
  const float x = t.x[3] - s.x[3], y = t.y[3] - s.y[3], z = t.z[3] - s.z[3];
  std::array<float, 4> of_s, of_t;
  for (std::size_t k = 0; k < 4; ++k) {
    of_s[k] = x * s.x[k] + y * s.y[k] + z * s.z[k];
    of_t[k] = x * t.x[k] + y * t.y[k] + z * t.z[k];
  }
  const float apart = std::min(of_t[0], std::min(of_t[1], of_t[2])) - std::max(of_s[0], std::max(of_s[1], of_s[2]));
  const float reach_m = std::max(reach_m_, other.reach_m_);
  return !(apart > 0.0F && apart * apart > reach_m * reach_m * (x * x + y * y + z * z));
}

}  // namespace taut::sim
