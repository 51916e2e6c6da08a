#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Meshes the pieces with irregular triangles of even size and sews them to a shirt of exactly
/// `triangle_count` triangles. The same arguments give the same bits.
Shirt sew_shirt(const std::array<Piece, piece_count>& pieces, std::size_t triangle_count, std::uint64_t seed);

}  // namespace taut::tailor
