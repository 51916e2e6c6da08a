#pragma once

#include <filesystem>
#include <string>

#include "tests/reference/incremental_potential.hpp"

namespace reference {

struct Surface {
  std::vector<Point> points_m;
  std::vector<Corners> triangles;
};

/// A level sheet around the origin, its rows of nearly even triangles one after the other along z.
Surface even_sheet(int across, int rows, double width_m, double length_m);

/// A cloth that comes to rest, and where it begins.
struct RestCase {
  std::string name;
  Cloth cloth;
  std::vector<Point> start_m;
};

/// The built-in T-shirt of so many triangles, held as the scene tshirt-gravity holds it, from the shape it is modelled
/// in.
RestCase shirt(const std::filesystem::path& garments, int triangles);
/// A square of 1 m, of about even triangles, that is laid level over a ball of 0.25 m, a little aside. It is held at
/// two vertices on top, as nothing rubs.
RestCase cloth_on_ball(int across, double rigidity_n_m);

/// The T-shirts whose shapes are kept.
inline constexpr std::array kept_shirts = {1028, 5280};
/// The cloths on a ball whose shapes are kept: each rigidity on each mesh.
inline constexpr std::array kept_meshes = {24, 28, 32};
inline constexpr std::array kept_rigidities_n_m = {1e-3, 2e-3};

/// All whose shapes are kept.
std::vector<RestCase> kept_cases(const std::filesystem::path& garments);
/// The shape at rest that find_rest_shapes has written. Throws std::runtime_error if it is of another mesh.
Vector kept_rest(const RestCase& what, const std::filesystem::path& shapes);

/// Reads the `v` and `f` lines of a Wavefront file. Throws std::runtime_error.
Surface read_obj(const std::filesystem::path& file);

}  // namespace reference
