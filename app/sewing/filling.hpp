#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A flat piece as triangles, counter-clockwise. The points of its outline come first.
struct FilledOutline {
  std::vector<sim::Vec2> points_m;
  std::vector<sim::Triangle> triangles;
};

/// How an outline is filled.
struct Filling {
  /// Of points within, as a share of the length of edges: without it rows would fold along themselves.
  double jitter = 0.3;
  std::size_t more_points = 0;  ///< than the length of edges asks for
};

/// Fills a closed outline, counter-clockwise and its first point not repeated, with triangles that are near
/// equilateral, with edges of about this length. The edges of the outline stay as they are; every other edge
/// has an end within. Throws std::invalid_argument on an outline that crosses or touches itself or goes
/// clockwise.
FilledOutline fill_outline(std::vector<sim::Vec2> outline_m, double edge_m, const Filling& filling = {});

/// The area of a closed outline, above 0 if it is counter-clockwise.
double area_of(const std::vector<sim::Vec2>& outline);

}  // namespace taut::app
