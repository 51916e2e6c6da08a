#pragma once

#include <mutex>

#include "app/fitting/fitted_mesh.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// Keeps the offsets of a model that follows a simulation mesh out of the mesh's next layer.
class OffsetLimits {
 public:
  OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated);

  /// Returns per bond the share of its offset that is left at these positions, in m: 1 where no other layer is
  /// nearer than the offsets of both together, or nearer than it was at rest; else so much that they just meet.
  /// Takes the bonds and triangles that it was made for. Threads may call it at the same time.
  std::vector<float> shares(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                            std::span<const sim::Triangle> triangles) const;

 private:
  std::vector<float> reach_m_;  ///< the largest offset of a bond about the vertex
  std::vector<float> at_rest_;  ///< of each share, by which it is divided
  mutable std::mutex mutex_;
  mutable sim::bounded::Clearances clearances_;  ///< whose searches use memory of their own
};

/// A simulation mesh that was fitted to a model, and why.
struct FittedModel : FittedMesh {
  std::string why;
  std::size_t model_crossings = 0;  ///< pairs of the model's triangles that cross, where the scene leaves the choice
};

/// Returns a simulation mesh if the scene asks for one, or if the model is not fit to be simulated and the scene
/// leaves the choice. `model_m` is welded, in metres, and the cloth is so thick. Throws std::invalid_argument if no
/// mesh can be made.
std::optional<FittedModel> fitted_model(const GarmentSource& source, double thickness_m, const sim::Mesh& model_m);

/// Returns whether the mesh is in shreds that cross each other while the model hardly crosses itself, such as one whose
/// folds were reduced to fins, and the scene leaves the choice.
bool crosses_more_than_model(const FittedModel& fitted, const sim::Mesh& model);

/// Binds the model to the mesh that was fitted to it, both in metres.
FollowingModel follow_fitted(sim::Mesh model_m, const FittedModel& fitted);

/// Returns, per triangle of the simulation mesh, the direction of the warp as sim::warps_of has it, from the
/// texture coordinates of the model's triangle that is nearest.
std::vector<sim::Vec2> warps_below(const sim::Mesh& simulated, const sim::Mesh& model,
                                   std::span<const glm::vec2> corner_uv);

/// Returns the simulated positions for positions of the model's file, in m. Requires one per vertex of the file.
std::vector<sim::Vec3> simulated_m(const FollowingModel& following, const sim::Mesh& simulated,
                                   std::span<const sim::Vec3> file_m);

/// One line for people: the mesh that is simulated instead of the model, and why.
std::string describe(const FollowingModel& following, const sim::Mesh& simulated);

/// The garment as if the model that follows were simulated itself: without pins, as it was modelled.
LoadedGarment as_modelled(const LoadedGarment& loaded, const sim::MappingSettings& mapping);

/// One line for people: how far a model that follows is stretched, and how many pairs of its triangles cross, for
/// these positions of the simulated vertices, in m. No promise is made of it. Empty where the model is simulated.
std::string describe_following(const GarmentInScene& loaded, std::span<const sim::Vec3> positions_m);

}  // namespace taut::app
