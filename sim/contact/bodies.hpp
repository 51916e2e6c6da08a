#pragma once

#include "sim/rigid_motion.hpp"

namespace taut::sim {

/// Half-space. Cloth stays on the side of the normal.
struct Plane {
  Vec3 point_m = {0.0, 0.0, 0.0};
  Vec3 normal = {0.0, 1.0, 0.0};  ///< unit vector

  bool operator==(const Plane&) const = default;
};

/// Ball; cloth stays outside.
struct Sphere {
  Vec3 centre_m = {0.0, 0.0, 0.0};
  double radius_m = 0.1;

  bool operator==(const Sphere&) const = default;
};

/// Limb: all points near a segment. The radius changes linearly from one end of the segment to the other.
struct Capsule {
  Vec3 start_m = {0.0, 0.0, 0.0};
  Vec3 end_m = {0.0, 1.0, 0.0};
  double start_radius_m = 0.1;
  double end_radius_m = 0.1;

  bool operator==(const Capsule&) const = default;
};

/// Closed surface of triangles that face outwards.
struct BodyMeshData {
  std::vector<Vec3> positions_m;
  std::vector<Triangle> triangles;
};

/// Vertex positions of a deforming surface per frame: linear in between, constant before the first and after the last.
/// Several threads may call it at once. Equal calls return equal results.
class BodyFrames {
 public:
  virtual ~BodyFrames() = default;

  /// Returns the number of frames, at least 1.
  virtual std::size_t count() const = 0;
  /// Returns the frames per second, above 0.
  virtual double rate_hz() const = 0;
  /// Returns the time of the first frame, in s.
  virtual double first_s() const { return 0.0; }
  /// Fills `positions_m` with the vertices' positions in a frame, in m. Requires a frame below count() and one entry
  /// per vertex. Throws the errors of its source.
  virtual void positions_in(std::size_t frame, std::span<Vec3> positions_m) const = 0;
};

/// Body mesh of any shape. Two are equal if they share their arrays and frames.
struct BodyMesh {
  std::shared_ptr<const BodyMeshData> data;       ///< never null
  std::shared_ptr<const BodyFrames> frames = {};  ///< null: the shape is constant

  bool operator==(const BodyMesh&) const = default;
};

using Shape = std::variant<Plane, Sphere, Capsule, BodyMesh>;

/// Body that cloth cannot enter.
struct Body {
  std::string name = {};  ///< for messages
  Shape shape = {};       ///< shape before the motion
  RigidMotion motion = {};
  /// Coulomb's coefficient; the cloth's if not set.
  std::optional<double> friction = {};

  bool operator==(const Body&) const = default;
};

/// Returns the moved shape at this time. Meshes are returned unmoved; see positions_at().
Shape shape_at(const Body& body, double time_s);

/// Fills `positions_m` with the positions of a mesh's vertices at this time, in m. Requires a mesh body and one entry
/// per vertex.
void positions_at(const Body& body, double time_s, std::span<Vec3> positions_m);

/// Returns the position in m, at the second time, of the body point that is at `point_m` at the first. The second time
/// may be the earlier one. Only the rigid motion counts, not the frames of a mesh.
Vec3 point_moved(const Body& body, const Vec3& point_m, const TimeSpan& time);

/// Returns whether the body moves or deforms after this time.
bool is_moving_after(const Body& body, double time_s);

/// Returns a bound in m on the distance of any body point from the chord of its path, at any time of the span. For a
/// plane that tilts it exceeds all other lengths.
double off_chord_m(const Body& body, const TimeSpan& time);

/// Nearest point of a shape's surface, relative to a query point.
struct ShapeSurfacePoint {
  double distance_m;  ///< signed distance from the surface, negative inside
  Vec3 normal;        ///< outward unit normal
};

/// Returns distance and normal of the nearest surface point. On a tapered capsule the point is taken at right angles to
/// the axis, which can slightly overestimate the distance. Meshes count as infinitely far.
ShapeSurfacePoint nearest_surface(const Shape& shape, const Vec3& point);

/// Properties of the cloth for contact with bodies.
struct ClothSurface {
  double thickness_m = 0.0;  ///< distance kept between cloth and bodies
  double friction = 0.0;     ///< Coulomb's coefficient for bodies that have none of their own
};

/// Pushes every free vertex that is predicted closer to a shape than the cloth's thickness out along the normal. Shapes
/// are those at the end of the time step. Friction then takes back sliding over the body since p(t), up to mu times the
/// push (Coulomb's law for positions; Mueller, Heidelberger, Hennix and Ratcliff 2007). Positions are in metres. All
/// spans but `bodies` have one entry per vertex.
void push_out_of_bodies(std::span<const Body> bodies, const ClothSurface& cloth, const TimeSpan& step,
                        std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                        std::span<Vec3> predicted);

}  // namespace taut::sim
