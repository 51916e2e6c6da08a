#pragma once

#include "sim/rigid_motion.hpp"

namespace taut::sim {

/// A half space. Cloth stays on the side that the normal points to.
struct Plane {
  Vec3 point_m = {0.0, 0.0, 0.0};
  Vec3 normal = {0.0, 1.0, 0.0};  ///< of length 1

  bool operator==(const Plane&) const = default;
};

/// Cloth stays outside.
struct Sphere {
  Vec3 centre_m = {0.0, 0.0, 0.0};
  double radius_m = 0.1;

  bool operator==(const Sphere&) const = default;
};

/// A limb: all points near a segment. The radius changes linearly from one end of the segment to the other.
struct Capsule {
  Vec3 start_m = {0.0, 0.0, 0.0};
  Vec3 end_m = {0.0, 1.0, 0.0};
  double start_radius_m = 0.1;
  double end_radius_m = 0.1;

  bool operator==(const Capsule&) const = default;
};

/// A closed surface of triangles that face outwards.
struct BodyMeshData {
  std::vector<Vec3> positions_m;
  std::vector<Triangle> triangles;
};

/// A surface that changes its shape: where each vertex is in each frame, linear in between, held before the
/// first and after the last. Several threads may ask at once, and the same question has the same answer.
class BodyFrames {
 public:
  virtual ~BodyFrames() = default;

  /// Returns how many frames there are, at least 1.
  virtual std::size_t count() const = 0;
  /// Returns how many frames there are in a second, above 0.
  virtual double rate_hz() const = 0;
  /// Returns the time of the first frame, in s.
  virtual double first_s() const { return 0.0; }
  /// Fills `positions_m` with where the vertices of the mesh are in the frame, in m. Requires a frame below
  /// count() and a span with an entry for each vertex. Throws what it reads from throws.
  virtual void positions_in(std::size_t frame, std::span<Vec3> positions_m) const = 0;
};

/// A body of any shape. Two are equal if they share their arrays and frames.
struct BodyMesh {
  std::shared_ptr<const BodyMeshData> data;       ///< never null
  std::shared_ptr<const BodyFrames> frames = {};  ///< null: the shape stays as it is

  bool operator==(const BodyMesh&) const = default;
};

using Shape = std::variant<Plane, Sphere, Capsule, BodyMesh>;

/// A body that the cloth cannot enter.
struct Body {
  std::string name = {};  ///< for messages
  Shape shape = {};       ///< before it moves
  RigidMotion motion = {};
  /// Coulomb's coefficient. Without it, the cloth's own is used.
  std::optional<double> friction = {};

  bool operator==(const Body&) const = default;
};

/// Returns the shape where it is at this time. A mesh is returned unmoved; for it see positions_at().
Shape shape_at(const Body& body, double time_s);

/// Fills `positions_m` with where the vertices of a mesh are at this time, in m. Requires a body that is a
/// mesh and a span with an entry for each of its vertices.
void positions_at(const Body& body, double time_s, std::span<Vec3> positions_m);

/// Returns where the point of the body that is at `point_m` at the first time is at the second, in m. The
/// second may be the earlier one. How a mesh's frames change its shape is left out.
Vec3 point_moved(const Body& body, const Vec3& point_m, const TimeSpan& time);

/// Returns whether the body moves or changes its shape at any time after this one.
bool is_moving_after(const Body& body, double time_s);

/// Returns a bound on how far any point of the body is off the chord of its path at any time of the span, in
/// m, which for a plane that tilts is larger than all else.
double off_chord_m(const Body& body, const TimeSpan& time);

/// A point on the surface of a shape, seen from another point.
struct SurfacePoint {
  double distance_m;  ///< from the surface, negative inside
  Vec3 normal;        ///< of length 1, outwards
};

/// Returns the point of the shape's surface that is nearest to `point`, as distance and normal. On a tapered
/// capsule it is found at right angles to the axis, so that the distance can be slightly larger than the true
/// one. Meshes are not looked at: they are infinitely far.
SurfacePoint nearest_surface(const Shape& shape, const Vec3& point);

/// The properties of the cloth that contact with bodies depends on.
struct ClothSurface {
  double thickness_m = 0.0;  ///< the distance kept between cloth and bodies
  double friction = 0.0;     ///< Coulomb's coefficient for bodies that have none of their own
};

/// Moves every free vertex that is predicted closer to a shape, as it is at the end of the time step, than
/// the cloth's thickness out along the normal. Friction then takes back its sliding over the body's surface
/// since p(t), up to mu times the depth it was pushed (Coulomb's law for positions; Mueller, Heidelberger,
/// Hennix and Ratcliff 2007). Positions are in metres. All spans but `bodies` have one entry per vertex.
void push_out_of_bodies(std::span<const Body> bodies, const ClothSurface& cloth, const TimeSpan& step,
                        std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                        std::span<Vec3> predicted);

}  // namespace taut::sim
