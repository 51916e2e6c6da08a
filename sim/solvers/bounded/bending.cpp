#include "sim/solvers/bounded/bending.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/solvers/bounded/coarse_cloth.hpp"
#include "sim/solvers/bounded/flexural.hpp"

namespace taut::sim::bounded {
namespace {

/// An element alone is slower than the fastest wave of all together, by about this factor.
constexpr double wave_per_element = 2.2;
constexpr double least_share = 0.01;
constexpr std::size_t most_levels = 8;
/// So few have no folds to tell from ripples, and cost next to nothing however often they are evaluated.
constexpr std::size_t fewest_clusters = 100;
/// The coarsest level takes what is left, but for needles: this many times the rate of other levels.
constexpr double coarsest_rate = 10.0;

/// The square of the angular frequency of one element alone.
double squared_rate(const FlexuralElement& e, double stiffness, const Garment& garment) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += garment.inverse_masses_per_kg[e.vertices[k]] * e.weights[k] * e.weights[k];
  }
  return stiffness * sum;
}

struct Entry {
  Index row;
  Index column;
  double value;
};

/// Sums entries of the same place; the result is in the order of rows, then columns.
std::vector<Entry> summed(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::vector<Entry> sums;
  for (const Entry& e : entries) {
    if (!sums.empty() && sums.back().row == e.row && sums.back().column == e.column) {
      sums.back().value += e.value;
    } else {
      sums.push_back(e);
    }
  }
  return sums;
}

/// What one level of detail takes on, and what it leaves.
struct Taken {
  std::vector<Entry> stiffness;     ///< K, by rows
  std::vector<double> left_shares;  ///< by vertex, of the rigidity
};

/// `shares` is what of the rigidity is this level's to take, by vertex.
Taken take_stiffness(const Garment& garment, const std::vector<Index>& row_of_vertex,
                     const std::vector<double>& shares, double rigidity_n_m, double largest_rate_per_s) {
  const double stiffest = largest_rate_per_s / wave_per_element;
  std::vector<double> left(shares.size(), 0.0);
  std::vector<double> whole(shares.size(), 0.0);
  std::vector<Entry> entries;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    const Index v = e.vertices[2];
    double k = shares[v] * rigidity_n_m * e.stiffness_per_rigidity;
    const double rate2 = squared_rate(e, k, garment);
    const double softened = rate2 > stiffest * stiffest ? stiffest * stiffest / rate2 : 1.0;
    whole[v] += e.stiffness_per_rigidity;
    left[v] += e.stiffness_per_rigidity * (1.0 - softened);
    k *= softened;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q) {
        const double value = k * e.weights[p] * e.weights[q];
        if (value != 0.0) {
          entries.push_back({row_of_vertex[e.vertices[p]], row_of_vertex[e.vertices[q]], value});
        }
      }
    }
  }
  for (std::size_t v = 0; v < left.size(); ++v) {
    left[v] = whole[v] > 0.0 ? shares[v] * left[v] / whole[v] : 0.0;
  }
  return {summed(std::move(entries)), std::move(left)};
}

RowMatrix acceleration_matrix(const std::vector<Entry>& stiffness,
                              const std::vector<double>& inverse_masses_per_kg) {
  RowMatrix matrix;
  matrix.begin.push_back(0);
  auto e = stiffness.begin();
  for (Index row = 0; row < inverse_masses_per_kg.size(); ++row) {
    const double w = inverse_masses_per_kg[row];
    for (; e != stiffness.end() && e->row == row; ++e) {
      if (w > 0.0 && e->column != row) {
        matrix.column.push_back(e->column);
        matrix.value.push_back(static_cast<float>(-w * e->value));
      }
    }
    if (matrix.column.size() % 2 == 1) {
      matrix.column.push_back(row);
      matrix.value.push_back(0.0F);
    }
    matrix.begin.push_back(static_cast<std::uint32_t>(matrix.column.size()));
  }
  return matrix;
}

/// The square root of the largest eigenvalue of W K. The power method comes from below, and is close after a
/// few steps, as the highest modes are many and alike; the sum of a row's absolute values is never below
/// (Gershgorin 1931).
double largest_rate(const std::vector<Entry>& stiffness, const std::vector<double>& inverse_masses_per_kg) {
  constexpr int steps = 24;
  constexpr double margin = 1.15;
  const std::size_t count = inverse_masses_per_kg.size();
  std::vector<double> mode(count);
  std::vector<double> image(count);
  std::vector<double> row_sums(count, 0.0);
  for (std::size_t row = 0; row < count; ++row) {
    mode[row] = row % 2 == 0 ? 1.0 : -0.7;
  }
  double eigenvalue = 0.0;
  for (int step = 0; step < steps; ++step) {
    std::fill(image.begin(), image.end(), 0.0);
    for (const Entry& e : stiffness) {
      image[e.row] += inverse_masses_per_kg[e.row] * e.value * mode[e.column];
    }
    const double largest = std::abs(*std::max_element(
        image.begin(), image.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (!(largest > 0.0)) {
      break;
    }
    eigenvalue = largest;
    for (std::size_t row = 0; row < count; ++row) {
      mode[row] = image[row] / largest;
    }
  }
  for (const Entry& e : stiffness) {
    row_sums[e.row] += inverse_masses_per_kg[e.row] * std::abs(e.value);
  }
  const double never_below = row_sums.empty() ? 0.0 : *std::max_element(row_sums.begin(), row_sums.end());
  return std::sqrt(std::min(never_below, margin * eigenvalue));
}

/// The mean over each cluster's mass of what is left to its vertices.
std::vector<double> shares_of_clusters(const CoarseCloth& coarse, const std::vector<double>& left) {
  std::vector<double> shares(coarse.garment.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < left.size(); ++v) {
    shares[coarse.cluster_of[v]] += coarse.part_of_mass[v] * left[v];
  }
  return shares;
}

template <typename T, typename U>
std::vector<T> by_row(const std::vector<U>& by_vertex, const std::vector<Index>& vertex_of_row) {
  std::vector<T> rows;
  rows.reserve(by_vertex.size());
  for (const Index v : vertex_of_row) {
    rows.push_back(static_cast<T>(by_vertex[v]));
  }
  return rows;
}

std::vector<Index> in_order(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

}  // namespace

Bending::Bending(const Garment& garment, const Layout& layout, double rigidity_n_m, double largest_rate_per_s)
    : first_free_row_(layout.pin_count), row_count_(layout.vertex_count()) {
  if (!(rigidity_n_m > 0.0)) {
    return;
  }
  const auto take = [&](const Garment& from, const std::vector<Index>& row_of_vertex,
                        const std::vector<Index>& vertex_of_row, const std::vector<double>& shares) {
    const bool is_coarsest = levels_.size() + 1 == most_levels || shares.size() < 4 * fewest_clusters;
    const double rate_per_s = largest_rate_per_s * (is_coarsest ? coarsest_rate : 1.0);
    Taken taken = take_stiffness(from, row_of_vertex, shares, rigidity_n_m, rate_per_s);
    const auto inverse_masses = by_row<double>(from.inverse_masses_per_kg, vertex_of_row);
    levels_.emplace_back();
    levels_.back().matrix = acceleration_matrix(taken.stiffness, inverse_masses);
    levels_.back().largest_rate_per_s = largest_rate(taken.stiffness, inverse_masses);
    return is_coarsest ? std::vector<double>(shares.size(), 0.0) : std::move(taken.left_shares);
  };

  std::vector<Index> order = layout.vertex_of_row;
  std::vector<double> left = take(garment, layout.row_of_vertex, order, std::vector<double>(row_count_, 1.0));
  CoarseCloth coarse;
  while (*std::max_element(left.begin(), left.end()) > least_share) {
    coarse = coarsen(levels_.size() == 1 ? garment : coarse.garment, order);
    const std::vector<double> shares = shares_of_clusters(coarse, left);
    const auto cluster_of = by_row<std::uint32_t>(coarse.cluster_of, order);
    const auto part_of_mass = by_row<float>(coarse.part_of_mass, order);
    order = in_order(shares.size());
    left = take(coarse.garment, order, order, shares);
    Level& level = levels_.back();
    level.cluster_of = cluster_of;
    level.part_of_mass = part_of_mass;
    level.positions.resize(shares.size());
    level.accelerations.resize(shares.size());
  }
}

double Bending::largest_rate_per_s() const {
  double squared = 0.0;
  for (const Level& level : levels_) {
    squared += level.largest_rate_per_s * level.largest_rate_per_s;
  }
  return std::sqrt(squared);
}

void Bending::add_accelerations(const Rows& positions, Loops& loops, Rows& accelerations) {
  const Row* finer = positions.data();
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    std::fill(level.positions.begin(), level.positions.end(), Row{});
    std::fill(level.accelerations.begin(), level.accelerations.end(), Row{});
    for (std::size_t row = 0; row < level.cluster_of.size(); ++row) {
      add_scaled(level.positions[level.cluster_of[row]], finer[row], level.part_of_mass[row]);
    }
    loops.add_product(level.matrix, 0, level.positions.size(), level.positions.data(),
                      level.accelerations.data());
    finer = level.positions.data();
  }
  for (std::size_t l = levels_.size(); l-- > 1;) {
    const Level& level = levels_[l];
    Rows& onto = l == 1 ? accelerations : levels_[l - 1].accelerations;
    for (std::size_t row = l == 1 ? first_free_row_ : 0; row < level.cluster_of.size(); ++row) {
      add_scaled(onto[row], level.accelerations[level.cluster_of[row]], 1.0F);
    }
  }
  loops.add_product(levels_[0].matrix, first_free_row_, row_count_, positions.data(), accelerations.data());
}

}  // namespace taut::sim::bounded
