#include "tailor/mannequin/polygonise.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace taut::tailor {
namespace {

using sim::Index;

/// Corners of a cell's six tetrahedra, all around the diagonal from corner 0 to corner 7. A corner's bits are x, y, z.
constexpr std::array<std::array<int, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marching {
 public:
  Marching(const Shape& shape, const Vec3& low_m, const Vec3& high_m, double cell_m)
      : low_m_(low_m), cell_m_(cell_m) {
    for (int axis = 0; axis < 3; ++axis) {
      nodes_[axis] = static_cast<std::size_t>((high_m[axis] - low_m[axis]) / cell_m) + 2;
    }
    values_.resize(nodes_[0] * nodes_[1] * nodes_[2]);
    for (std::size_t node = 0; node < values_.size(); ++node) {
      const double value = distance_m(shape, place(node));
      // A surface through a node would give triangles without area.
      values_[node] = std::abs(value) < 1e-6 ? 1e-6 : value;
    }
  }

  sim::Mesh march() {
    for (std::size_t z = 0; z + 1 < nodes_[2]; ++z) {
      for (std::size_t y = 0; y + 1 < nodes_[1]; ++y) {
        for (std::size_t x = 0; x + 1 < nodes_[0]; ++x) {
          march_cell(x, y, z);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  Vec3 place(std::size_t node) const {
    const auto x = node % nodes_[0];
    const auto y = node / nodes_[0] % nodes_[1];
    const auto z = node / nodes_[0] / nodes_[1];
    return low_m_ + cell_m_ * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }

  void march_cell(std::size_t x, std::size_t y, std::size_t z) {
    std::array<std::size_t, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) {
      corners[c] = ((z + (c >> 2)) * nodes_[1] + y + (c >> 1 & 1)) * nodes_[0] + x + (c & 1);
    }
    for (const auto& tetrahedron : tetrahedra) {
      std::vector<std::size_t> in;
      std::vector<std::size_t> out;
      for (const int corner : tetrahedron) {
        const std::size_t node = corners[static_cast<std::size_t>(corner)];
        (values_[node] < 0.0 ? in : out).push_back(node);
      }
      cut(in, out);
    }
  }

  void cut(const std::vector<std::size_t>& in, const std::vector<std::size_t>& out) {
    if (in.empty() || out.empty()) {
      return;
    }
    const Vec3 outward = place(out[0]) - place(in[0]);
    // Separate statements number new vertices in an order that no compiler chooses.
    if (in.size() == 2) {
      const Index c = crossing(in[1], out[1]);
      const Index b = crossing(in[1], out[0]);
      const Index a = crossing(in[0], out[0]);
      add(a, b, c, outward);
      add(a, c, crossing(in[0], out[1]), outward);
    } else {
      const bool one_in = in.size() == 1;
      const Index c = one_in ? crossing(in[0], out[2]) : crossing(in[2], out[0]);
      const Index b = one_in ? crossing(in[0], out[1]) : crossing(in[1], out[0]);
      add(crossing(in[0], out[0]), b, c, outward);
    }
  }

  void add(Index a, Index b, Index c, const Vec3& outward) {
    const auto& p = mesh_.positions;
    const bool faces_out = glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), outward) > 0.0;
    mesh_.triangles.push_back(faces_out ? sim::Triangle{a, b, c} : sim::Triangle{a, c, b});
  }

  Index crossing(std::size_t in, std::size_t out) {
    const auto [entry, is_new] = vertices_.try_emplace(std::minmax(in, out), mesh_.positions.size());
    if (is_new) {
      const double share = std::clamp(values_[in] / (values_[in] - values_[out]), 0.02, 0.98);
      mesh_.positions.push_back(place(in) + share * (place(out) - place(in)));
    }
    return entry->second;
  }

  Vec3 low_m_;
  double cell_m_;
  std::array<std::size_t, 3> nodes_{};
  std::vector<double> values_;
  std::map<std::pair<std::size_t, std::size_t>, Index> vertices_;
  sim::Mesh mesh_;
};

}  // namespace

sim::Mesh polygonise_left_half(const Shape& shape, const Vec3& low_m, const Vec3& high_m, double cell_m) {
  return Marching(shape, low_m, high_m, cell_m).march();
}

sim::Mesh with_mirror_image(const sim::Mesh& half) {
  sim::Mesh whole = half;
  std::vector<Index> image(half.positions.size());
  for (Index v = 0; v < half.positions.size(); ++v) {
    const Vec3& p = half.positions[v];
    image[v] = v;
    if (p.x != 0.0) {
      image[v] = static_cast<Index>(whole.positions.size());
      whole.positions.emplace_back(-p.x, p.y, p.z);
    }
  }
  for (const sim::Triangle& t : half.triangles) {
    whole.triangles.push_back({image[t[0]], image[t[2]], image[t[1]]});
  }
  return whole;
}

}  // namespace taut::tailor
