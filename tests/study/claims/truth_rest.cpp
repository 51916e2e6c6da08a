#include "tests/study/claims/rest_shapes.hpp"
#include "tests/study/claims/truth_setups.hpp"

namespace taut::app::truth {

/// Compares stiff cloth on a ball with the incremental potential on the same mesh.
std::vector<TruthPoint> run_rest(const TruthExperiment& experiment, double physics, const ProgressCallback& report) {
  return run_all(reference::kept_meshes, report, [&](int across) {
    std::vector<TruthPoint> points;
    for (const double rigidity_n_m : reference::kept_rigidities_n_m) {
      const reference::RestCase what = reference::cloth_on_ball(across, rigidity_n_m);
      const double weight_n_per_m2 = what.cloth.fabric.density_kg_per_m2 * gravity_m_per_s2;
      points.push_back({experiment.name, "cloth", fmt::format("{} edges", across),
                        100.0 * std::cbrt(rigidity_n_m / weight_n_per_m2),
                        100.0 * drape_coefficient(what, find_rest(what, physics)),
                        100.0 * drape_coefficient(what, kept_rest(what))});
    }
    return points;
  });
}

}  // namespace taut::app::truth
