#pragma once

#include <optional>
#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// How layers of cloth that are too close are parted. What solvers differ in is here and nowhere else.
struct LayerParting {
  double distance_m = 0.0;  ///< kept between vertices of different layers
  double share_at_once =
      1.0;                  ///< of what two vertices lack of it: less tears less at springs and takes longer
  bool gives_speed = true;  ///< whether vertices move on by as much as they were parted
};

/// What two vertices i and j that are too close move by, in m/kg: i by w_i times it, j by -w_j times it, with
/// the inverse masses w. So the lighter one moves more, and both keep their momentum.
struct Parted {
  Vec3 current;   ///< of the positions that are too close
  Vec3 previous;  ///< of the positions one time step before; zero where speed is given
};

/// The law by which layers are kept apart. With x = x_i - x_j, their distance |x| less than d, the share s
/// and the difference v of what i and j moved in the last time step,
///   current  = s (d - |x|) / (w_i + w_j) x / |x|,
///   previous = current + min(v . x / |x|, 0) / (w_i + w_j) x / |x|   where no speed is given:
/// then positions of two times move alike, and the speed of the approach is taken away.
/// `between_m` is x and `moved_m` is v, which is not looked at where speed is given. Nothing for vertices
/// that are far enough from each other, at the same place, or both pinned.
std::optional<Parted> part(const LayerParting& law, const Vec3& between_m, const Vec3& moved_m,
                           double inverse_mass_sum_per_kg);

/// Parts every pair of vertices, one after the other, in predicted positions: each sees what the ones before
/// it did. Layers of cloth so keep from passing through each other as long as the distance is not much less
/// than the edges of the mesh are long. One entry per vertex in both spans.
void part_layers(std::span<const Edge> pairs, double distance_m,
                 std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted);

}  // namespace taut::sim
