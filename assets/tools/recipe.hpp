#pragma once

#include <array>
#include <functional>

#include "tailor/dressing/body.hpp"
#include "tailor/dressing/flat_lengths.hpp"
#include "tailor/flat/pattern.hpp"
#include "tailor/model_file.hpp"
#include "tailor/quality.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Triangles of the paper's three models.
inline constexpr std::array<std::size_t, 3> model_sizes = {10600, 5280, 1028};

/// Triangles of a shirt for another wearer.
inline constexpr std::size_t other_size = 5280;

/// Returns how the wearer of the pattern stands. A pattern that names none is that of cisMaleAdult40.
Stance stance_of(const Pattern& pattern);

/// A shirt and where it is on the body: positions in metres, per vertex.
struct FittedShirt {
  Shirt shirt;
  std::vector<Vec3> positions;
};

/// Called after each mesh has been fitted.
using FitProgress = std::function<void(const FittedShirt&)>;

/// Sews the pieces and fits them to the body, with meshes from coarse to fine. The last has 24000 triangles.
FittedShirt fit_shirt(const std::array<Piece, piece_count>& pieces, const Stance& stance,
                      const FitProgress& progress);

/// The fitted shirt with exactly `triangle_count` triangles. It is a new mesh of the same pieces. Each vertex
/// is placed where its point of the flat piece is on the fitted shirt. Then the shirt relaxes for a moment.
FittedShirt reduce_shirt(const std::array<Piece, piece_count>& pieces, const FittedShirt& fitted,
                         const Stance& stance, std::size_t triangle_count);

/// Throws std::runtime_error unless the strain is at most 1.5 % root mean square and at most 10 % at any
/// edge.
void require_fit(const Strain& strain);

/// Throws std::runtime_error with what was found and expected unless all of this holds. The mesh is one
/// oriented surface with `triangle_count` triangles and four openings. Its outside is outside, it does not
/// intersect itself, and no angle is below 10 degrees. Its area is `fine_area_m2` within 1 %.
void require_quality(const MeshQuality& quality, std::size_t triangle_count, double fine_area_m2);

}  // namespace taut::tailor
