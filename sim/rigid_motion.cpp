#include "sim/rigid_motion.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

/// Returns how long the shift or the spin has lasted, in s.
template <typename Part>
double lasted_s(const Part& part, double time_s) {
  return std::max(0.0, std::min(time_s, part.until_s) - part.from_s);
}

/// Rodrigues' formula: a turn about an axis of length 1 through the origin.
glm::dmat3 rotation(const Vec3& axis, double turns) {
  const double c = cosine_of_turns(turns);
  const Vec3 s = sine_of_turns(turns) * axis;
  const Vec3 k = (1.0 - c) * axis;
  return {Vec3(c + k.x * axis.x, k.x * axis.y + s.z, k.x * axis.z - s.y),
          Vec3(k.y * axis.x - s.z, c + k.y * axis.y, k.y * axis.z + s.x),
          Vec3(k.z * axis.x + s.y, k.z * axis.y - s.x, c + k.z * axis.z)};
}

template <typename Part>
bool lasts_after(const Part& part, double time_s) {
  return part.until_s > std::max(time_s, part.from_s);
}

}  // namespace

Vec3 offset_at(const std::vector<PathPoint>& path, double time_s) {
  const auto next =
      std::find_if(path.begin(), path.end(), [&](const PathPoint& p) { return p.time_s > time_s; });
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
  if (from_.rotation == to_.rotation) {
    return to_.offset_m - from_.offset_m;
  }
  return to_(glm::transpose(from_.rotation) * (point_m - from_.offset_m)) - point_m;
}

bool is_moving_after(const RigidMotion& motion, double time_s) {
  const bool shifts = motion.shift.velocity_m_per_s != Vec3(0.0) && lasts_after(motion.shift, time_s);
  const bool spins = motion.spin.turns_per_s != 0.0 && lasts_after(motion.spin, time_s);
  return shifts || spins || changes_after(motion.path, time_s);
}

}  // namespace taut::sim
