#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Interval of time, in seconds.
struct TimeSpan {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Motion along a line at a constant speed from one time to another.
struct Shift {
  Vec3 velocity_m_per_s = {0.0, 0.0, 0.0};
  double from_s = 0.0;
  double until_s = std::numeric_limits<double>::infinity();

  bool operator==(const Shift&) const = default;
};

/// Rotation about a fixed line at a constant rate from one time to another.
struct Spin {
  Vec3 about_m = {0.0, 0.0, 0.0};  ///< point on the line
  Vec3 axis = {0.0, 1.0, 0.0};     ///< unit direction; the spin is counter-clockwise seen from its tip
  double turns_per_s = 0.0;
  double from_s = 0.0;
  double until_s = std::numeric_limits<double>::infinity();

  bool operator==(const Spin&) const = default;
};

/// Offset from a usual position or value at one time, in m or in the unit of the value.
struct PathPoint {
  double time_s = 0.0;
  Vec3 offset = {0.0, 0.0, 0.0};

  bool operator==(const PathPoint&) const = default;
};

/// Rigid motion: the spin acts first, then the shift and the path's offset are added.
struct RigidMotion {
  Shift shift = {};
  Spin spin = {};
  /// Offsets at rising times, linear in between and constant before the first and after the last.
  std::vector<PathPoint> path = {};

  bool operator==(const RigidMotion&) const = default;
};

/// Returns the offset at this time: linear between points, constant before the first and after the last; 0 without
/// points. Requires rising times.
Vec3 offset_at(const std::vector<PathPoint>& path, double time_s);

/// Returns whether the offset changes at any time after this one.
bool changes_after(const std::vector<PathPoint>& path, double time_s);

/// Rigid pose: a point modelled at p is at rotation * p + offset_m.
struct Pose {
  glm::dmat3 rotation = glm::dmat3(1.0);
  Vec3 offset_m = {0.0, 0.0, 0.0};

  Vec3 operator()(const Vec3& modelled_m) const { return rotation * modelled_m + offset_m; }
  /// Returns the modelled position of the point that is now at `point_m`.
  Vec3 to_modelled(const Vec3& point_m) const { return glm::transpose(rotation) * (point_m - offset_m); }
};

/// Requires a path whose times rise.
Pose pose_at(const RigidMotion& motion, double time_s);

/// The motion between two times.
class RigidMove {
 public:
  RigidMove(const RigidMotion& motion, const TimeSpan& time)
      : from_(pose_at(motion, time.from_s)), to_(pose_at(motion, time.to_s)) {}

  /// Returns the displacement in m, between the two times, of the point at `point_m` at the first. Exactly 0 if nothing
  /// moves.
  Vec3 displacement_m(const Vec3& point_m) const;

 private:
  Pose from_;
  Pose to_;
};

/// Returns whether anything moves after this time.
bool is_moving_after(const RigidMotion& motion, double time_s);

// A path x(t) has an acceleration of at most a, and its velocity jumps by J_k at times s_k. In a span of length T its
// distance from its chord is at most a T^2 / 8 + sum of J_k (s_k - from) (to - s_k) / T: Green's function of x'' is at
// most T / 4, and its integral at most T^2 / 8.

/// Returns the largest distance in m from the chord after a velocity jump of 1 m/s at this time; 0 outside the span.
double off_chord_per_jump(double at_s, const TimeSpan& time);
/// Returns the largest distance in m from the chord for an acceleration of 1 m/s^2.
inline double off_chord_per_acceleration(const TimeSpan& time) {
  return (time.to_s - time.from_s) * (time.to_s - time.from_s) / 8.0;
}

/// Returns a bound in m on the distance of a point from the chord of its path, at any time of the span. Before the
/// motion the point is at most `radius_m` from the axis of the spin and moves at `speed_m_per_s`.
double off_chord_m(const RigidMotion& motion, double radius_m, double speed_m_per_s, const TimeSpan& time);

/// Returns the distance in m of a point from the axis, before the motion.
double distance_from_axis_m(const Spin& spin, const Vec3& modelled_m);

}  // namespace taut::sim
