#pragma once

#include "app/fitting/following.hpp"
#include "app/models/garment_import.hpp"
#include "app/models/hanging.hpp"
#include "app/models/landmarks.hpp"
#include "app/models/mending.hpp"
#include "app/models/scene_crossings.hpp"

namespace taut::app {

/// Distance between borders of different parts that are sewn together where the scene does not say, in m.
/// Models of panels have them within the last digits of their coordinates; larger, layers of cloth could be
/// taken for seams.
inline constexpr double sewn_within_m = 1e-3;

class OffsetLimits;

/// A model that follows a simulation mesh which was fitted to it. It is what is drawn and exported.
struct FollowingModel {
  sim::Mesh mesh;                              ///< at rest, in m
  FileVertices file_vertices;                  ///< vertices of its file, in `mesh`
  std::vector<Bond> bonds;                     ///< per vertex of `mesh`, to the simulation mesh
  std::shared_ptr<const OffsetLimits> limits;  ///< of the offsets in `bonds`
  std::string why;                             ///< the model itself is not simulated
  std::size_t carried = 0;                     ///< triangles that are no part of the wall which is simulated

  CarriedVertices carried_vertices;  ///< of `mesh`

  /// The positions of `mesh`, for those of the simulated vertices, in m.
  std::vector<sim::Vec3> shown_m(std::span<const sim::Vec3> positions_m,
                                 std::span<const sim::Triangle> simulated) const;
};

/// A scene's garment as it is simulated.
struct GarmentInScene {
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;                   ///< vertices of the mesh, those that are led too
  std::optional<std::vector<sim::Vec3>> start_m;  ///< positions at the start, per vertex; empty: as modelled
  FileVertices file_vertices;  ///< For the mesh before subdivision. Of a grid: all its vertices. Of a model that
                               ///< follows: the nearest ones of the simulation mesh.
  std::vector<sim::MovingPins> moving_pins = {};         ///< vertices of the mesh
  SurfaceColours colours = {};                           ///< of the triangles of shown_mesh()
  std::shared_ptr<const FollowingModel> following = {};  ///< null: the model itself is simulated
  /// Of its file, to be written again; empty of a grid and of a mesh that was subdivided.
  FileFaces file_faces = {};
  std::vector<sim::Vec3> file_rest_m = {};  ///< per vertex of the file, where `file_faces` are not empty
  /// Metres of the cloth at rest for one unit of texture coordinates, as the landmarks' file says, or else the
  /// median of the triangles; 0 without coordinates.
  double metres_per_uv = 0.0;
  /// Of what crossed at the start; empty if nothing did, or the scene does not ask for it.
  std::optional<Untangling> untangling = {};
  std::vector<std::filesystem::path> files_read = {};  ///< besides those that the scene names

  /// The mesh that is drawn and exported, at rest.
  const sim::Mesh& shown_mesh() const { return following ? following->mesh : garment->mesh; }
  /// Its positions, for those of the simulated vertices, in m.
  std::vector<sim::Vec3> shown_m(std::span<const sim::Vec3> positions_m) const {
    return following ? following->shown_m(positions_m, garment->mesh.triangles)
                     : std::vector<sim::Vec3>(positions_m.begin(), positions_m.end());
  }
};

/// A scene's garment with all that was found out about it.
struct LoadedGarment : GarmentInScene {
  Landmarks landmarks;
  // For a model file; a grid is made, not read.
  /// With positions, without triangles; the optional members are empty for a grid.
  std::optional<ImportedModel> model;
  std::optional<sim::MeshReport> repairs;
  Strays strays;                       ///< what was left out
  std::size_t trims_sewn_on = 0;       ///< parts that lie on others and are held by stitches
  std::size_t refused_crossings = 0;   ///< of a mesh that was fitted and crosses itself more than the model; or 0
  std::size_t turned_outside_out = 0;  ///< triangles of surfaces that faced inwards
  std::optional<Placement> placement;
  std::optional<Hanging> hanging;  ///< empty if the scene names the pins or dresses a body
  std::vector<sim::Body> hanger;   ///< what it hangs on if the scene asks for one; see put_on_hanger()
};

/// Called with the name of each stage when it begins, such as "reading dress.fbx". A large model takes
/// seconds.
using StageReport = std::function<void(const std::string& stage)>;

/// Reads or makes the garment, maps it to springs, finds its landmarks and selects its pins. Throws
/// InputError that names the file or the key.
LoadedGarment load_garment(const Scene& scene, const StageReport& begin = {});

/// Returns the shape that the garment begins in. It refers to what was loaded.
Surface surface_at_start(const GarmentInScene& loaded);

/// Completes the surroundings of a scene for the simulation. Changes the vertices of forces from numbers of
/// the file to those of the mesh, and adds the moving pins. Throws InputError for a force at a vertex that
/// does not exist.
sim::Surroundings settled(sim::Surroundings surroundings, const GarmentInScene& loaded);

/// Returns the simulation at its start, in the scene's settled surroundings. Throws std::invalid_argument as
/// sim::Simulation does, and InputError for a force at a vertex that does not exist.
sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
