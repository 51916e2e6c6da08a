#include "sim/contact/bodies.hpp"

#include "sim/contact/law.hpp"

namespace taut::sim {
namespace {

ShapeSurfacePoint from_centre(const Vec3& centre, double radius_m, const Vec3& point) {
  const Vec3 outwards = point - centre;
  const double length = glm::length(outwards);
  // All directions out of the centre are equally short; up is as good as any.
  const Vec3 normal = length > 0.0 ? outwards / length : Vec3(0.0, 1.0, 0.0);
  return {length - radius_m, normal};
}

ShapeSurfacePoint find_nearest_point(const Plane& plane, const Vec3& point) {
  return {glm::dot(point - plane.point_m, plane.normal), plane.normal};
}

ShapeSurfacePoint find_nearest_point(const Sphere& sphere, const Vec3& point) {
  return from_centre(sphere.centre_m, sphere.radius_m, point);
}

ShapeSurfacePoint find_nearest_point(const Capsule& capsule, const Vec3& point) {
  const Vec3 axis = capsule.end_m - capsule.start_m;
  const double squared_length = glm::dot(axis, axis);
  const double along =
      squared_length > 0.0 ? std::clamp(glm::dot(point - capsule.start_m, axis) / squared_length, 0.0, 1.0) : 0.0;
  const double radius_m = capsule.start_radius_m + along * (capsule.end_radius_m - capsule.start_radius_m);
  return from_centre(capsule.start_m + along * axis, radius_m, point);
}

ShapeSurfacePoint find_nearest_point(const BodyMesh&, const Vec3&) {
  return {std::numeric_limits<double>::infinity(), Vec3(0.0, 1.0, 0.0)};
}

struct Mover {
  const Pose& pose;

  Shape operator()(const Plane& plane) const { return Plane{pose(plane.point_m), pose.rotation * plane.normal}; }
  Shape operator()(const Sphere& ball) const { return Sphere{pose(ball.centre_m), ball.radius_m}; }
  Shape operator()(const Capsule& limb) const {
    return Capsule{pose(limb.start_m), pose(limb.end_m), limb.start_radius_m, limb.end_radius_m};
  }
  Shape operator()(const BodyMesh& mesh) const { return mesh; }
};

void shape_of_frames(const BodyFrames& frames, double time_s, std::span<Vec3> positions_m) {
  assert(frames.count() > 0);
  assert(frames.rate_hz() > 0.0);
  assert(std::isfinite(time_s));
  const auto last = static_cast<double>(frames.count() - 1);
  const double at = std::clamp((time_s - frames.first_s()) * frames.rate_hz(), 0.0, last);
  const double before = std::floor(at);
  frames.positions_in(static_cast<std::size_t>(before), positions_m);
  std::vector<Vec3> to(positions_m.size());
  frames.positions_in(static_cast<std::size_t>(std::min(before + 1.0, last)), to);
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    positions_m[v] = glm::mix(positions_m[v], to[v], at - before);
  }
}

/// Motion of a mesh's vertices from frame to frame within a span.
struct FrameMotion {
  double off_chord_m = 0.0;
  double radius_m = 0.0;  ///< largest distance from the axis of the spin
  double speed_m_per_s = 0.0;
};

// Velocities jump at frames by the second difference of the positions.
FrameMotion measure_frame_motion(const BodyMesh& mesh, const Spin& spin, const TimeSpan& time) {
  const BodyFrames& frames = *mesh.frames;
  const auto last = static_cast<double>(frames.count() - 1);
  const auto frame_at = [&](double time_s) {
    return std::clamp((time_s - frames.first_s()) * frames.rate_hz(), 0.0, last);
  };
  const auto positions_in = [&](double frame) {
    std::vector<Vec3> positions_m(mesh.data->positions_m.size());
    frames.positions_in(static_cast<std::size_t>(std::clamp(frame, 0.0, last)), positions_m);
    return positions_m;
  };
  // Rounding at the ends of the span must not count as a jump.
  constexpr double min_jump_s = 1e-12;
  FrameMotion ways;
  for (double frame = std::floor(frame_at(time.from_s)); frame <= std::ceil(frame_at(time.to_s)); ++frame) {
    const double per_jump = off_chord_per_jump(frames.first_s() + frame / frames.rate_hz(), time);
    if (spin.turns_per_s == 0.0 && per_jump < min_jump_s) continue;
    const std::vector<Vec3> before_m = positions_in(frame - 1.0);
    const std::vector<Vec3> at_m = positions_in(frame);
    const std::vector<Vec3> after_m = positions_in(frame + 1.0);
    double jump_m = 0.0;
    for (std::size_t v = 0; v < at_m.size(); ++v) {
      jump_m = std::max(jump_m, glm::length(after_m[v] - 2.0 * at_m[v] + before_m[v]));
      ways.radius_m = std::max(ways.radius_m, distance_from_axis_m(spin, at_m[v]));
      ways.speed_m_per_s = std::max(ways.speed_m_per_s, frames.rate_hz() * glm::distance(at_m[v], before_m[v]));
    }
    ways.off_chord_m += per_jump * frames.rate_hz() * jump_m;
  }
  return ways;
}

/// Returns the largest distance in m of a shape's points from the axis of the spin. The ends of a limb suffice, as its
/// radii turn with it.
struct MaxAxisDistance {
  const Spin& spin;

  double operator()(const Plane& plane) const {
    constexpr double endless_m = 1e9;
    return glm::cross(plane.normal, spin.axis) == Vec3(0.0) ? 0.0 : endless_m;
  }
  double operator()(const Sphere& ball) const { return distance_from_axis_m(spin, ball.centre_m); }
  double operator()(const Capsule& limb) const {
    return std::max(distance_from_axis_m(spin, limb.start_m), distance_from_axis_m(spin, limb.end_m));
  }
  double operator()(const BodyMesh& mesh) const {
    double max_distance_m = 0.0;
    for (const Vec3& position_m : mesh.data->positions_m) {
      max_distance_m = std::max(max_distance_m, distance_from_axis_m(spin, position_m));
    }
    return max_distance_m;
  }
};

/// `moved` is the motion of the vertex relative to the body.
Vec3 with_friction(double friction, const ShapeSurfacePoint& surface, double depth_m, const Vec3& moved,
                   const Vec3& pushed_out) {
  assert(friction >= 0.0);
  const Vec3 slid = moved - surface.normal * glm::dot(moved, surface.normal);
  return pushed_out - slid * stopped_share(friction, depth_m, glm::length(slid));
}

}  // namespace

ShapeSurfacePoint nearest_surface(const Shape& shape, const Vec3& point) {
  return std::visit([&](const auto& s) { return find_nearest_point(s, point); }, shape);
}

Shape shape_at(const Body& body, double time_s) { return std::visit(Mover{pose_at(body.motion, time_s)}, body.shape); }

void positions_at(const Body& body, double time_s, std::span<Vec3> positions_m) {
  const auto& mesh = std::get<BodyMesh>(body.shape);
  assert(positions_m.size() == mesh.data->positions_m.size());
  if (mesh.frames) {
    shape_of_frames(*mesh.frames, time_s, positions_m);
  } else {
    std::copy(mesh.data->positions_m.begin(), mesh.data->positions_m.end(), positions_m.begin());
  }
  const Pose pose = pose_at(body.motion, time_s);
  for (Vec3& position_m : positions_m) position_m = pose(position_m);
}

Vec3 point_moved(const Body& body, const Vec3& point_m, const TimeSpan& time) {
  return point_m + RigidMove(body.motion, time).displacement_m(point_m);
}

bool is_moving_after(const Body& body, double time_s) {
  assert(!std::isnan(time_s));
  const auto* mesh = std::get_if<BodyMesh>(&body.shape);
  const bool changes =
      mesh != nullptr && mesh->frames &&
      static_cast<double>(mesh->frames->count() - 1) > (time_s - mesh->frames->first_s()) * mesh->frames->rate_hz();
  return changes || is_moving_after(body.motion, time_s);
}

double off_chord_m(const Body& body, const TimeSpan& time) {
  assert(time.from_s <= time.to_s);
  const auto* mesh = std::get_if<BodyMesh>(&body.shape);
  FrameMotion ways;
  if (mesh != nullptr && mesh->frames) {
    ways = measure_frame_motion(*mesh, body.motion.spin, time);
  } else if (body.motion.spin.turns_per_s != 0.0) {
    ways.radius_m = std::visit(MaxAxisDistance{body.motion.spin}, body.shape);
  }
  return ways.off_chord_m + off_chord_m(body.motion, ways.radius_m, ways.speed_m_per_s, time);
}

void push_out_of_bodies(std::span<const Body> bodies, const ClothSurface& cloth, const TimeSpan& step,
                        std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                        std::span<Vec3> predicted) {
  assert(step.from_s <= step.to_s);
  assert(current.size() == predicted.size() && inverse_masses_per_kg.size() == predicted.size());
  for (const Body& body : bodies) {
    const double friction = friction_against(body, cloth.friction);
    const Shape shape = shape_at(body, step.to_s);
    const RigidMove back(body.motion, {step.to_s, step.from_s});
    for (std::size_t v = 0; v < predicted.size(); ++v) {
      if (inverse_masses_per_kg[v] == 0.0) continue;
      const ShapeSurfacePoint surface = nearest_surface(shape, predicted[v]);
      const double depth_m = cloth.thickness_m - surface.distance_m;
      if (depth_m > 0.0) {
        const Vec3 pushed_out = predicted[v] + surface.normal * depth_m;
        const Vec3 moved = pushed_out + back.displacement_m(pushed_out) - current[v];
        predicted[v] = with_friction(friction, surface, depth_m, moved, pushed_out);
      }
    }
  }
}

}  // namespace taut::sim
