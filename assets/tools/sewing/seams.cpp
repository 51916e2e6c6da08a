#include "tailor/sewing/seams.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut::tailor {
namespace {

// Largest shift of a point each way, as a fraction of a step. Enough to look irregular; more would give thin
// triangles.
constexpr double jitter = 0.15;

/// Every name once, in order of first use, with the length of its first side.
std::vector<std::pair<std::string, double>> name_seams(const std::array<Piece, piece_count>& pieces) {
  std::vector<std::pair<std::string, double>> named;
  for (const Piece& piece : pieces) {
    for (const Side& side : piece.sides) {
      const bool is_known =
          std::any_of(named.begin(), named.end(), [&](const auto& seam) { return seam.first == side.seam; });
      if (!is_known) {
        named.emplace_back(side.seam, length_of(side.line));
      }
    }
  }
  return named;
}

std::vector<double> irregular_fractions(std::size_t steps, Random& random) {
  std::vector<double> fractions = {0.0};
  for (std::size_t i = 1; i < steps; ++i) {
    fractions.push_back((static_cast<double>(i) + random.between(-jitter, jitter)) /
                        static_cast<double>(steps));
  }
  fractions.push_back(1.0);
  return fractions;
}

std::size_t position_of(const std::vector<Seam>& seams, const std::string& name) {
  const auto found =
      std::find_if(seams.begin(), seams.end(), [&](const Seam& seam) { return seam.name == name; });
  return static_cast<std::size_t>(found - seams.begin());
}

/// Sets of seam ends that are one point of the shirt. End 2s is the start of seam s, end 2s + 1 its end.
class Corners {
 public:
  explicit Corners(std::size_t seam_count) : parent_(2 * seam_count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t end) const {
    while (parent_[end] != end) {
      end = parent_[end];
    }
    return end;
  }
  void unite(std::size_t a, std::size_t b) {
    // The smaller one leads, so that the numbering does not depend on the order of uniting.
    const std::size_t first = find(a);
    const std::size_t second = find(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Where one side of a piece ends the next begins; those two seam ends are the same corner.
Corners find_corners(const std::array<Piece, piece_count>& pieces, const std::vector<Seam>& seams) {
  Corners corners(seams.size());
  for (const Piece& piece : pieces) {
    for (std::size_t i = 0; i < piece.sides.size(); ++i) {
      const Side& side = piece.sides[i];
      const Side& next = piece.sides[(i + 1) % piece.sides.size()];
      corners.unite(2 * position_of(seams, side.seam) + (side.against_seam ? 0 : 1),
                    2 * position_of(seams, next.seam) + (next.against_seam ? 1 : 0));
    }
  }
  return corners;
}

std::size_t number_vertices(const Corners& corners, std::vector<Seam>& seams) {
  std::vector<Index> corner_vertices(2 * seams.size(), 0);
  Index next = 0;
  for (std::size_t end = 0; end < corner_vertices.size(); ++end) {
    const std::size_t corner = corners.find(end);
    corner_vertices[end] = corner == end ? next++ : corner_vertices[corner];
  }
  for (std::size_t s = 0; s < seams.size(); ++s) {
    std::vector<Index>& vertices = seams[s].vertices;
    vertices.push_back(corner_vertices[2 * s]);
    while (vertices.size() + 1 < seams[s].fractions.size()) {
      vertices.push_back(next++);
    }
    vertices.push_back(corner_vertices[2 * s + 1]);
  }
  return next;
}

}  // namespace

std::vector<Seam> sample_seams(const std::array<Piece, piece_count>& pieces, double edge_length_m,
                               std::size_t extra_border_points, Random& random, std::size_t& vertex_count) {
  std::vector<Seam> seams;
  for (const auto& [name, length_m] : name_seams(pieces)) {
    const auto steps = static_cast<std::size_t>(std::max(2.0, std::floor(length_m / edge_length_m + 0.5)));
    const std::size_t extra = seams.empty() ? extra_border_points : 0;
    seams.push_back({name, irregular_fractions(steps + extra, random), {}});
  }
  vertex_count = number_vertices(find_corners(pieces, seams), seams);
  return seams;
}

Panel outline_panel(const Piece& piece, const std::vector<Seam>& seams) {
  Panel panel;
  panel.kind = piece.kind;
  for (const Side& side : piece.sides) {
    const Seam& seam = seams[position_of(seams, side.seam)];
    const std::size_t last = seam.vertices.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      const std::size_t k = side.against_seam ? last - i : i;
      const double fraction = side.against_seam ? 1.0 - seam.fractions[k] : seam.fractions[k];
      panel.flat_m.push_back(point_at_fraction(side.line, fraction));
      panel.vertices.push_back(seam.vertices[k]);
    }
  }
  panel.outline_count = panel.flat_m.size();
  return panel;
}

}  // namespace taut::tailor
