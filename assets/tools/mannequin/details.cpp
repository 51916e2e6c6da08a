#include "tailor/mannequin/details.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace taut::tailor {
namespace {

using sim::Index;
using sim::Triangle;

constexpr double longest = 4.0 / 3.0;  // times the target length
/// Width around a detail that has fine edges too.
constexpr double margin_m = 0.004;

/// Splits edges of both halves, so that they stay mirror images. `images`: the mirror image of each vertex, which is
/// the vertex itself at x = 0.
class Splitter {
 public:
  Splitter(const Shape& shape, sim::Mesh& mesh, std::vector<VertexWeights>& weights, std::vector<Index> images)
      : shape_(shape), mesh_(mesh), weights_(weights), images_(std::move(images)) {
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      add_sides(t);
    }
  }

  const std::vector<Index>& images() const { return images_; }

  void round() {
    const std::size_t before = mesh_.triangles.size();
    for (Index t = 0; t < before; ++t) {
      const auto [a, b] = longest_side(t);
      const Vec3 middle = 0.5 * (at(a) + at(b));
      if (middle.x >= 0.0 && glm::length(at(a) - at(b)) > longest * wanted_m(middle)) {
        split_longest(t);
      }
    }
  }

 private:
  using Side = std::pair<Index, Index>;

  const Vec3& at(Index v) const { return mesh_.positions[v]; }

  /// Returns a number that is the same for both sides of the body, so that both choose alike.
  Index number(Index v) const { return std::min(v, images_[v]); }

  double wanted_m(const Vec3& left) const {
    double wanted = 1.0;
    for (const Part& detail : shape_.details) {
      if (distance_m(shape_, detail, left) < margin_m) {
        wanted = std::min(wanted, detail.edge_m);
      }
    }
    return wanted;
  }

  void add_sides(Index t) {
    for (std::size_t k = 0; k < 3; ++k) {
      triangle_of_[{mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]}] = t;
    }
  }

  Side longest_side(Index t) const {
    std::tuple<double, Index, Index> best{-1.0, 0, 0};
    Side side;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh_.triangles[t][k];
      const Index b = mesh_.triangles[t][(k + 1) % 3];
      const auto [low, high] = std::minmax(number(a), number(b));
      const std::tuple<double, Index, Index> own{glm::length(at(a) - at(b)), low, high};
      if (own > best) {
        best = own;
        side = {a, b};
      }
    }
    return side;
  }

  // Splits only longest sides, neighbours' sides first (Rivara 1997), so that no angle becomes smaller than half of its
  // original.
  void split_longest(Index t) {
    const auto [a, b] = longest_side(t);
    const Index other = triangle_of_.at({b, a});
    const auto [c, d] = longest_side(other);
    if (c == b && d == a) {
      const Index middle = split(a, b);
      images_.push_back(middle);
      if (images_[a] != a || images_[b] != b) {
        images_.back() = static_cast<Index>(mesh_.positions.size());
        split(images_[a], images_[b]);
        images_.push_back(middle);
      }
    } else {
      split_longest(other);
    }
  }

  Index split(Index a, Index b) {
    const auto middle = static_cast<Index>(mesh_.positions.size());
    mesh_.positions.push_back(0.5 * (at(a) + at(b)));
    weights_.push_back(weights_[number(a) < number(b) ? a : b]);
    for (const Side& side : {Side{a, b}, Side{b, a}}) {
      const Index t = triangle_of_.at(side);
      Triangle first = mesh_.triangles[t];
      Triangle second = first;
      std::replace(first.begin(), first.end(), side.second, middle);
      std::replace(second.begin(), second.end(), side.first, middle);
      mesh_.triangles[t] = first;
      mesh_.triangles.push_back(second);
      triangle_of_.erase(side);
      add_sides(t);
      add_sides(static_cast<Index>(mesh_.triangles.size() - 1));
    }
    return middle;
  }

  const Shape& shape_;
  sim::Mesh& mesh_;
  std::vector<VertexWeights>& weights_;
  std::vector<Index> images_;
  std::map<Side, Index> triangle_of_;  // triangle that has the side in this direction
};

std::vector<Index> find_images(const FittedBody& fitted) {
  std::vector<Index> images(fitted.whole.positions.size());
  auto next = static_cast<Index>(fitted.half.positions.size());
  for (Index v = 0; v < fitted.half.positions.size(); ++v) {
    images[v] = fitted.half.positions[v].x == 0.0 ? v : next++;
    images[images[v]] = v;
  }
  return images;
}

/// Moves vertices to the surface of details and to the middle of their neighbours. Vertices from `first_new` on always
/// move.
void put_on(const Shape& shape, const Shape& detailed, const std::vector<Index>& images, Index first_new,
            sim::Mesh& mesh) {
  constexpr double unmoved_m = 2e-4;
  std::vector<Vec3> sums(mesh.positions.size(), Vec3(0.0));
  std::vector<double> counts(mesh.positions.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sums[t[k]] += mesh.positions[t[(k + 1) % 3]];
      counts[t[k]] += 1.0;
    }
  }
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    Vec3 p = mesh.positions[v];
    const double off_m = std::max(std::abs(distance_m(shape, p)), std::abs(distance_m(detailed, p)));
    if (p.x < 0.0 || (v < first_new && off_m <= unmoved_m)) {
      continue;
    }
    const Vec3 mean = sums[v] / counts[v];
    p = 0.5 * (p + (images[v] == v ? Vec3(0.0, mean.y, mean.z) : mean));
    p = on_surface(detailed, p);
    mesh.positions[v] = p;
    mesh.positions[images[v]] = images[v] == v ? p : Vec3(-p.x, p.y, p.z);
  }
}

}  // namespace

void add_details(const Shape& shape, FittedBody& fitted, std::vector<VertexWeights>& weights) {
  const Shape detailed = with_details(shape);
  const auto first_new = static_cast<Index>(fitted.whole.positions.size());
  Splitter splitter(shape, fitted.whole, weights, find_images(fitted));
  for (int i = 0; i < 8; ++i) {
    splitter.round();
    put_on(shape, detailed, splitter.images(), first_new, fitted.whole);
  }
}

}  // namespace taut::tailor
