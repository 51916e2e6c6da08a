#include "sim/contact/triangle_tree.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Bound of a missing triangle: its box overlaps none, not even an infinite one.
constexpr float no_bound = std::numeric_limits<float>::quiet_NaN();
/// Largest error of rounding to single precision, as a fraction of the largest coordinate.
constexpr double rounding = 1e-6;

template <std::size_t count> bool is_any_set(const std::array<int, count>& flags) {
  int any = 0;
  for (const int flag : flags) any |= flag;
  return any != 0;
}

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

std::array<int, TriangleTree::lanes> TriangleTree::find_overlaps(const Leaf& leaf, const TreeBox& box) {
  std::array<int, lanes> meets;
  for (std::size_t k = 0; k < lanes; ++k) {
    meets[k] = static_cast<int>(leaf.lower[0][k] <= box.upper[0]) & static_cast<int>(box.lower[0] <= leaf.upper[0][k]) &
               static_cast<int>(leaf.lower[1][k] <= box.upper[1]) & static_cast<int>(box.lower[1] <= leaf.upper[1][k]) &
               static_cast<int>(leaf.lower[2][k] <= box.upper[2]) & static_cast<int>(box.lower[2] <= leaf.upper[2][k]);
  }
  return meets;
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

void TriangleTree::find_near(std::vector<TriangleCouple>& pairs) const {
  if (!leaves_.empty()) find_within(root(), pairs);
}

void TriangleTree::find_near(const TriangleTree& other, std::vector<TriangleCouple>& pairs) const {
  if (!leaves_.empty() && !other.leaves_.empty()) find_between(root(), other, other.root(), pairs);
}

void TriangleTree::find_within(const TreeNode& node, std::vector<TriangleCouple>& pairs) const {
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
  const bool is_within = this == &other;
  const std::array<int, lanes> meets = find_overlaps(a, both);
  if (!is_any_set(meets) || !is_any_set(find_overlaps(b, both))) return;
  for (std::size_t i = 0; i < lanes; ++i) {
    if (meets[i] == 0) continue;
    const std::array<int, lanes> is_near = find_overlaps(
        b, {{a.lower[0][i], a.lower[1][i], a.lower[2][i]}, {a.upper[0][i], a.upper[1][i], a.upper[2][i]}});
    if (!is_any_set(is_near)) continue;
    const std::size_t s = leaf * lanes + i;
    for (std::size_t j = is_within && leaf == others.begin ? i + 1 : 0; j < lanes; ++j) {
      const std::size_t t = others.begin * lanes + j;
      if (is_near[j] != 0 && !(is_within && share_vertex(triangles_[s], other.triangles_[t])) &&
          may_be_near(s, other, t)) {
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
