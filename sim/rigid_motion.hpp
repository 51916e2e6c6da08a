#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// From an earlier time to a later one, in seconds.
struct TimeSpan {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Moves along a line at a constant speed from one time to another.
struct Shift {
  Vec3 velocity_m_per_s = {0.0, 0.0, 0.0};
  double from_s = 0.0;
  double until_s = std::numeric_limits<double>::infinity();

  bool operator==(const Shift&) const = default;
};

/// Turns about a fixed line at a constant rate from one time to another.
struct Spin {
  Vec3 about_m = {0.0, 0.0, 0.0};  ///< a point of the line
  Vec3 axis = {0.0, 1.0, 0.0};     ///< its direction, of length 1; counter-clockwise seen from where it points
  double turns_per_s = 0.0;
  double from_s = 0.0;
  double until_s = std::numeric_limits<double>::infinity();

  bool operator==(const Spin&) const = default;
};

/// The offset of something from its usual place or value at one time: in m, or in the unit of that value.
struct PathPoint {
  double time_s = 0.0;
  Vec3 offset = {0.0, 0.0, 0.0};

  bool operator==(const PathPoint&) const = default;
};

/// How something rigid moves. It is turned first; then both the shift and the path's offset are added.
struct RigidMotion {
  Shift shift = {};
  Spin spin = {};
  /// Offsets at rising times, linear in between and held before the first and after the last.
  std::vector<PathPoint> path = {};

  bool operator==(const RigidMotion&) const = default;
};

/// Returns the offset at this time: linear between points, held before the first and after the last; 0
/// without points. Requires rising times.
Vec3 offset_at(const std::vector<PathPoint>& path, double time_s);

/// Returns whether the offset changes at any time after this one.
bool changes_after(const std::vector<PathPoint>& path, double time_s);

/// Where something rigid is: the point that was modelled at p is at rotation * p + offset_m.
struct Pose {
  glm::dmat3 rotation = glm::dmat3(1.0);
  Vec3 offset_m = {0.0, 0.0, 0.0};

  Vec3 operator()(const Vec3& modelled_m) const { return rotation * modelled_m + offset_m; }
  /// Returns where the point was modelled that is at `point_m`.
  Vec3 modelled(const Vec3& point_m) const { return glm::transpose(rotation) * (point_m - offset_m); }
};

/// Returns the pose at this time. Requires a path whose times rise.
Pose pose_at(const RigidMotion& motion, double time_s);

/// The motion between two times.
class RigidMove {
 public:
  RigidMove(const RigidMotion& motion, const TimeSpan& time)
      : from_(pose_at(motion, time.from_s)), to_(pose_at(motion, time.to_s)) {}

  /// Returns how far the point that is at `point_m` at the first time has moved at the second, in m. Exactly
  /// 0 if nothing moves in between.
  Vec3 displacement_m(const Vec3& point_m) const;

 private:
  Pose from_;
  Pose to_;
};

/// Returns whether it moves at any time after this one.
bool is_moving_after(const RigidMotion& motion, double time_s);

// A path x(t) whose acceleration is at most a, but for jumps J_k of its velocity at times s_k, is off its
// chord by at most a T^2 / 8 + sum of J_k (s_k - from) (to - s_k) / T at any time of a span of length T:
// Green's function of x'' on the span is at most T / 4, and its integral at most T^2 / 8.

/// Returns how far a jump of the velocity by 1 m/s at this time takes a path off its chord, in m: 0 outside
/// of the span.
double off_chord_per_jump(double at_s, const TimeSpan& time);
/// Returns how far an acceleration of 1 m/s^2 takes a path off its chord, in m.
inline double off_chord_per_acceleration(const TimeSpan& time) {
  return (time.to_s - time.from_s) * (time.to_s - time.from_s) / 8.0;
}

/// Returns a bound on how far a point is off the chord of its path at any time of the span, in m, that is up
/// to `radius_m` from the axis of the spin and goes at `speed_m_per_s` before it is moved.
double off_chord_m(const RigidMotion& motion, double radius_m, double speed_m_per_s, const TimeSpan& time);

/// Returns how far a point is from the axis, in m, before it is moved.
double distance_from_axis_m(const Spin& spin, const Vec3& modelled_m);

}  // namespace taut::sim
