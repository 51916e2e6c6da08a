#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A flat piece as triangles, counter-clockwise. The points of its outline come first.
struct FilledOutline {
  std::vector<sim::Vec2> points_m;
  std::vector<sim::Triangle> triangles;
};

/// Settings of a filling.
struct Filling {
  /// Random shift of inner points, as a fraction of the edge length. Without it, rows would fold along themselves.
  double jitter = 0.3;
  std::size_t more_points = 0;  ///< count of points in addition to those that the edge length needs
};

/// Fills a closed outline with near-equilateral triangles with edges of about `edge_m`. The outline is
/// counter-clockwise, and its first point is not repeated. Its edges are unchanged; every other edge has an end within.
/// Throws std::invalid_argument if the outline crosses or touches itself or is clockwise.
FilledOutline fill_outline(std::vector<sim::Vec2> outline_m, double edge_m, const Filling& filling = {});

/// Returns the area of a closed outline, above 0 if it is counter-clockwise.
double polygon_area(const std::vector<sim::Vec2>& outline);

}  // namespace taut::app
