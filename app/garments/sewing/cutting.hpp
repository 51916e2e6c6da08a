#pragma once

#include "app/garments/sewing/pattern.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Pairs of vertices of two borders that are sewn together, in their order along both.
using Seam = std::vector<std::pair<sim::Index, sim::Index>>;

/// Unit of the texture coordinates of a cut garment: centimetres.
inline constexpr double metres_per_uv_of_cut = 0.01;

/// Pieces of a pattern as triangles, none sewn to another.
struct CutPieces {
  std::vector<sim::Vec2> flat_m;  ///< per vertex, its position in the cloth; panels lie side by side, seen from outside
  std::vector<sim::Vec3> placed_m;          ///< per vertex, its position in the pattern
  std::vector<sim::Index> panel_of;         ///< per vertex
  std::vector<sim::Triangle> triangles;     ///< panel by panel; they face outwards once sewn
  std::vector<sim::Index> panel_triangles;  ///< per panel, its first triangle; then the count of all
  std::vector<Seam> seams;                  ///< per stitch
  std::vector<std::size_t> first_seams;     ///< seams that are closed first, since they carry the garment
  std::vector<std::size_t> layer_of;        ///< per panel; higher layers are worn over lower ones
  double edge_m = 0.0;                      ///< target edge length

  std::size_t panel_count() const { return panel_triangles.size() - 1; }
};

/// Meshes the panels in about `triangles` triangles, or exactly so many if such a mesh is found. Both sides of a stitch
/// have the same number of vertices, at equal fractions of their lengths, so that ease is spread. Their ends meet in
/// the direction with the shorter distance. Throws std::invalid_argument that names a panel which cannot be meshed, or
/// if there is no such mesh.
CutPieces cut_pieces(const SewingPattern& pattern, int triangles, bool is_exact = false);

/// Adds pieces that are worn over these.
void add_over(const CutPieces& over, CutPieces& pieces);

/// Returns, per panel, the box around its placed vertices.
std::vector<sim::Extent> panel_boxes(const CutPieces& pieces);

}  // namespace taut::app
