#include "sim/solvers/bounded/bending.hpp"

#include "sim/solvers/bounded/coarse_cloth.hpp"
#include "sim/solvers/bounded/flexural.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// The highest rate is found by the power method with this many iterations: it is close because the highest
/// modes are many and similar.
constexpr int power_iterations = 40;

/// Returns the square of the angular frequency of one element alone, in 1/s^2.
double squared_rate(const FlexuralElement& e, double stiffness, const Pins& pins) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += pins.inverse_masses_per_kg[e.vertices[k]] * e.weights[k] * e.weights[k];
  }
  return stiffness * sum;
}

struct Entry {
  Index row;
  Index column;
  double value;
};

/// Sums the entries of the same row and column. The result is sorted by row, then column.
std::vector<Entry> summed(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
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

/// The part of the bending that one level takes, and the part that it leaves to the next.
struct Taken {
  std::vector<Entry> stiffness;     ///< K, by rows
  std::vector<double> left_shares;  ///< by vertex, of the rigidity
};

/// `shares` holds, per vertex, the fraction of the rigidity that this level should take.
Taken take_stiffness(const Garment& garment, const Pins& pins, const std::vector<Index>& row_of_vertex,
                     const std::vector<double>& shares, double rigidity_n_m, double stiffest) {
  std::vector<double> left(shares.size(), 0.0);
  std::vector<double> whole(shares.size(), 0.0);
  std::vector<Entry> entries;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    const Index v = e.vertices[2];
    double k = shares[v] * rigidity_n_m * e.stiffness_per_rigidity;
    const double rate2 = squared_rate(e, k, pins);
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

/// -W K by rows.
std::vector<std::vector<MatrixEntry>> acceleration_rows(const std::vector<Entry>& stiffness,
                                                        const std::vector<double>& inverse_masses_per_kg) {
  std::vector<std::vector<MatrixEntry>> rows(inverse_masses_per_kg.size());
  for (const Entry& e : stiffness) {
    const double w = inverse_masses_per_kg[e.row];
    if (w > 0.0 && e.column != e.row) rows[e.row].push_back({e.column, -w * e.value});
  }
  return rows;
}

/// Returns, per cluster, the mean of what is left to its vertices, weighted by mass.
std::vector<double> shares_of_clusters(const CoarseCloth& coarse, const std::vector<double>& left) {
  std::vector<double> shares(coarse.garment.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < left.size(); ++v) {
    shares[coarse.cluster_of[v]] += coarse.mass_fraction[v] * left[v];
  }
  return shares;
}

template <typename T, typename U>
std::vector<T> by_row(const std::vector<U>& by_vertex, const std::vector<Index>& vertex_of_row) {
  std::vector<T> rows;
  rows.reserve(by_vertex.size());
  for (const Index v : vertex_of_row) rows.push_back(static_cast<T>(by_vertex[v]));
  return rows;
}

std::vector<Index> in_order(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

}  // namespace

Bending::Bending(const Garment& garment, const Pins& pins, const Layout& layout, double rigidity_n_m,
                 double fastest_element_per_s)
    : first_free_row_(layout.pin_count), row_count_(layout.vertex_count()) {
  if (!(rigidity_n_m > 0.0)) return;
  const auto take = [&](const Garment& from, const Pins& level_pins, const std::vector<Index>& row_of_vertex,
                        const std::vector<Index>& vertex_of_row, const std::vector<double>& shares) {
    const bool is_coarsest = shares.size() < largest_cluster * tuning::fewest_clusters;
    const double rate_per_s = fastest_element_per_s * (is_coarsest ? tuning::coarsest_rate : 1.0);
    Taken taken = take_stiffness(from, level_pins, row_of_vertex, shares, rigidity_n_m, rate_per_s);
    const auto inverse_masses = by_row<double>(level_pins.inverse_masses_per_kg, vertex_of_row);
    levels_.emplace_back();
    levels_.back().matrix = make_sliced_matrix(acceleration_rows(taken.stiffness, inverse_masses));
    return is_coarsest ? std::vector<double>(shares.size(), 0.0) : std::move(taken.left_shares);
  };

  std::vector<Index> order = layout.vertex_of_row;
  std::vector<double> left = take(garment, pins, layout.row_of_vertex, order, std::vector<double>(row_count_, 1.0));
  CoarseCloth coarse;
  while (*std::max_element(left.begin(), left.end()) > 0.0) {
    coarse = coarsen(levels_.size() == 1 ? garment : coarse.garment, order);
    const std::vector<double> shares = shares_of_clusters(coarse, left);
    const auto cluster_of = by_row<std::uint32_t>(coarse.cluster_of, order);
    const auto mass_fraction = by_row<float>(coarse.mass_fraction, order);
    order = in_order(shares.size());
    left = take(coarse.garment, make_pins(coarse.garment, {}), order, order, shares);
    Level& level = levels_.back();
    level.cluster_of = cluster_of;
    level.mass_fraction = mass_fraction;
    level.positions.resize(shares.size() + block_size);
    level.accelerations.resize(level.positions.size());
  }
  largest_rate_per_s_ = find_largest_rate_per_s();
}

std::vector<double> Bending::image_of(const std::vector<double>& mode) const {
  std::vector<std::vector<double>> modes = {mode};
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& level = levels_[l];
    std::vector<double> coarse(level.positions.size() - block_size, 0.0);
    for (std::size_t row = 0; row < level.cluster_of.size(); ++row) {
      coarse[level.cluster_of[row]] += static_cast<double>(level.mass_fraction[row]) * modes.back()[row];
    }
    modes.push_back(std::move(coarse));
  }
  std::vector<double> image;
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const std::size_t begin = l == 0 ? first_free_row_ : 0;
    std::vector<double> finer(modes[l].size(), 0.0);
    for (std::size_t row = begin; row < finer.size() && l + 1 < levels_.size(); ++row) {
      finer[row] = image[levels_[l + 1].cluster_of[row]];
    }
    add_product(levels_[l].matrix, modes[l], finer);
    image = std::move(finer);
  }
  return image;
}

double Bending::find_largest_rate_per_s() const {
  std::vector<double> mode(row_count_, 0.0);
  for (std::size_t row = first_free_row_; row < row_count_; ++row) mode[row] = row % 2 == 0 ? 1.0 : -0.5;
  double eigenvalue = 0.0;
  for (int iteration = 0; iteration < power_iterations; ++iteration) {
    mode = image_of(mode);
    double largest = 0.0;
    for (const double x : mode) largest = std::max(largest, std::abs(x));
    if (!(largest > 0.0)) break;
    eigenvalue = largest;
    for (double& x : mode) x /= largest;
  }
  return std::sqrt(eigenvalue);
}

void Bending::add_accelerations(const Float4Array& positions, ParallelKernels& kernels, Float4Array& accelerations) {
  const Float4* finer = positions.data();
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    std::fill(level.positions.begin(), level.positions.end(), Float4{});
    std::fill(level.accelerations.begin(), level.accelerations.end(), Float4{});
    for (std::size_t row = 0; row < level.cluster_of.size(); ++row) {
      add_scaled(level.positions[level.cluster_of[row]], finer[row], level.mass_fraction[row]);
    }
    kernels.add_product(level.matrix, level.positions.data(), level.accelerations.data());
    finer = level.positions.data();
  }
  for (std::size_t l = levels_.size(); l-- > 1;) {
    const Level& level = levels_[l];
    Float4Array& onto = l == 1 ? accelerations : levels_[l - 1].accelerations;
    for (std::size_t row = l == 1 ? first_free_row_ : 0; row < level.cluster_of.size(); ++row) {
      add_scaled(onto[row], level.accelerations[level.cluster_of[row]], 1.0F);
    }
  }
  kernels.add_product(levels_[0].matrix, positions.data(), accelerations.data());
}

}  // namespace taut::sim::bounded
