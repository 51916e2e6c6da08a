#pragma once

#include <filesystem>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// A flat piece of cloth and its placement in the pattern.
struct PatternPanel {
  std::string name;
  /// Per edge, in order around the piece: a polyline from corner to corner, in m. Each begins where the one before
  /// ends.
  std::vector<std::vector<sim::Vec2>> edges_m;
  glm::dmat3 rotation = glm::dmat3(1.0);
  sim::Vec3 translation_m = sim::Vec3(0.0);

  /// Returns the placed position of a point of the piece, in m.
  sim::Vec3 placed_m(const sim::Vec2& flat_m) const { return rotation * sim::Vec3(flat_m, 0.0) + translation_m; }
};

/// Indices of an edge and its panel.
struct PanelEdge {
  std::size_t panel = 0;
  std::size_t edge = 0;

  bool operator==(const PanelEdge&) const = default;
};

/// Two edges that are sewn together.
struct Stitch {
  PanelEdge first, second;
};

struct SewingPattern {
  std::vector<PatternPanel> panels;
  std::vector<Stitch> stitches;
  std::string joint =
      {};  ///< joint of the body at the pattern's origin (parts_of_joints()); empty: the garment decides

  const std::vector<sim::Vec2>& line_of(const PanelEdge& edge) const { return panels[edge.panel].edges_m[edge.edge]; }
  /// Returns the placed positions of an edge's ends, in m.
  std::pair<sim::Vec3, sim::Vec3> placed_ends_m(const PanelEdge& edge) const;
  /// Returns all edges, panel by panel.
  std::vector<PanelEdge> edges() const;
  /// Returns the edges that are sewn to nothing, panel by panel.
  std::vector<PanelEdge> unsewn_edges() const;
  /// Returns these panels and all panels that are connected to them by stitches and satisfy `may_be`.
  std::set<std::size_t> sewn_with(std::set<std::size_t> together, const std::function<bool(std::size_t)>& may_be) const;
  /// Returns "front, edge 3 with back, edge 5".
  std::string describe(const Stitch& stitch) const;
};

/// Adds a pattern. The names of its panels get the prefix "NAME.".
void add_pattern(const std::string& name, SewingPattern added, SewingPattern& pattern);

/// Reads a pattern in the JSON of GarmentCode (Korosteleva and Sorkine-Hornung 2023) and of its forerunner (Korosteleva
/// and Lee 2021). Edges are straight, quadratic or cubic Bezier curves, arcs, or, as an addition, polylines. Curves
/// become polylines with an error of at most `line_tolerance_m`. Comments are skipped. Throws InputError that names the
/// file, the place in it, and the found and the expected content.
SewingPattern read_sewing_pattern(const std::filesystem::path& file);

/// Largest distance of a polyline from its curve, in m.
inline constexpr double line_tolerance_m = 5e-5;

/// Returns the length of a polyline, in the unit of its points.
double polyline_length(const std::vector<sim::Vec2>& line);

/// Returns points of a polyline at equal distances along it: the ends and `steps` - 1 points between them.
std::vector<sim::Vec2> evenly_along(const std::vector<sim::Vec2>& line, std::size_t steps);

}  // namespace taut::app
