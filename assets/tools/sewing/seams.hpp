#pragma once

#include <array>
#include <vector>

#include "tailor/flat/random.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Samples every seam once, in slightly irregular steps of about `edge_length_m`. Numbers the vertices: first
/// the corners where seams meet, then the seams in the order of the pieces. Sets `vertex_count`.
///
/// `extra_border_points` are added to the front hem, the first border. They make an exact number of triangles
/// possible: it is odd or even as the number of border edges is.
std::vector<Seam> sample_seams(const std::array<Piece, piece_count>& pieces, double edge_length_m,
                               std::size_t extra_border_points, Random& random, std::size_t& vertex_count);

/// The points on a piece's outline where its seams were sampled, without interior points or triangles.
Panel outline_panel(const Piece& piece, const std::vector<Seam>& seams);

}  // namespace taut::tailor
