#pragma once

#include <mutex>

#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// Limits the offsets of a model that follows a simulation mesh, so that it stays out of the mesh's next layer.
class OffsetLimits {
 public:
  OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated);

  /// Returns per bond the fraction of its offset that is left at these positions, in m. The fraction is 1 if no other
  /// layer is nearer than the offsets of both together, or nearer than at rest. Otherwise the offsets just meet.
  /// Requires the bonds and triangles of the constructor. Threads may call it at the same time.
  std::vector<float> shares(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                            std::span<const sim::Triangle> triangles) const;

 private:
  std::vector<float> reach_m_;  ///< largest offset of a bond about each vertex
  std::vector<float> at_rest_;  ///< shares at rest, by which shares are divided
  mutable std::mutex mutex_;
  mutable sim::bounded::Clearances clearances_;  ///< clearances whose searches use memory of their own
};

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

/// Binds the model to the mesh that was fitted to it, both in metres.
FollowingModel follow_fitted(sim::Mesh model_m, const FittedModel& fitted);

/// Returns, per triangle of the simulation mesh, the direction of the warp (sim::warps_from_coordinates), from the
/// texture coordinates of the nearest triangle of the model.
std::vector<sim::Vec2> warps_below(const sim::Mesh& simulated, const sim::Mesh& model,
                                   std::span<const glm::vec2> corner_uv);

/// Returns the simulated positions for positions of the model's file, in m. Requires one per vertex of the file.
std::vector<sim::Vec3> simulated_m(const FollowingModel& following, const sim::Mesh& simulated,
                                   std::span<const sim::Vec3> file_m);

/// Returns a line for people: the mesh that is simulated instead of the model, and why.
std::string describe(const FollowingModel& following, const sim::Mesh& simulated);

/// Returns the garment as if the following model were simulated itself: without pins, as modelled.
LoadedGarment as_modelled(const LoadedGarment& loaded, const sim::MappingSettings& mapping);

/// Returns a line for people: the stretch of a following model, and the number of pairs of its triangles that cross,
/// for these positions of the simulated vertices, in m. The promises exclude it. Empty if the model itself is
/// simulated.
std::string describe_following(const GarmentInScene& loaded, std::span<const sim::Vec3> positions_m);

}  // namespace taut::app
