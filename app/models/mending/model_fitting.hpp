#pragma once

#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/mending/following_limits.hpp"

namespace taut::app {

/// A simulation mesh that was fitted to a model, and the reason.
struct FittedModel : FittedMesh {
  std::string why;
};

/// Mesh that is simulated in place of a model, or the reason why no mesh that was fitted is.
struct FittingOutcome {
  std::optional<FittedModel> fitted;
  std::string refusal;  ///< difference between the first mesh that was fitted and the model; empty if there is none
};

/// Fits a simulation mesh if the scene asks for one, or if the model is not fit for simulation and the scene leaves the
/// choice. In the latter case only a mesh that is the model's cloth is taken (comparison.hpp), else the model itself.
/// `model_m` is welded, in metres; `thickness_m` is the cloth's. Throws std::invalid_argument if neither can be
/// simulated.
FittingOutcome fit_model(const GarmentSource& source, double thickness_m, const sim::Mesh& model_m);

/// Binds the model to the mesh that was fitted to it, both in metres. `bound` is the bound on the mesh's stretch, a
/// fraction.
FollowingModel follow_fitted(sim::Mesh model_m, const FittedModel& fitted, double bound);

/// Returns, per triangle of the simulation mesh, the direction of the warp (sim::warps_from_coordinates), from the
/// texture coordinates of the nearest triangle of the model.
std::vector<sim::Vec2> warps_below(const sim::Mesh& simulated, const sim::Mesh& model,
                                   std::span<const glm::vec2> corner_uv);

/// Shows and exports the simulated mesh, in the colours of the model, instead of the model that follows it. Requires a
/// model that follows.
void show_simulated(GarmentInScene& loaded);

/// Returns the simulated positions for positions of the model's file, in m. Requires one per vertex of the file.
std::vector<sim::Vec3> simulated_m(const FollowingModel& following, const sim::Mesh& simulated,
                                   std::span<const sim::Vec3> file_m);

/// Returns the garment as if the following model were simulated itself: without pins, as modelled.
LoadedGarment as_modelled(const LoadedGarment& loaded, const sim::MappingSettings& mapping);

/// Throws ModelOverstretched if a model that follows is stretched too much to be shown.
void require_fit_to_show(const sim::Stretch& stretch);

/// Returns a line for people: the simulated mesh is shown, for this reason.
std::string describe_simulated_shown(const std::string& reason);

/// Measures of a following model over the frames of a run. The promises exclude it.
struct FollowingSummary {
  /// Measures the model in this shape, in m (FollowingModel::shown_m()). Returns its stretch.
  const sim::Stretch& add(const FollowingModel& following, std::span<const sim::Vec3> shown_m);
  /// Returns a line for people; empty if nothing was measured.
  std::string describe() const;

  std::optional<FollowingMeasures> last = {};
  double max_stretch = 0.0;
  double max_p99_stretch = 0.0;
  std::size_t max_new_crossings = 0;
};

}  // namespace taut::app
