#pragma once

#include "app/garments/fitting/sheets.hpp"

namespace taut::app {

/// Returns the closed borders as vertices in order, with the cloth on the left as seen from outside. Borders that touch
/// are left out.
std::vector<std::vector<sim::Index>> border_loops(const sim::Mesh& mesh);

/// One wall of the cloth of a model.
struct Wall {
  Sheets sheets;                        ///< its sheets, facing outwards and joined where their borders meet
  std::vector<std::uint8_t> is_chosen;  ///< per triangle of the model, whether it is of this wall
};

/// Finds the wall of a model. Requires a welded mesh in metres.
Wall find_wall(const sim::Mesh& model_m);

/// Settings of a mesh that is fitted to a model.
struct FittingSettings {
  std::size_t max_triangles = 8000;
  double min_edge_m = 0.0;  ///< lower limit of the edge length; cloth has to be thinner than its edges are long
};

/// A mesh that is simulated in place of a model, which follows it.
struct FittedMesh {
  /// Mesh in metres: one wall of cloth, at most two triangles at an edge, one fan at a vertex, facing outwards.
  sim::Mesh mesh;
  /// Per triangle of the model, whether its surface is part of the mesh. Other triangles follow the simulated wall:
  /// inner walls, trims, buttons, labels.
  std::vector<std::uint8_t> is_simulated;
  double edge_m = 0.0;             ///< target edge length
  std::size_t sheets = 0;          ///< count of connected components of the mesh
  std::size_t dropped_sheets = 0;  ///< count of sheets too small to be simulated
  double dropped_area_fraction = 0.0;
  std::size_t crossings = 0;  ///< count of pairs of triangles of the mesh that cross
};

/// Makes a mesh of near-equilateral triangles of one size from any model. Requires a welded mesh in metres.
FittedMesh fit_mesh(const sim::Mesh& model_m, const FittingSettings& settings = {});

/// Makes a mesh of the same sheets whose triangles are small where the cloth is narrow or folded. It crosses itself
/// more often than the mesh of fit_mesh(). Requires a welded mesh in metres.
FittedMesh simplify_model(const sim::Mesh& model_m, const FittingSettings& settings = {});

/// Largest number of triangles of a model that is simulated itself.
inline constexpr std::size_t max_simulated_triangles = 16000;

/// Smallest number of triangles of a garment.
inline constexpr std::size_t min_garment_triangles = 24;

/// Returns the sine of the smallest angle of a triangle, the angle between its two longest sides.
double sine_of_smallest_angle(const sim::Mesh& mesh, const sim::Triangle& triangle);

/// Returns whether a garment has too few triangles for its folds.
bool is_coarse(const sim::Mesh& model);

/// Returns for people why the model itself is not fit for simulation; nothing if it is. `crossings` is the number of
/// pairs of its triangles that cross at the start, `thickness_m` the thickness of its cloth.
std::optional<std::string> why_not_fit_for_simulation(const sim::Mesh& model_m, std::size_t crossings,
                                                      double thickness_m = 0.0);

/// Makes near-equilateral triangles of one size on the same surface (Botsch and Kobbelt 2004, A Remeshing Approach to
/// Multiresolution Modeling). Borders stay on the borders, and their corners in place. Requires at most two triangles
/// at every edge, one fan at every vertex and neighbours that face the same side. Throws std::invalid_argument if it
/// needs more than `max_looks` tests of triangles of the surface.
sim::Mesh remesh(const sim::Mesh& surface, double edge_m, std::size_t max_looks);

/// Collapses edges until at most `max_triangles` are left, or none can be collapsed without needles (Garland and
/// Heckbert 1997, Surface Simplification Using Quadric Error Metrics). Requires the same as remesh().
sim::Mesh simplify(const sim::Mesh& surface, std::size_t max_triangles);

}  // namespace taut::app
