#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Joins borders that run along each other within a distance while the cloth goes different ways from them,
/// whether or not their vertices match: each vertex is welded to the nearest place of the other border.
/// Returns how many vertices were. Where more than two triangles meet after that, it is for `cut_into_sheets`
/// to choose. Requires edges with two triangles at most.
std::size_t join_borders(double distance_m, sim::Mesh& mesh);

/// Joins parts that lie farther apart, where along most of a border another part goes on beyond the gap, as
/// trousers do below their waistband. Places that are joined are at least `spacing_m` apart. Returns and
/// requires the same.
std::size_t join_parts(double gap_m, double spacing_m, sim::Mesh& mesh);

/// Closes holes whose border is shorter than this. Returns how many.
std::size_t fill_small_holes(double longest_m, sim::Mesh& mesh);

/// Closed border lines: vertices in order, the cloth on the left of the way as seen from outside. Lines in which
/// borders touch are left out.
std::vector<std::vector<sim::Index>> border_loops(const sim::Mesh& mesh);

/// How a simulation mesh is made of a model.
struct FittingSettings {
  std::size_t most_triangles = 8000;
  double least_edge_m = 0.0;        ///< edges are made no shorter than this: cloth is thinner than they are long
  double join_distance_m = 0.0025;  ///< borders nearer than this that run along each other become one
  double gap_m = 0.02;              ///< across which a part goes on that lies apart from another
};

/// A mesh to be simulated in place of a model, which goes along.
struct FittedMesh {
  /// In metres: one wall of cloth, two triangles at most at an edge, one fan at a vertex, facing outwards.
  sim::Mesh mesh;
  /// By triangle of the model: its surface is part of the mesh. Others are carried: inner walls, trims,
  /// buttons, labels.
  std::vector<std::uint8_t> is_simulated;
  double edge_m = 0.0;                ///< the length edges were made for
  std::size_t sheets = 0;             ///< connected parts of the mesh
  std::size_t carried_triangles = 0;  ///< of the model
  std::size_t joined_vertices = 0;    ///< of borders that nearly met
  std::size_t closed_holes = 0;       ///< smaller than a few triangles
  std::size_t crossings = 0;          ///< pairs of triangles of the mesh that cross
};

/// The gap of these settings for a garment of this size; 0 for flat pattern pieces, which lie beside each
/// other as they are cut.
double gap_between_parts(const sim::Mesh& model_m, const FittingSettings& settings = {});

/// Makes a mesh of near-equilateral triangles of one size of any model. Requires a mesh that was welded, in
/// metres.
FittedMesh fit_mesh(const sim::Mesh& model_m, const FittingSettings& settings = {});

/// A piece of fewer triangles is no garment.
inline constexpr std::size_t fewest_of_garment = 24;

/// Returns the sine of the smallest angle of a triangle, which lies between its two longest sides.
double sine_of_smallest_angle(const sim::Mesh& mesh, const sim::Triangle& triangle);

/// Returns whether a garment has too few triangles for its folds.
bool is_coarse(const sim::Mesh& model);

/// Says for people why the model itself is not fit for simulation; empty if it is. `crossings` is the number
/// of pairs of its triangles that cross at the start; the cloth is so thick.
std::optional<std::string> why_not_fit_for_simulation(const sim::Mesh& model_m, std::size_t crossings,
                                                      double thickness_m = 0.0);

/// Makes triangles of one size that are near equilateral, on the same surface (Botsch and Kobbelt 2004, A
/// Remeshing Approach to Multiresolution Modeling). Borders stay on the borders, their corners in place.
/// Requires a mesh with two triangles at most at every edge, one fan at every vertex, and neighbours that
/// face the same side. Throws std::invalid_argument where that takes more looks at triangles of the surface.
sim::Mesh remesh(const sim::Mesh& surface, double edge_m, std::size_t max_looks);

}  // namespace taut::app
