#pragma once

#include "app/models/garment_loading.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {

/// A landmark and how many vertices it has.
struct LandmarkSize {
  std::string name;
  std::size_t vertices = 0;
};

/// How much the garment is stretched in the shape it begins in.
struct StretchAtStart {
  sim::Stretch springs;
  sim::SurfaceStretch surface;
};

/// The content of a model file and how it maps to springs. Of a model that follows a fitted mesh, parts, springs and
/// what is hung are those of that mesh. All numbers are counts unless a unit is given.
struct Inspection {
  std::string file;
  ImportedModel model;  ///< without its arrays
  sim::MeshReport repairs;
  Placement placement;
  std::vector<HungPart> parts;
  std::vector<std::string> hanging;  ///< how the parts are pinned, for people
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  sim::Vec3 lower_m = {0.0, 0.0, 0.0};  ///< corner of the bounding box
  sim::Vec3 upper_m = {0.0, 0.0, 0.0};  ///< the opposite corner
  double area_m2 = 0.0;
  double shortest_edge_m = 0.0;
  double mean_edge_m = 0.0;
  double longest_edge_m = 0.0;
  double smallest_angle_rad = 0.0;
  std::size_t without_surface = 0;       ///< triangles that sim::TriangleAtRest finds too thin to have one
  std::optional<StretchAtStart> start;   ///< empty if the scene names no start: it begins at rest
  std::vector<CrossingPair> crossings;   ///< in the shape it begins in
  std::string crossings_text;            ///< the same for people
  std::optional<Untangling> untangling;  ///< of what crossed before; empty if nothing was moved apart
  std::string texture;                   ///< texture coordinates and images, for people
  sim::Topology topology;
  std::size_t structural_springs = 0;
  std::size_t shear_springs = 0;
  std::size_t flexural_springs = 0;
  std::string simulated;             ///< the mesh that is simulated in place of the model, for people; empty: none
  std::size_t fitted_triangles = 0;  ///< of that mesh
  std::vector<LandmarkSize> landmarks;
  std::string vertex_numbers;        ///< what the numbers in the key pins.at count
  std::vector<std::string> remarks;  ///< what the user should check
};

/// The garment must have been read from a file.
Inspection inspect_garment(const Scene& scene, const LoadedGarment& loaded);

/// The inspection as text for people.
std::string describe(const Inspection& inspection);

/// Guesses, repairs and choices that the scene does not make, one line each.
std::vector<std::string> remarks_of(const LoadedGarment& loaded);

/// Faults of the shape the cloth begins in.
struct StartRemarks {
  std::vector<std::string> lines;  ///< for people
  std::size_t crossings = 0;       ///< pairs of triangles that cross, and parts of cloth wholly within bodies
};

/// Says what is wrong: triangles that cross, triangles and pins in bodies, and bodies that cross themselves.
StartRemarks remarks_on_start(const Scene& scene, const GarmentInScene& loaded);
/// The same of one of the bodies and cloth that is here at this time.
StartRemarks remarks_on_body(std::span<const sim::Body> bodies, std::size_t body, double time_s, const Surface& cloth,
                             std::span<const sim::Index> pins);

/// Prints both after the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output = stdout);

}  // namespace taut::app
