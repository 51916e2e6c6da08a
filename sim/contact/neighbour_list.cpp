#include "sim/contact/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace taut::sim {
namespace {

/// The skin as a multiple of the thickness. A larger value makes longer lists that are rebuilt less often.
/// Most close pairs are of the same layer, so longer lists cost more than they save.
constexpr double skin_per_thickness = 0.35;

/// Larger cell indices would not fit into 64 bits.
constexpr double largest_cell_index = 9e18;

using Cell = std::array<std::uint64_t, 3>;

/// Returns the cell of a position. Along every axis the cells repeat after `cells_per_axis`, a power of two.
Cell cell_of(const Vec3& position, double cell_m, std::uint64_t cells_per_axis) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double index = std::floor(position[axis] / cell_m);
    // Positions can be infinite or undefined while a simulation diverges, before that is noticed.
    const bool is_whole_number = std::abs(index) < largest_cell_index;
    cell[axis] = static_cast<std::uint64_t>(is_whole_number ? static_cast<std::int64_t>(index) : 0) &
                 (cells_per_axis - 1);
  }
  return cell;
}

/// Returns enough cells for at least two per vertex. At least four along an axis are needed so that the
/// neighbours of a cell are all different.
std::uint64_t enough_cells_per_axis(std::size_t vertex_count) {
  std::uint64_t cells_per_axis = 4;
  while (cells_per_axis * cells_per_axis * cells_per_axis < 2 * vertex_count) {
    cells_per_axis *= 2;
  }
  return cells_per_axis;
}

double squared_distance(const Vec3& a, const Vec3& b) {
  return glm::dot(a - b, a - b);
}

}  // namespace

bool NeighbourList::is_current(std::span<const Vec3> positions, double thickness_m) const {
  if (made_for_thickness_m_ != thickness_m || made_at_.size() != positions.size()) {
    return false;
  }
  const double far_m = skin_per_thickness * thickness_m / 2.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!(squared_distance(positions[v], made_at_[v]) < far_m * far_m)) {
      return false;
    }
  }
  return true;
}

void NeighbourList::sort_into_cells(double cell_m) {
  cells_per_axis_ = enough_cells_per_axis(made_at_.size());
  cell_begin_.assign(cells_per_axis_ * cells_per_axis_ * cells_per_axis_ + 1, 0);
  std::vector<std::size_t> cells;
  cells.reserve(made_at_.size());
  for (const Vec3& p : made_at_) {
    const auto [x, y, z] = cell_of(p, cell_m, cells_per_axis_);
    cells.push_back((z * cells_per_axis_ + y) * cells_per_axis_ + x);
    ++cell_begin_[cells.back() + 1];
  }
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  sorted_.resize(made_at_.size());
  sorted_positions_.resize(made_at_.size());
  std::vector<Index> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (Index v = 0; v < made_at_.size(); ++v) {
    const Index place = next[cells[v]]++;
    sorted_[place] = v;
    sorted_positions_[place] = made_at_[v];
  }
}

void NeighbourList::collect_pairs(std::span<const Vec3> rest_positions, double thickness_m, double reach_m) {
  pairs_.clear();
  const double cloth_neighbour_m = 2.0 * thickness_m;
  const std::uint64_t last = cells_per_axis_ - 1;
  for (Index v = 0; v < made_at_.size(); ++v) {
    const std::size_t first_of_v = pairs_.size();
    const Vec3 position = made_at_[v];
    const auto look_through = [&](std::size_t first_cell, std::size_t end_cell) {
      for (Index k = cell_begin_[first_cell]; k < cell_begin_[end_cell]; ++k) {
        const Index other = sorted_[k];
        if (other > v && squared_distance(position, sorted_positions_[k]) < reach_m * reach_m &&
            squared_distance(rest_positions[v], rest_positions[other]) >
                cloth_neighbour_m * cloth_neighbour_m) {
          pairs_.push_back({v, other});
        }
      }
    };
    const auto [x, y, z] = cell_of(position, reach_m, cells_per_axis_);
    for (std::uint64_t neighbour = 0; neighbour < 9; ++neighbour) {
      const std::uint64_t other_y = (y + neighbour % 3 - 1) & last;
      const std::uint64_t other_z = (z + neighbour / 3 - 1) & last;
      const std::size_t row = (other_z * cells_per_axis_ + other_y) * cells_per_axis_;
      // Three cells side by side; at either end of the axis one of them is at the other end.
      look_through(row + (x == 0 ? 0 : x - 1), row + std::min(x + 2, cells_per_axis_));
      if (x == 0) {
        look_through(row + last, row + last + 1);
      } else if (x == last) {
        look_through(row, row + 1);
      }
    }
    std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(first_of_v), pairs_.end());
  }
}

void NeighbourList::update(std::span<const Vec3> rest_positions, std::span<const Vec3> positions,
                           double thickness_m) {
  assert(rest_positions.size() == positions.size() && thickness_m > 0.0);
  if (is_current(positions, thickness_m)) {
    return;
  }
  made_at_.assign(positions.begin(), positions.end());
  make(rest_positions, thickness_m);
}

void NeighbourList::make(std::span<const Vec3> rest_positions, double thickness_m) {
  const double reach_m = (1.0 + skin_per_thickness) * thickness_m;
  made_for_thickness_m_ = thickness_m;
  sort_into_cells(reach_m);
  collect_pairs(rest_positions, thickness_m, reach_m);
}

void NeighbourList::save(ByteWriter& memory) const {
  memory.put(made_for_thickness_m_);
  memory.put_positions(made_at_);
}

void NeighbourList::restore(std::span<const Vec3> rest_positions, ByteReader& memory) {
  const double thickness_m = memory.get("the distance of layers", 0.0, std::numeric_limits<double>::max());
  made_at_ = memory.get_positions("where the layers were", thickness_m > 0.0 ? rest_positions.size() : 0);
  make(rest_positions, thickness_m);
}

}  // namespace taut::sim
