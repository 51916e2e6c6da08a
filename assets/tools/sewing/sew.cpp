#include "tailor/sewing/sew.hpp"

#include <cmath>
#include <stdexcept>

#include "tailor/sewing/scatter.hpp"
#include "tailor/sewing/seams.hpp"

namespace taut::tailor {
namespace {

double total_area(const std::array<Piece, piece_count>& pieces) {
  double area_m2 = 0.0;
  for (const Piece& piece : pieces) {
    area_m2 += polygon_area(piece.outline());
  }
  return area_m2;
}

/// The side of that many equilateral triangles that cover the area.
double edge_length_for(double area_m2, std::size_t triangle_count) {
  return std::sqrt(area_m2 * 4.0 / (std::sqrt(3.0) * static_cast<double>(triangle_count)));
}

/// A disc with o outline and i interior points has 2 i + o - 2 triangles.
std::size_t outline_triangles(const Shirt& shirt) {
  std::size_t count = 0;
  for (const Panel& panel : shirt.panels) {
    count += panel.outline_count - 2;
  }
  return count;
}

Shirt outline_shirt(const std::array<Piece, piece_count>& pieces, double edge_length_m, std::size_t extra,
                    std::uint64_t seed) {
  Random random(seed);
  Shirt shirt;
  shirt.seams = sample_seams(pieces, edge_length_m, extra, random, shirt.vertex_count);
  for (std::size_t p = 0; p < piece_count; ++p) {
    shirt.panels[p] = outline_panel(pieces[p], shirt.seams);
  }
  return shirt;
}

/// Shares the interior points out so that triangles are about equally large on every panel and the shirt has
/// exactly as many as asked for.
std::array<std::size_t, piece_count> interior_counts(const Shirt& shirt, std::size_t triangle_count) {
  double area_m2 = 0.0;
  for (const Panel& panel : shirt.panels) {
    area_m2 += polygon_area(panel.flat_m);
  }
  std::size_t left = (triangle_count - outline_triangles(shirt)) / 2;
  std::array<std::size_t, piece_count> counts{};
  for (std::size_t p = piece_count; p-- > 1;) {
    const Panel& panel = shirt.panels[p];
    const double triangles = static_cast<double>(triangle_count) * polygon_area(panel.flat_m) / area_m2;
    counts[p] = static_cast<std::size_t>((triangles - static_cast<double>(panel.outline_count - 2)) / 2.0);
    left -= counts[p];
  }
  counts[0] = left;
  return counts;
}

void number_interior(Panel& panel, std::size_t& vertex_count) {
  while (panel.vertices.size() < panel.flat_m.size()) {
    panel.vertices.push_back(static_cast<Index>(vertex_count++));
  }
}

}  // namespace

Shirt sew_shirt(const std::array<Piece, piece_count>& pieces, std::size_t triangle_count,
                std::uint64_t seed) {
  const double edge_length_m = edge_length_for(total_area(pieces), triangle_count);
  Shirt shirt = outline_shirt(pieces, edge_length_m, 0, seed);
  const std::size_t extra = (triangle_count + outline_triangles(shirt)) % 2;
  shirt = outline_shirt(pieces, edge_length_m, extra, seed);
  if (outline_triangles(shirt) >= triangle_count) {
    throw std::invalid_argument("a shirt of " + std::to_string(triangle_count) + " triangles has no inside");
  }
  const auto counts = interior_counts(shirt, triangle_count);
  Random random(seed + 1);
  for (std::size_t p = 0; p < piece_count; ++p) {
    fill_panel(shirt.panels[p], counts[p], edge_length_m, random);
    number_interior(shirt.panels[p], shirt.vertex_count);
  }
  return shirt;
}

}  // namespace taut::tailor
