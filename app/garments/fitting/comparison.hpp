#pragma once

#include "app/garments/fitting/fitted_mesh.hpp"

namespace taut::app {

/// Limits within which a fitted mesh is the model's cloth.
struct ComparisonLimits {
  /// Smallest area, as a fraction of the cloth's. More refuses meshes that smooth fine folds; less accepts lost panels.
  double min_area_fraction = 0.82;
  /// Largest such area. Less refuses meshes with joined gaps; more accepts folds and flaps that the model does not
  /// have.
  double max_area_fraction = 1.1;
  /// Largest fraction of the borders' length that runs along no border, rim or crease of the model. Less refuses meshes
  /// whose inner wall ends beside the rim; more accepts holes.
  double max_torn_fraction = 0.15;
  /// Distance within which a border runs along another, as a fraction of the size. Less counts rounded corners as torn;
  /// more overlooks holes beside borders.
  double border_distance_fraction = 0.025;
  /// Largest 99th percentile of the distance from the model to the mesh, and of the distance back, as a fraction of the
  /// size. Less refuses trims that stand off; more accepts lost panels and closed openings.
  double max_distance_fraction = 0.035;
  /// Largest number of crossing pairs beyond the model's, as a fraction of the triangles. Less refuses meshes that can
  /// be untangled; more accepts shreds.
  double max_added_crossing_fraction = 0.02;
  /// Largest number of crossing pairs, the model's included, as a fraction of the triangles. Less refuses models in
  /// many layers; more begins runs that break their promise.
  double max_crossing_fraction = 0.5;
};

/// Measures of a fitted mesh beside its model.
struct FittingComparison {
  double area_fraction = 0.0;            ///< area of the mesh, as a fraction of the cloth's
  double torn_fraction = 0.0;            ///< fraction of the borders' length that runs along nothing in the model
  std::size_t parts = 0;                 ///< count of connected parts of the mesh
  std::size_t model_parts = 0;           ///< count of sheets of the model's cloth
  double distance_from_model = 0.0;      ///< 99th percentile over the model's area, as a fraction of the size
  double distance_to_model = 0.0;        ///< 99th percentile over the mesh's area, as a fraction of the size
  std::size_t triangles = 0;             ///< count of triangles of the mesh
  std::size_t crossings = 0;             ///< count of crossing pairs of the mesh
  std::size_t model_crossings = 0;       ///< count of crossing pairs of the model
  double added_crossing_fraction = 0.0;  ///< crossings beyond the model's, over the triangles of the mesh
};

/// Compares a fitted mesh with its model at a few thousand points, the same in every run. Requires triangles
/// in both.
FittingComparison compare_with_model(const sim::Mesh& model_m, std::size_t model_crossings, const FittedMesh& fitted,
                                     const ComparisonLimits& limits = {});

/// Returns for people what differs, what was found and what was expected; nothing if the mesh is the model's cloth.
std::optional<std::string> why_not_the_model(const FittingComparison& comparison, const ComparisonLimits& limits = {});

}  // namespace taut::app
