#pragma once

#include <string>
#include <vector>

#include "sim/mesh/types.hpp"
#include "tailor/mannequin/curve.hpp"

namespace taut::tailor {

using sim::Vec3;

/// Three directions at right angles: along a part, to its side and to its front.
struct Frame {
  Vec3 origin_m = Vec3(0.0);
  Vec3 along = Vec3(0.0, 1.0, 0.0);
  Vec3 side = Vec3(1.0, 0.0, 0.0);
  Vec3 front = Vec3(0.0, 0.0, 1.0);
};

/// How a group of parts of the reference body is brought to the size of another: lengths along its axis by
/// straight pieces between landmarks, and what is across by a factor that varies along it.
struct Chain {
  std::string name;
  Frame frame;  ///< on the sized body; the reference's differs by its origin
  Vec3 reference_origin_m = Vec3(0.0);
  std::vector<double> sized_m;      ///< landmarks along the axis, increasing
  std::vector<double> reference_m;  ///< the same landmarks on the reference body
  std::vector<double> girths_m;     ///< places along the axis of the sized body with a factor, increasing
  Curve<1> factor;                  ///< across, of the place along the axis of the sized body
  double side_factor = 1.0;         ///< across to the side, besides

  /// Sets the factors at `girths_m`, as many as those.
  void set_factors(const std::vector<double>& factors);
  /// Returns where a point of the reference body is on the sized one.
  Vec3 sized(const Vec3& reference) const;
  /// Returns where a point of the sized body is on the reference, and the smallest factor there.
  Vec3 reference(const Vec3& sized, double& factor_there) const;
};

/// A part: a solid along a frame's axis. Its sections are closed curves made of two halves with a common
/// width, one to the front and one to the back.
struct Part {
  std::string name;
  std::size_t chain = 0;
  double blend_m = 0.03;    ///< the width over which it flows into the parts before it
  double edge_m = 0.029;    ///< of the triangles there
  bool on_midline = false;  ///< goes through x = 0, and is there once and not twice
  bool is_hollow = false;   ///< of a detail: taken away instead of added
  Frame frame;              ///< on the reference body
  /// At the place along the axis, in metres: centre to the side, centre to the front, the squares of half the
  /// width, of the depth to the back and of that to the front, squareness from -1 (lozenge) over 0 (ellipse)
  /// to 1 (rectangle).
  Curve<6> sections;
};

/// A body as a solid: x to its left, y up, z to the front, in metres, the mirror image of itself at x = 0.
struct Shape {
  std::vector<Chain> chains;
  std::vector<Part> parts;
  std::vector<Part> details;  ///< features of the face, which are put on the mesh of the parts
};

/// Returns a signed measure of the distance to a part alone, in metres, negative inside.
double distance_m(const Shape& shape, const Part& part, const Vec3& point_m);
/// Returns the same of the whole body above y = 0, parts flowing into each other.
double distance_m(const Shape& shape, const Vec3& point_m);
/// Returns the same of all parts of a chain on the left.
double chain_distance_m(const Shape& shape, std::size_t chain, const Vec3& point_m);
/// Returns the shape whose parts are all parts and details.
Shape with_details(const Shape& shape);
/// Returns the direction of the fastest growth of `distance_m`, times that growth.
Vec3 gradient(const Shape& shape, const Vec3& point_m);
/// Returns the point of the surface that Newton's method finds from there; one of x = 0 stays there.
Vec3 on_surface(const Shape& shape, Vec3 point_m);
/// Returns how long edges of triangles shall be at a point of the surface, in metres: what the parts there
/// ask for, or less where it is strongly bent.
double edge_length_m(const Shape& shape, const Vec3& point_m);

}  // namespace taut::tailor
