#pragma once

#include "app/garments/fitting/following.hpp"
#include "app/models/hanging/hanging.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "app/models/inspecting/scene_crossings.hpp"
#include "app/models/mending/mending.hpp"
#include "app/models/reading/garment_import.hpp"

namespace taut::app {

/// Distance between borders of different parts that are sewn together by default, in m. In models of panels these
/// borders coincide but for the last digits of their coordinates. Layers of cloth could be taken for seams at a larger
/// distance.
inline constexpr double sewn_within_m = 1e-3;

class ShapeLimits;

/// A model that follows a simulation mesh which was fitted to it. This model is drawn and exported.
struct FollowingModel {
  sim::Mesh mesh;                                   ///< mesh of the model at rest, in m
  FileVertices file_vertices;                       ///< vertices of its file, mapped to `mesh`
  std::vector<Bond> bonds;                          ///< per vertex of `mesh`, its bond to the simulation mesh
  std::shared_ptr<const ShapeLimits> shape_limits;  ///< limits of its shape, whatever its bonds
  std::string description;                          ///< line for people: the mesh that is simulated instead, and why

  /// Returns the positions of `mesh` for positions of the simulated vertices, in m.
  std::vector<sim::Vec3> shown_m(std::span<const sim::Vec3> positions_m,
                                 std::span<const sim::Triangle> simulated) const;
};

/// The simulated garment of a scene.
struct GarmentInScene {
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;                   ///< vertices of the mesh, kinematic ones too
  std::optional<std::vector<sim::Vec3>> start_m;  ///< start positions per vertex; empty: as modelled
  FileVertices file_vertices;  ///< map to the mesh before subdivision, or to the nearest vertices of a fitted mesh
  std::vector<sim::MovingPins> moving_pins = {};         ///< vertices of the mesh
  SurfaceColours colours = {};                           ///< colours of the triangles of shown_mesh()
  std::shared_ptr<const FollowingModel> following = {};  ///< null if the model itself is simulated
  /// Faces of the file, to be written again; empty for a grid and for a subdivided mesh.
  FileFaces file_faces = {};
  std::vector<sim::Vec3> file_rest_m = {};  ///< rest positions per vertex of the file, if `file_faces` are not empty
  /// Metres of cloth at rest for one unit of texture coordinates, from the landmarks' file, or else the median of the
  /// triangles; 0 without coordinates.
  double metres_per_uv = 0.0;
  /// Result of untangling the start; empty if nothing crossed, or if the scene does not ask for it.
  std::optional<UntangleReport> untangling = {};
  std::vector<std::filesystem::path> files_read = {};  ///< files that the scene does not name itself

  /// Returns the mesh that is drawn and exported, at rest.
  const sim::Mesh& shown_mesh() const { return following ? following->mesh : garment->mesh; }
  /// Returns its positions for positions of the simulated vertices, in m.
  std::vector<sim::Vec3> shown_m(std::span<const sim::Vec3> positions_m) const {
    return following ? following->shown_m(positions_m, garment->mesh.triangles)
                     : std::vector<sim::Vec3>(positions_m.begin(), positions_m.end());
  }
};

/// A scene's garment with the results of loading it.
struct LoadedGarment : GarmentInScene {
  Landmarks landmarks;
  // Members for a garment that is read from a model file.
  /// Model with positions, without triangles. The optional members are empty for a grid.
  std::optional<ImportedModel> model;
  std::optional<sim::MeshReport> repairs;
  Strays strays;                       ///< pieces that were left out
  RigidParts rigid;                    ///< parts that are no cloth
  std::size_t trims_sewn_on = 0;       ///< count of parts that lie on others and are held by stitches
  std::string fitting_refusal;         ///< reason why a mesh that was fitted is not the model's cloth; empty if it is
  std::size_t turned_outside_out = 0;  ///< count of triangles of surfaces that faced inwards
  std::optional<Placement> placement;
  std::optional<Hanging> hanging;  ///< empty if the scene names the pins or dresses a body
  std::vector<sim::Body> hanger;   ///< bodies of the hanger if the scene asks for one; see put_on_hanger()
};

/// Callback with the name of each stage when it begins, such as "reading dress.fbx". A large model takes seconds.
using StageReport = std::function<void(const std::string& stage)>;

/// Reads or makes the garment, maps it to springs, finds its landmarks and selects its pins. Throws
/// InputError that names the file or the key.
LoadedGarment load_garment(const Scene& scene, const StageReport& begin = {});

/// Returns the shape in which the garment begins, as a view of the loaded garment.
sim::Surface surface_at_start(const GarmentInScene& loaded);

/// Completes the surroundings of a scene for the simulation: maps the vertices of forces from the file to the mesh, and
/// adds the bodies and the moving pins. Throws InputError for a force at a vertex that does not exist.
sim::Surroundings settle_surroundings(sim::Surroundings surroundings, const GarmentInScene& loaded,
                                      std::vector<sim::Body> bodies);

/// Returns the simulation at its start, in the scene's settled surroundings. Throws std::invalid_argument as
/// sim::Simulation does, and InputError for a force at a vertex that does not exist.
sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded, std::vector<sim::Body> bodies);
/// Returns the same for a scene whose bodies have no meshes of files.
sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
