#pragma once

#include <filesystem>
#include <string>

#include "tests/study/reference/incremental_potential.hpp"

namespace reference {

struct Surface {
  std::vector<Point> points_m;
  std::vector<Corners> triangles;
};

/// Returns a level sheet around the origin, whose rows of nearly equilateral triangles follow each other along z.
Surface even_sheet(int across, int rows, double width_m, double length_m);

/// A cloth that comes to rest, with its start.
struct RestCase {
  std::string name;
  Cloth cloth;
  std::vector<Point> start_m;
};

/// Returns the built-in T-shirt of this number of triangles, pinned as in the scene tshirt-gravity, with its start as
/// modelled.
RestCase shirt(const std::filesystem::path& garments, int triangles);
/// Returns a square of 1 m of nearly equilateral triangles, laid level over a ball of 0.25 m, slightly off the middle.
/// It is pinned at two vertices on top, because there is no friction.
RestCase cloth_on_ball(int across, double rigidity_n_m);

/// Triangle counts of the T-shirts whose shapes are stored.
inline constexpr std::array kept_shirts = {1028, 5280};
/// Cloths on a ball whose shapes are stored: each rigidity on each mesh.
inline constexpr std::array kept_meshes = {24, 28, 32};
inline constexpr std::array kept_rigidities_n_m = {1e-3, 2e-3};

/// Returns all cases whose shapes are stored.
std::vector<RestCase> kept_cases(const std::filesystem::path& garments);
/// Returns the shape at rest that find_rest_shapes wrote. Throws std::runtime_error if it belongs to another mesh.
Vector kept_rest(const RestCase& what, const std::filesystem::path& shapes);

/// Reads the `v` and `f` lines of a Wavefront file. Throws std::runtime_error.
Surface read_obj(const std::filesystem::path& file);

}  // namespace reference
