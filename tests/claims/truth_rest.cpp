#include "tests/claims/rest_shapes.hpp"
#include "tests/claims/truth_setups.hpp"

namespace taut::app::truth {

/// Stiff cloth on a ball, beside what the incremental potential gives on the same mesh.
std::vector<TruthPoint> run_rest(const TruthExperiment& experiment, double physics, const ProgressCallback& report) {
  return run_all(reference::kept_meshes, report, [&](int across) {
    std::vector<TruthPoint> points;
    for (const double rigidity_n_m : reference::kept_rigidities_n_m) {
      const reference::RestCase what = reference::cloth_on_ball(across, rigidity_n_m);
      const double weight_n_per_m2 = what.cloth.fabric.density_kg_per_m2 * gravity_m_per_s2;
      points.push_back(
          {experiment.name, "cloth", fmt::format("{} edges", across), 100.0 * std::cbrt(rigidity_n_m / weight_n_per_m2),
           100.0 * drape_coefficient(what, rest_of(what, physics)), 100.0 * drape_coefficient(what, kept_rest(what))});
    }
    return points;
  });
}

}  // namespace taut::app::truth
