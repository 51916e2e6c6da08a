#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

enum class SpringKind { structural, shear, flexural };

inline constexpr std::array all_spring_kinds = {SpringKind::structural, SpringKind::shear,
                                                SpringKind::flexural};

const char* name_of(SpringKind kind);

/// The springs of a garment as flat arrays: first all structural, then all shear, then all flexural ones,
/// each kind in lexicographic order of its ends. No two springs join the same two vertices.
struct Springs {
  std::vector<Edge> ends;
  std::vector<double> rest_lengths_m;  ///< |L_ij| of eq. (2)
  std::size_t structural_count = 0;
  std::size_t shear_count = 0;

  std::size_t size() const { return ends.size(); }
  std::size_t begin_of(SpringKind kind) const;
  std::size_t end_of(SpringKind kind) const;
  std::size_t count(SpringKind kind) const { return end_of(kind) - begin_of(kind); }
};

/// How triangle models get their flexural springs.
enum class FlexuralRule {
  /// Around vertex v each neighbour a is joined to the neighbour b that lies closest to straight opposite,
  /// where the angle a-v-b is large enough. On a regular grid these are the springs of the paper's Figure 1
  /// that skip one mass point ("according to the angular distribution", section V).
  angular,
  /// The two vertices opposite an interior edge (Provot 1995 on triangles; Baraff and Witkin 1998).
  opposite_vertex,
  none,
};

struct MappingSettings {
  FlexuralRule flexural_rule = FlexuralRule::angular;
  /// Angular rule: the smallest angle a-v-b, in radians, at which a and b are joined. Smaller means more
  /// springs and a stiffer cloth. Default 150 degrees.
  double smallest_flexural_angle_rad = 2.6179938779914944;
};

/// Maps a mesh to springs (Step 1 of the paper). Structural: every mesh edge but the diagonals of grid
/// cells. Shear: both diagonals of every grid cell. Flexural: by the rule.
Springs map_to_springs(const Mesh& mesh, const Adjacency& adjacency, const MappingSettings& settings);

}  // namespace taut::sim
