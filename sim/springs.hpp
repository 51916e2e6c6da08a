#pragma once

#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// The three kinds of springs of the paper's Figure 1.
enum class SpringKind { structural, shear, flexural };

inline constexpr std::array all_spring_kinds = {SpringKind::structural, SpringKind::shear, SpringKind::flexural};

/// Returns the name in files and messages.
const char* to_name(SpringKind kind);

/// Springs as flat arrays, one entry per spring. All structural springs come first, then all shear springs, then all
/// flexural springs. Each kind is in lexicographic order of its ends. At most one spring joins two vertices.
struct Springs {
  /// The vertices i and j of eqs. (2) and (3).
  std::vector<Edge> ends;
  std::vector<double> rest_lengths_m;  ///< |L_ij| of eq. (2)
  std::size_t structural_count = 0;
  std::size_t shear_count = 0;

  std::size_t size() const { return ends.size(); }
  /// The springs of a kind have the indices from begin_index(kind) up to, not including, end_index(kind).
  std::size_t begin_index(SpringKind kind) const;
  std::size_t end_index(SpringKind kind) const;
  std::size_t count(SpringKind kind) const { return end_index(kind) - begin_index(kind); }
};

/// Returns the mean rest length of the structural springs, in m; 0 without any.
double mean_edge_m(const Springs& springs);

/// Rule for the flexural springs of triangle models.
enum class FlexuralRule {
  /// Joins each neighbour a of a vertex v to the neighbour b whose direction from v is closest to opposite, if the
  /// angle a-v-b is large enough. On a regular grid this gives the springs of the paper's Figure 1 that skip one mass
  /// point ("according to the angular distribution", section V).
  angular,
  /// Joins the two vertices opposite each interior edge (Provot 1995 on triangles; Baraff and Witkin 1998).
  opposite_vertex,
  none,
};

/// Settings of the mapping from a mesh to springs.
struct MappingSettings {
  FlexuralRule flexural_rule = FlexuralRule::angular;
  /// Smallest angle a-v-b that the angular rule joins, in radians. Smaller values give more springs and stiffer cloth.
  /// The default is 150 degrees.
  double min_flexural_angle_rad = 2.6179938779914944;
};

/// Maps a mesh to springs (Step 1 of the paper). Structural springs are all mesh edges except the diagonals of grid
/// cells. Shear springs are both diagonals of every grid cell. Flexural springs follow the rule of `settings`; one that
/// coincides with another spring is left out. Requires the adjacency of `mesh`.
Springs map_to_springs(const Mesh& mesh, const Adjacency& adjacency, const MappingSettings& settings);

}  // namespace taut::sim
