#pragma once

#include <array>
#include <vector>

#include "tailor/flat/random.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Samples every seam once, at slightly irregular steps of about `edge_length_m`, and numbers its vertices:
/// first the corners where seams meet, then the seams in the order the pieces name them. Returns the seams
/// and sets `vertex_count`. `extra_border_points` more are put on the first border of the shirt, the front
/// hem: the number of triangles of a mesh has the parity of the number of its border edges.
std::vector<Seam> sample_seams(const std::array<Piece, piece_count>& pieces, double edge_length_m,
                               std::size_t extra_border_points, Random& random, std::size_t& vertex_count);

/// The points of a piece's outline where its seams were sampled, without interior points or triangles.
Panel outline_panel(const Piece& piece, const std::vector<Seam>& seams);

}  // namespace taut::tailor
