#include "renderer/camera.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace taut::renderer {

namespace {

// Half the least side of a box, m. A smaller box counts as a cube of this size.
constexpr float smallest_half_m = 0.0005F;
// Least distance of the near plane, share of the eye's distance. Smaller shows what is closer to the eye,
// larger keeps more depth precision.
constexpr float least_near_share = 0.02F;
// How far the near plane is in front of the target and the far plane behind it, radii of the box. More shows
// more around the box, less keeps more depth precision.
constexpr float near_radii = 2.0F;
constexpr float far_radii = 20.0F;

// The axes of a camera that looks along -back.
struct Axes {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 back;
};

Axes axes_of(const Framing& framing) {
  const float flat = std::cos(framing.elevation_rad);
  const glm::vec3 back{flat * std::sin(framing.azimuth_rad), std::sin(framing.elevation_rad),
                       flat * std::cos(framing.azimuth_rad)};
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3{0.0F, 1.0F, 0.0F}, back));
  return {right, glm::cross(back, right), back};
}

std::array<glm::vec3, 8> corners_of(const Box& box) {
  std::array<glm::vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
                  (i & 4U) != 0 ? box.upper.z : box.lower.z};
  }
  return corners;
}

struct Fit {
  float centre;    // across, where the two limits balance
  float distance;  // along the view, from the origin of the axes
};

// A point at `across` and `depth` (towards the camera) is inside the opening of tangent t when
// |across - centre| <= t (distance - depth). The two tightest of these lines meet at the answer.
Fit fit_across(std::span<const glm::vec3> points, const glm::vec3& axis, const glm::vec3& back, float tangent) {
  float right_most = -INFINITY, left_most = -INFINITY;
  for (const glm::vec3& point : points) {
    const float across = glm::dot(point, axis);
    const float depth = tangent * glm::dot(point, back);
    right_most = std::max(right_most, across + depth);
    left_most = std::max(left_most, -across + depth);
  }
  return {0.5F * (right_most - left_most), 0.5F * (right_most + left_most) / tangent};
}

// Returns the half opening as a part of the picture's height; the width has `aspect` times as much.
float opening_of(const Framing& framing) {
  return std::tan(0.5F * framing.vertical_fov_rad) * (1.0F - 2.0F * framing.margin);
}

void check(const Box& box, const Framing& framing, float aspect) {
  if (!is_near(box)) {
    throw std::invalid_argument("camera framing: the box is inside out, or reaches farther than 1e9 m");
  }
  if (!(std::isfinite(aspect) && aspect > 0.0F)) {
    throw std::invalid_argument("camera framing: the aspect has to be a positive number");
  }
  if (!(framing.margin >= 0.0F && framing.margin <= 0.49F)) {
    throw std::invalid_argument("camera framing: the margin has to be from 0 to 0.49");
  }
}

// Of points given from `middle`, all within `half` of it along every axis.
Camera fitted(std::span<const glm::vec3> points, const glm::vec3& middle, const glm::vec3& half, const Framing& framing,
              float aspect) {
  const Axes axes = axes_of(framing);
  const float opening = opening_of(framing);
  const Fit vertical = fit_across(points, axes.up, axes.back, opening);
  const Fit horizontal = fit_across(points, axes.right, axes.back, opening * aspect);
  const float distance = std::max(vertical.distance, horizontal.distance);

  Camera camera;
  camera.target = middle + horizontal.centre * axes.right + vertical.centre * axes.up;
  camera.eye = camera.target + distance * axes.back;
  camera.vertical_fov_rad = framing.vertical_fov_rad;
  const float radius = glm::length(half);
  camera.near_m = std::max(least_near_share * distance, distance - near_radii * radius);
  camera.far_m = distance + far_radii * radius;
  return camera;
}

}  // namespace

glm::mat4 Camera::view() const { return glm::lookAt(eye, target, up); }

glm::mat4 Camera::projection(float aspect) const { return glm::perspective(vertical_fov_rad, aspect, near_m, far_m); }

Box bounding_box(std::span<const glm::vec3> points) {
  if (points.empty()) throw std::invalid_argument("bounding_box: there are no points");
  Box box{glm::vec3{INFINITY}, glm::vec3{-INFINITY}};
  for (const glm::vec3& point : points) {
    box.lower = glm::min(box.lower, point);
    box.upper = glm::max(box.upper, point);
  }
  return box;
}

bool is_near(const Box& box) {
  bool near = true;
  for (int i = 0; i < 3; ++i) {
    near = near && -farthest_m <= box.lower[i] && box.lower[i] <= box.upper[i] && box.upper[i] <= farthest_m;
  }
  return near;
}

Box united(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

Camera fit_camera_to_box(const Box& box, const Framing& framing, float aspect) {
  check(box, framing, aspect);
  const glm::vec3 middle = 0.5F * (box.lower + box.upper);
  const glm::vec3 half = glm::max(0.5F * (box.upper - box.lower), glm::vec3{smallest_half_m});
  return fitted(corners_of({-half, half}), middle, half, framing, aspect);
}

std::array<glm::vec3, 4> outermost_points(std::span<const glm::vec3> points, const Framing& framing, float aspect) {
  const Box box = bounding_box(points);
  check(box, framing, aspect);
  const glm::vec3 middle = 0.5F * (box.lower + box.upper);
  const Axes axes = axes_of(framing);
  const float opening = opening_of(framing);
  const auto farthest = [&](const glm::vec3& axis, float tangent) {
    const glm::vec3 functional = axis + tangent * axes.back;
    return *std::ranges::max_element(points, [&](const glm::vec3& a, const glm::vec3& b) {
      return glm::dot(a - middle, functional) < glm::dot(b - middle, functional);
    });
  };
  return {farthest(axes.right, aspect * opening), farthest(-axes.right, aspect * opening), farthest(axes.up, opening),
          farthest(-axes.up, opening)};
}

Camera fit_camera_to_points(std::span<const glm::vec3> points, const Framing& framing, float aspect) {
  const Box box = bounding_box(points);
  check(box, framing, aspect);
  const glm::vec3 middle = 0.5F * (box.lower + box.upper);
  const glm::vec3 half = 0.5F * (box.upper - box.lower);
  if (std::max({half.x, half.y, half.z}) < smallest_half_m) return fit_camera_to_box(box, framing, aspect);
  std::vector<glm::vec3> from_middle(points.begin(), points.end());
  for (glm::vec3& point : from_middle) point -= middle;
  return fitted(from_middle, middle, half, framing, aspect);
}

}  // namespace taut::renderer
