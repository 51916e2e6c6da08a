#include "sim/rigid_motion.hpp"

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

/// Returns the elapsed time of a shift or a spin, in s.
template <typename Part> double lasted_s(const Part& part, double time_s) {
  return std::max(0.0, std::min(time_s, part.until_s) - part.from_s);
}

/// Returns the rotation about a unit axis through the origin (Rodrigues' formula).
glm::dmat3 rotation(const Vec3& axis, double turns) {
  const double c = cosine_of_turns(turns);
  const Vec3 s = sine_of_turns(turns) * axis;
  const Vec3 k = (1.0 - c) * axis;
  return {Vec3(c + k.x * axis.x, k.x * axis.y + s.z, k.x * axis.z - s.y),
          Vec3(k.y * axis.x - s.z, c + k.y * axis.y, k.y * axis.z + s.x),
          Vec3(k.z * axis.x + s.y, k.z * axis.y - s.x, c + k.z * axis.z)};
}

template <typename Part> bool lasts_after(const Part& part, double time_s) {
  return part.until_s > std::max(time_s, part.from_s);
}

}  // namespace

Vec3 offset_at(const std::vector<PathPoint>& path, double time_s) {
  assert(!std::isnan(time_s));
  const auto next = std::find_if(path.begin(), path.end(), [&](const PathPoint& p) { return p.time_s > time_s; });
  if (next == path.begin() || next == path.end()) {
    return path.empty() ? Vec3(0.0) : next == path.end() ? path.back().offset : next->offset;
  }
  const PathPoint& last = *(next - 1);
  return glm::mix(last.offset, next->offset, (time_s - last.time_s) / (next->time_s - last.time_s));
}

bool changes_after(const std::vector<PathPoint>& path, double time_s) {
  const auto begins_after = [&](const PathPoint& p, const PathPoint& next) {
    return next.time_s > time_s && next.offset != p.offset;
  };
  return std::adjacent_find(path.begin(), path.end(), begins_after) != path.end();
}

Pose pose_at(const RigidMotion& motion, double time_s) {
  assert(!std::isnan(time_s));
  const Spin& spin = motion.spin;
  Pose pose;
  const double turns = spin.turns_per_s * lasted_s(spin, time_s);
  if (turns != 0.0) {
    pose.rotation = rotation(spin.axis, turns);
    pose.offset_m = spin.about_m - pose.rotation * spin.about_m;
  }
  pose.offset_m += motion.shift.velocity_m_per_s * lasted_s(motion.shift, time_s);
  pose.offset_m += offset_at(motion.path, time_s);
  return pose;
}

Vec3 RigidMove::displacement_m(const Vec3& point_m) const {
  if (from_.rotation == to_.rotation) return to_.offset_m - from_.offset_m;
  return to_(from_.to_modelled(point_m)) - point_m;
}

bool is_moving_after(const RigidMotion& motion, double time_s) {
  const bool shifts = motion.shift.velocity_m_per_s != Vec3(0.0) && lasts_after(motion.shift, time_s);
  const bool spins = motion.spin.turns_per_s != 0.0 && lasts_after(motion.spin, time_s);
  return shifts || spins || changes_after(motion.path, time_s);
}

double off_chord_per_jump(double at_s, const TimeSpan& time) {
  return at_s > time.from_s && at_s < time.to_s ? (at_s - time.from_s) * (time.to_s - at_s) / (time.to_s - time.from_s)
                                                : 0.0;
}

double off_chord_m(const RigidMotion& motion, double radius_m, double speed_m_per_s, const TimeSpan& time) {
  assert(radius_m >= 0.0);
  assert(speed_m_per_s >= 0.0);
  assert(time.from_s <= time.to_s);
  const Shift& shift = motion.shift;
  const Spin& spin = motion.spin;
  const auto& path = motion.path;
  const auto begins_and_ends = [&](const auto& part) {
    return off_chord_per_jump(part.from_s, time) + off_chord_per_jump(part.until_s, time);
  };
  double off_m = glm::length(shift.velocity_m_per_s) * begins_and_ends(shift);
  if (spin.turns_per_s != 0.0 && spin.from_s < time.to_s && spin.until_s > time.from_s) {
    const double radians_per_s = 2.0 * std::numbers::pi * std::abs(spin.turns_per_s);
    off_m += radians_per_s * (radians_per_s * radius_m + 2.0 * speed_m_per_s) * off_chord_per_acceleration(time) +
             radians_per_s * radius_m * begins_and_ends(spin);
  }
  const auto velocity = [&](std::size_t k) {  // velocity between points k and k + 1 of the path
    return k + 1 < path.size() ? (path[k + 1].offset - path[k].offset) / (path[k + 1].time_s - path[k].time_s)
                               : Vec3(0.0);
  };
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (const double per_jump = off_chord_per_jump(path[k].time_s, time); per_jump > 0.0) {
      off_m += per_jump * glm::distance(velocity(k), k > 0 ? velocity(k - 1) : Vec3(0.0));
    }
  }
  return off_m;
}

double distance_from_axis_m(const Spin& spin, const Vec3& modelled_m) {
  return glm::length(glm::cross(spin.axis, modelled_m - spin.about_m));
}

}  // namespace taut::sim
