#include "app/models/untangling.hpp"

#include <fmt/core.h>

#include "app/base/counted.hpp"
#include "app/base/interruption.hpp"
#include "sim/untangle/untangle.hpp"

namespace taut::app {

std::optional<Untangling> untangle_start(const Scene& scene, const sim::Garment& garment, bool is_cut_anew,
                                         std::vector<sim::Vec3>& start_m,
                                         const std::function<void(const std::string&)>& tell) {
  sim::UntangleSettings settings;
  settings.bounded = scene.simulation.solver.bounded;
  settings.distance_m = garment.material.thickness_m;
  settings.is_cut_anew = is_cut_anew;
  sim::Untangled untangled =
      sim::untangle(garment, start_m, settings, [&](std::span<const sim::Vec3> positions_m) {
        throw_if_interrupted();
        std::vector<sim::TrianglePair> pairs;
        for (const CrossingPair& pair : crossing_pairs({positions_m, garment.mesh.triangles})) {
          pairs.push_back({pair.first, pair.second});
        }
        tell(fmt::format("untangling it: {} cross", counted(pairs.size(), "pair")));
        return pairs;
      });
  if (untangled.pairs_before == 0 && untangled.largest_move_m == 0.0) {
    return std::nullopt;
  }
  start_m = std::move(untangled.positions_m);
  return Untangling{untangled.pairs_before, untangled.pairs_left, untangled.largest_move_m};
}

std::string describe(const Untangling& u) {
  if (u.pairs_before == 0) {
    return fmt::format(
        "where layers were as one it was parted and evened out, no vertex by more than {:.3g} mm",
        1e3 * u.largest_move_m);
  }
  return fmt::format(
      "of {} that crossed at the start {} left, and no vertex was moved by more than {:.3g} mm",
      counted(u.pairs_before, "pair of triangles", "pairs of triangles"),
      u.pairs_left == 1 ? "1 is" : fmt::format("{} are", u.pairs_left), 1e3 * u.largest_move_m);
}

}  // namespace taut::app
