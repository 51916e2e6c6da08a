#pragma once

#include "app/sewing/pattern.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Vertices of two borders that are sewn together, in their order along both.
using Seam = std::vector<std::pair<sim::Index, sim::Index>>;

/// Texture coordinates of what is cut are centimetres.
inline constexpr double metres_per_uv_of_cut = 0.01;

/// The pieces of a pattern as triangles, none sewn to another.
struct CutPieces {
  std::vector<sim::Vec2> flat_m;  ///< per vertex, where it is in the cloth: panels lie side by side, seen from outside
  std::vector<sim::Vec3> placed_m;          ///< per vertex, where the pattern places it
  std::vector<sim::Index> panel_of;         ///< per vertex
  std::vector<sim::Triangle> triangles;     ///< panel by panel; sewn together they all face the same side, outwards
  std::vector<sim::Index> panel_triangles;  ///< per panel, its first triangle; then the number of all
  std::vector<char> is_turned;              ///< per panel, whether it is seen from behind where it faces outwards
  std::vector<Seam> seams;                  ///< per stitch
  std::vector<std::size_t> first_seams;     ///< stitches that are closed before others, as they carry the garment
  std::vector<std::size_t> layer_of;        ///< per panel: those are worn over all with lower ones
  double edge_m = 0.0;                      ///< the length edges were made for

  std::size_t panel_count() const { return panel_triangles.size() - 1; }
};

/// Meshes the panels in about so many triangles, or exactly so many where that is found. Both sides of a stitch have
/// the same number of vertices, at equal shares of their lengths: so ease is spread. Their ends meet the way round that
/// has less to go. Throws std::invalid_argument that names a panel which cannot be meshed, or if there is no such mesh.
CutPieces cut_pieces(const SewingPattern& pattern, int triangles, bool is_exact = false);

/// Adds pieces that are worn over these.
void add_over(const CutPieces& over, CutPieces& pieces);

/// Per panel, the box around where it is placed.
std::vector<sim::Extent> panel_boxes(const CutPieces& pieces);

}  // namespace taut::app
