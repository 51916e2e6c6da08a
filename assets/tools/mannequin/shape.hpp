#pragma once

#include <string>
#include <vector>

#include "sim/mesh/types.hpp"
#include "tailor/mannequin/curve.hpp"

namespace taut::tailor {

using sim::Vec3;

/// Three orthogonal directions: along a part, to its side and to its front.
struct Frame {
  Vec3 origin_m = Vec3(0.0);
  Vec3 along = Vec3(0.0, 1.0, 0.0);
  Vec3 side = Vec3(1.0, 0.0, 0.0);
  Vec3 front = Vec3(0.0, 0.0, 1.0);
};

/// Maps a group of parts from the reference body to another size: lengths along its axis piecewise linearly between
/// landmarks, and lengths across by a factor that varies along the axis.
struct Chain {
  std::string name;
  Frame frame;  ///< frame on the sized body; the reference's differs only by its origin
  Vec3 reference_origin_m = Vec3(0.0);
  std::vector<double> sized_m;      ///< landmarks along the axis, increasing
  std::vector<double> reference_m;  ///< same landmarks on the reference body
  std::vector<double> girths_m;     ///< positions with a factor along the axis of the sized body, increasing
  Curve<1> factor;                  ///< factor across, by the position along the axis of the sized body
  double side_factor = 1.0;         ///< further factor across to the side

  /// Sets the factors at `girths_m`, one for each.
  void set_factors(const std::vector<double>& factors);
  /// Returns the position on the sized body of a point of the reference body.
  Vec3 sized(const Vec3& reference) const;
  /// Returns the position on the reference body of a point of the sized body, and the smallest factor there.
  Vec3 reference(const Vec3& sized, double& factor_there) const;
};

/// A solid along a frame's axis. Its sections are closed curves made of two halves with a common width, one to the
/// front and one to the back.
struct Part {
  std::string name;
  std::size_t chain = 0;
  double blend_m = 0.03;    ///< width over which it flows into the parts before it
  double edge_m = 0.029;    ///< edge length of its triangles
  bool on_midline = false;  ///< crosses x = 0, and has no mirror image
  bool is_hollow = false;   ///< details only: removed instead of added
  Frame frame;              ///< frame on the reference body
  /// Sections by the position along the axis, in metres: centre to the side, centre to the front, squares of half the
  /// width, of the depth to the back and of the depth to the front, and squareness from -1 (lozenge) over 0 (ellipse)
  /// to 1 (rectangle).
  Curve<6> sections;
};

/// A body as a solid, symmetric about x = 0: x to its left, y up, z to the front, in metres.
struct Shape {
  std::vector<Chain> chains;
  std::vector<Part> parts;
  std::vector<Part> details;  ///< features of the face, which are put on the mesh of the parts
};

/// Returns an approximate signed distance to a part alone, in metres, negative inside.
double distance_m(const Shape& shape, const Part& part, const Vec3& point_m);
/// Returns the distance to the whole body above y = 0, whose parts flow into each other.
double distance_m(const Shape& shape, const Vec3& point_m);
/// Returns the distance to all parts of a chain on the left.
double chain_distance_m(const Shape& shape, std::size_t chain, const Vec3& point_m);
/// Returns the shape with its details as parts.
Shape with_details(const Shape& shape);
/// Returns the gradient of `distance_m`.
Vec3 gradient(const Shape& shape, const Vec3& point_m);
/// Returns the point of the surface that Newton's method finds from `point_m`. A point with x = 0 keeps it.
Vec3 on_surface(const Shape& shape, Vec3 point_m);
/// Returns the edge length of triangles at a point of the surface, in metres: the length of the parts there, or less on
/// a strongly bent surface.
double edge_length_m(const Shape& shape, const Vec3& point_m);

}  // namespace taut::tailor
