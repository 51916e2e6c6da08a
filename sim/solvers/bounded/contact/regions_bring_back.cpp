
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
std::span<const Regions::HalfSpace> Regions::half_spaces_at(Index row) const {
  return {half_spaces_.data() + half_space_begin_[row], half_spaces_.data() + half_space_begin_[row + 1]};
}

bool Regions::contains(Index row, float time, const Vec3& moved_m) const {
  assert(time >= 0.0F && time <= 1.0F);
  const Vec3 off_m = moved_m - Vec3(time * vec(expected_[row]));
  const double radius_m = radii_[row];
  const std::span<const HalfSpace> half_spaces = half_spaces_at(row);
  return glm::dot(off_m, off_m) <= radius_m * radius_m &&
         std::all_of(half_spaces.begin(), half_spaces.end(), [&](const HalfSpace& half_space) {
           return glm::dot(Vec3(half_space.normal), moved_m) >= half_space.start + time * half_space.rate - tolerance_m;
         });
}

glm::vec3 Regions::project_onto_planes(Index row, float time, const glm::vec3& start, glm::vec3& stopped) const {
  glm::vec3 e = start;
  bool is_out = true;
  for (int projection = 0; projection < tuning::max_plane_projections && is_out; ++projection) {
    is_out = false;
    for (const HalfSpace& half_space : half_spaces_at(row)) {
      const float depth = half_space.start + time * half_space.rate - glm::dot(half_space.normal, e);
      if (depth > (projection == 0 ? 0.0F : tolerance_m)) {
        e += (projection == 0 ? depth : tuning::over_projection_factor * depth) * half_space.normal;
        if (projection == 0 && half_space.is_fixed) stopped += depth * half_space.normal;
        is_out = true;
      }
    }
  }
  return e;
}

// Moves `end` towards the aim, which is within all half-spaces, by the smallest sufficient amount.
glm::vec3 Regions::limit_motion(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const {
  float part = 1.0F;
  for (const HalfSpace& half_space : half_spaces_at(row)) {
    const float limit = half_space.start + time * half_space.rate;
    const float room = glm::dot(half_space.normal, end) - limit;
    if (room < -tolerance_m) {
      const float room_at_aim = std::max(glm::dot(half_space.normal, aim) - limit, 0.0F);
      part = std::min(part, room_at_aim / (room_at_aim - room));
    }
  }
  return aim + part * (end - aim);
}

// Projections between nearly opposite planes do not end. Instead the motion starts at the aim, which is within all
// half-spaces, runs straight to a plane, then along it, then along it and a second one.
glm::vec3 Regions::slide_along_planes(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const {
  glm::vec3 e = aim;
  glm::vec3 left = end - aim;
  glm::vec3 first_normal(0.0F);
  for (int met = 0; met < 3; ++met) {
    float part = 1.0F;
    const HalfSpace* plane = nullptr;
    for (const HalfSpace& half_space : half_spaces_at(row)) {
      const float towards = -glm::dot(half_space.normal, left);
      const float room = std::max(glm::dot(half_space.normal, e) - half_space.start - time * half_space.rate, 0.0F);
      if (towards > room && room < part * towards) {
        part = room / towards;
        plane = &half_space;
      }
    }
    e += part * left;
    if (plane == nullptr) return e;
    left *= 1.0F - part;
    if (met == 0) {
      first_normal = plane->normal;
      left -= glm::dot(left, first_normal) * first_normal;
    } else {
      const glm::vec3 axis = glm::cross(first_normal, plane->normal);
      const float squared = glm::dot(axis, axis);
      left = squared > 0.0F ? glm::dot(left, axis) / squared * axis : glm::vec3(0.0F);
    }
  }
  return e;
}

// The ray from the aim ends at the trust region: the larger root of |aim - centre + s out| = radius.
glm::vec3 Regions::end_within_ball(const glm::vec3& centre, float radius, const glm::vec3& aim, const glm::vec3& end) {
  assert(radius >= 0.0F);
  const glm::vec3 out = end - aim;
  const glm::vec3 inside = aim - centre;
  const float a = glm::dot(out, out);
  const float b = glm::dot(inside, out);
  const float c = glm::dot(inside, inside) - radius * radius;
  const float s = (std::sqrt(std::max(b * b - a * c, 0.0F)) - b) / a;
  return aim + std::clamp(s, 0.0F, 1.0F) * out;
}

Regions::RegionProjection Regions::project_row(Index row, float time, const glm::vec3& moved) const {
  const glm::vec3 aim = time * vec(planned_motions_[row]);
  glm::vec3 stopped(0.0F);
  const glm::vec3 end = project_onto_planes(row, time, moved, stopped);
  glm::vec3 e = limit_motion(row, time, aim, end);
  if (e != end) e = limit_motion(row, time, aim, slide_along_planes(row, time, aim, end));
  const glm::vec3 centre = time * vec(expected_[row]);
  if (!(glm::dot(e - centre, e - centre) > radii_[row] * radii_[row])) return {e, e, stopped};
  return {e, end_within_ball(centre, radii_[row], aim, e), stopped};
}

// Returns the part of a push by planes that changes no velocity. Planes stop what forces add to the predicted motion,
// within a limit, else cloth that stands on a plane falls ever faster without moving. Only collisions stop the
// predicted motion itself.
glm::vec3 Regions::kept_push(Index row, const StepMotion& step, const glm::vec3& last_move,
                             const glm::vec3& push) const {
  const float length = glm::length(push);
  if (!(length > 0.0F)) return push;
  const float predicted = std::min(step.fraction * glm::dot(vec(expected_[row]), push) / length, 0.0F);
  const float excess = predicted - glm::dot(last_move, push) / length;
  return (1.0F - std::clamp(excess, 0.0F, std::min(length, step.max_stopped_m)) / length) * push;
}

void Regions::project_all(float time, const StepMotion& step, const Float4Array& since, Float4Array* previous,
                          Float4Array& current, ParallelKernels& kernels) {
  assert(time >= 0.0F);
  assert(since.size() == current.size());
  const std::size_t blocks = current.size() / block_size;
  parts_.resize(std::max(parts_.size(), blocks / ParallelKernels::min_blocks + 1));
  kernels.split(0, blocks, ParallelKernels::min_blocks, [&](std::size_t begin, std::size_t end) {
    // Ranges of other threads begin at least `min_blocks` away.
    ThreadPart& part = parts_[begin / ParallelKernels::min_blocks];
    part.rows.resize((end - begin) * block_size + 1);
    const std::size_t off = kernels.contact().list_off_motion(since.data(), planned_motions_.data(), time, begin, end,
                                                              current.data(), part.rows.data());
    for (const Index row : std::span(part.rows).first(off)) {
      const glm::vec3 moved = vec(current[row]) - vec(since[row]);
      const RegionProjection back = project_row(row, time, moved);
      if (previous != nullptr) {
        const glm::vec3 last_move = vec(current[row]) - vec((*previous)[row]);
        add((*previous)[row], kept_push(row, step, last_move, back.within_planes - moved - back.stopped));
      }
      if (back.end != moved) current[row] = to_float4(Vec3(vec(since[row]) + back.end));
      if (back.end != back.within_planes) part.held_back.push_back({row, back.within_planes - back.end});
    }
  });
  clamped_rows_.clear();
  for (ThreadPart& part : parts_) {
    clamped_rows_.insert(clamped_rows_.end(), part.held_back.begin(), part.held_back.end());
    part.held_back.clear();
  }
}

// Only collisions transfer momentum, so a vertex stopped by a plane keeps the velocity of its predicted motion.
std::span<const ClampedRow> Regions::project_into_region(float time, const StepMotion& step, const Float4Array& since,
                                                         Float4Array& previous, Float4Array& current,
                                                         ParallelKernels& kernels) {
  assert(step.fraction >= 0.0F && step.max_stopped_m >= 0.0F);
  project_all(time, step, since, &previous, current, kernels);
  return clamped_rows_;
}

std::size_t Regions::project_into_region(const Float4Array& since, Float4Array& current, ParallelKernels& kernels) {
  project_all(1.0F, {}, since, nullptr, current, kernels);
  return clamped_rows_.size();
}

}  // namespace taut::sim::bounded
