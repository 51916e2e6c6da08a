#pragma once

#include <array>
#include <functional>

#include "tailor/dressing/flat_lengths.hpp"
#include "tailor/model_file.hpp"
#include "tailor/quality.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// The paper's three models, in triangles.
inline constexpr std::array<std::size_t, 3> model_sizes = {10600, 5280, 1028};

struct FittedShirt {
  Shirt shirt;
  std::vector<Vec3> positions;
};

/// Told after each meshing has been fitted.
using FitProgress = std::function<void(const FittedShirt&)>;

/// Sews the pieces and fits them to the body, first coarsely, in the end with 24000 triangles.
FittedShirt fit_shirt(const std::array<Piece, piece_count>& pieces, const FitProgress& progress);

/// The fitted shirt with exactly that many triangles: another meshing of the same pieces, each vertex where
/// its place on the flat piece lies on the fitted shirt, relaxed for a moment.
FittedShirt reduce_shirt(const std::array<Piece, piece_count>& pieces, const FittedShirt& fitted,
                         std::size_t triangle_count);

/// Throws std::runtime_error unless the shirt is nearly isometric to its flat pieces: strain at most 1.5 %
/// root mean square, 10 % at worst.
void require_fit(const Strain& strain);

/// Throws std::runtime_error saying what was found and expected, unless the mesh is one oriented surface of
/// that many triangles with four openings, turned outside out, without self-intersections, with no angle
/// below 10 degrees and with the area of the fine shirt to 1 %.
void require_quality(const MeshQuality& quality, std::size_t triangle_count, double fine_area_m2);

}  // namespace taut::tailor
