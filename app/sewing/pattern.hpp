#pragma once

#include <filesystem>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// A flat piece of cloth, and where its pattern places it.
struct PatternPanel {
  std::string name;
  /// Per edge, in the order in which they go around the piece: a line from corner to corner, in m. Each
  /// begins where the one before ends.
  std::vector<std::vector<sim::Vec2>> edges_m;
  glm::dmat3 rotation = glm::dmat3(1.0);
  sim::Vec3 translation_m = sim::Vec3(0.0);

  /// Where a point of the piece is placed, in m.
  sim::Vec3 placed_m(const sim::Vec2& flat_m) const { return rotation * sim::Vec3(flat_m, 0.0) + translation_m; }
};

/// An edge of a panel, by their numbers.
struct PanelEdge {
  std::size_t panel = 0;
  std::size_t edge = 0;

  bool operator==(const PanelEdge&) const = default;
};

/// Two edges that are sewn together.
struct Stitch {
  PanelEdge first, second;
};

/// A sewing pattern.
struct SewingPattern {
  std::vector<PatternPanel> panels;
  std::vector<Stitch> stitches;

  const std::vector<sim::Vec2>& line_of(const PanelEdge& edge) const { return panels[edge.panel].edges_m[edge.edge]; }
  /// Per edge of a panel, whether it is sewn to anything.
  std::vector<char> is_stitched(std::size_t panel) const;
  /// Returns these panels, and all that are sewn to them or to each other and that `may_be` holds for.
  std::set<std::size_t> sewn_with(std::set<std::size_t> together, const std::function<bool(std::size_t)>& may_be) const;
  /// Returns "front, edge 3 with back, edge 5".
  std::string describe(const Stitch& stitch) const;
};

/// Adds a pattern whose panels get "NAME." in front of their names.
void add_pattern(const std::string& name, SewingPattern added, SewingPattern& pattern);

/// Reads a pattern in the JSON of GarmentCode (Korosteleva and Sorkine-Hornung 2023) and of its forerunner
/// (Korosteleva and Lee 2021): edges are straight, quadratic or cubic curves of Bezier, arcs, or polylines,
/// which is an addition. Curves become lines that are `line_tolerance_m` off them at most. Comments are
/// passed over. Throws InputError that names the file, the place in it, what was found and what was expected.
SewingPattern read_sewing_pattern(const std::filesystem::path& file);

/// How far a line may be off the curve that it stands for, in m.
inline constexpr double line_tolerance_m = 5e-5;

/// The length of a line, in the unit of its points.
double length_of(const std::vector<sim::Vec2>& line);

/// Returns points of a line at equal distances along it: the ends and `steps` - 1 points between them.
std::vector<sim::Vec2> evenly_along(const std::vector<sim::Vec2>& line, std::size_t steps);

}  // namespace taut::app
