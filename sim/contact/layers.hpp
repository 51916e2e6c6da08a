#pragma once

#include <optional>
#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// How a solver moves layers of cloth apart that are too close. Solvers differ in these values only.
struct LayerParting {
  double distance_m = 0.0;  ///< the smallest distance of vertices of different layers
  /// The fraction of the missing distance that one parting adds. A lower value pulls less at the springs and
  /// takes longer.
  double share_at_once =
      1.0;                  ///< of what two vertices lack of it: less tears less at springs and takes longer
  bool gives_speed = true;  ///< whether vertices gain speed when they are moved apart
};

/// How two vertices i and j that are too close move, in m/kg: i by w_i times the vector, j by -w_j times the
/// vector, with the inverse masses w. So the lighter vertex moves more and momentum is kept.
struct Parted {
  Vec3 current;   ///< for the current positions
  Vec3 previous;  ///< for the positions one time step before; zero if speed is given
};

/// The law that keeps layers apart. x = x_i - x_j is `between_m`, |x| is less than the distance d, and s is
/// the share at once. v is `moved_m`: the move of i minus the move of j in the last time step.
///   current  = s (d - |x|) / (w_i + w_j) x / |x|,
///   previous = current + min(v . x / |x|, 0) / (w_i + w_j) x / |x|   if no speed is given.
/// If no speed is given, the positions of both times move by the same amount and the speed of approach is
/// removed. If speed is given, `moved_m` is ignored. Returns nothing if the vertices are far enough apart, at
/// the same place or both pinned.
std::optional<Parted> part(const LayerParting& law, const Vec3& between_m, const Vec3& moved_m,
                           double inverse_mass_sum_per_kg);

/// Applies the law to every pair of vertices, one after the other, in predicted positions. Each pair sees the
/// results of those before it. Layers do not pass through each other as long as the distance is not much less
/// than the mesh's edge length. The last two spans have one entry per vertex; positions are in metres.
void part_layers(std::span<const Edge> pairs, double distance_m,
                 std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted);

}  // namespace taut::sim
