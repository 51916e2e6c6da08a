#include "app/viewer/state/orbit_camera.hpp"

namespace taut::app {
namespace {

// Largest elevation. At 90 degrees the up direction is undefined.
constexpr float steepest_rad = glm::radians(89.0F);
// Smallest distance to the target.
constexpr float nearest_m = 0.01F;
// Factor on the distance for each notch of the wheel.
constexpr float closer_by_notch = 0.88F;
// Fraction of the picture that `fit` leaves free around the box.
constexpr float fit_margin = 0.06F;

struct Hit {
  double distance_m = 0.0;
  glm::dvec3 weights{0.0};  // of the three corners
};

// Moeller and Trumbore 1997.
std::optional<Hit> meet(const glm::dvec3& origin, const glm::dvec3& direction, const sim::Vec3& a, const sim::Vec3& b,
                        const sim::Vec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return std::nullopt;
  const glm::dvec3 from_a = origin - a;
  const double u = glm::dot(from_a, p) / determinant;
  const glm::dvec3 q = glm::cross(from_a, ab);
  const double v = glm::dot(direction, q) / determinant;
  const double distance = glm::dot(ac, q) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && std::isfinite(distance))) {
    return std::nullopt;
  }
  return Hit{distance, {1.0 - u - v, u, v}};
}

// One bit for each side of what the camera sees that a point is beyond; a lost point is beyond all of them.
unsigned sides_beyond(const sim::Vec3& position, const glm::dmat4& to_clip) {
  const glm::dvec4 clip = to_clip * glm::dvec4(position, 1.0);
  unsigned sides = 0;
  for (const int axis : {0, 1, 2}) {
    sides = sides << 2U | (clip[axis] >= -clip.w ? 0U : 1U) | (clip[axis] <= clip.w ? 0U : 2U);
  }
  return sides;
}

}  // namespace

OrbitCamera::OrbitCamera(const renderer::Camera& camera)
    : target_(camera.target), vertical_fov_rad_(camera.vertical_fov_rad) {
  const glm::vec3 back = camera.eye - camera.target;
  const float distance_m = glm::length(back);
  distance_m_ = std::clamp(distance_m, nearest_m, farthest_m);
  elevation_rad_ = std::clamp(std::asin(std::clamp(back.y / distance_m, -1.0F, 1.0F)), -steepest_rad, steepest_rad);
  azimuth_rad_ = std::atan2(back.x, back.z);
}

void OrbitCamera::orbit(const glm::vec2& way_px, const ViewArea& area) {
  const float rad_per_px = std::numbers::pi_v<float> / static_cast<float>(std::max(area.height_px, 100));
  azimuth_rad_ = std::remainder(azimuth_rad_ - way_px.x * rad_per_px, 2.0F * std::numbers::pi_v<float>);
  elevation_rad_ = std::clamp(elevation_rad_ + way_px.y * rad_per_px, -steepest_rad, steepest_rad);
}

void OrbitCamera::turn_to(float azimuth_rad, float elevation_rad) {
  azimuth_rad_ = azimuth_rad;
  elevation_rad_ = std::clamp(elevation_rad, -steepest_rad, steepest_rad);
}

void OrbitCamera::pan(const glm::vec2& way_px, const ViewArea& area) {
  const renderer::Camera seen = camera();
  const glm::vec3 forward = glm::normalize(seen.target - seen.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, seen.up));
  const glm::vec3 up = glm::cross(right, forward);
  const float m_per_px =
      2.0F * distance_m_ * std::tan(0.5F * vertical_fov_rad_) / static_cast<float>(std::max(area.height_px, 1));
  move_target(target_ + m_per_px * (up * way_px.y - right * way_px.x));
}

void OrbitCamera::move_target(const glm::vec3& target) {
  target_ = glm::clamp(target, glm::vec3(-farthest_m), glm::vec3(farthest_m));
}

// All that is on the ray through the pixel stays on it when the eye moves along it.
void OrbitCamera::zoom(float notches, const glm::vec2& point_px, const ViewArea& area) {
  const float before_m = distance_m_;
  const Ray ray = ray_through(point_px, area);
  distance_m_ =
      std::clamp(distance_m_ * std::pow(closer_by_notch, std::clamp(notches, -50.0F, 50.0F)), nearest_m, farthest_m);
  const glm::vec3 forward = glm::normalize(target_ - ray.origin);
  const glm::vec3 under = ray.origin + ray.direction * (before_m / glm::dot(ray.direction, forward));
  move_target(under + (distance_m_ / before_m) * (target_ - under));
}

void OrbitCamera::fit(const renderer::Box& box, const ViewArea& area) {
  const renderer::Camera framed =
      renderer::fit_camera_to_box(box, {azimuth_rad_, elevation_rad_, vertical_fov_rad_, fit_margin}, area.aspect());
  move_target(framed.target);
  distance_m_ = std::clamp(glm::distance(framed.eye, framed.target), nearest_m, farthest_m);
}

renderer::Camera OrbitCamera::camera() const {
  const float flat = std::cos(elevation_rad_);
  const glm::vec3 back{flat * std::sin(azimuth_rad_), std::sin(elevation_rad_), flat * std::cos(azimuth_rad_)};
  renderer::Camera camera;
  camera.target = target_;
  camera.eye = target_ + distance_m_ * back;
  camera.vertical_fov_rad = vertical_fov_rad_;
  // As of a scene that names its camera's eye, so that a saved scene gives the same picture.
  const float distance_m = glm::distance(camera.eye, camera.target);
  camera.near_m = 0.02F * distance_m;
  camera.far_m = 20.0F * distance_m;
  return camera;
}

Ray OrbitCamera::ray_through(const glm::vec2& point_px, const ViewArea& area) const {
  const renderer::Camera seen = camera();
  const glm::vec3 forward = glm::normalize(seen.target - seen.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, seen.up));
  const glm::vec3 up = glm::cross(right, forward);
  const float tangent = std::tan(0.5F * vertical_fov_rad_);
  const float x = (2.0F * point_px.x / static_cast<float>(area.width_px) - 1.0F) * tangent * area.aspect();
  const float y = (1.0F - 2.0F * point_px.y / static_cast<float>(area.height_px)) * tangent;
  return {seen.eye, glm::normalize(forward + x * right + y * up)};
}

std::optional<glm::vec2> OrbitCamera::pixel_of(const glm::vec3& point, const ViewArea& area) const {
  const renderer::Camera seen = camera();
  const glm::vec4 clip = seen.projection(area.aspect()) * seen.view() * glm::vec4(point, 1.0F);
  if (!(clip.w > 0.0F)) return std::nullopt;
  return glm::vec2{(0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(area.width_px),
                   (0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(area.height_px)};
}

std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles) {
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  std::optional<PickedPoint> nearest;
  for (const sim::Triangle& t : triangles) {
    const auto hit = meet(origin, direction, positions[t[0]], positions[t[1]], positions[t[2]]);
    if (hit && (!nearest || hit->distance_m < nearest->distance_m)) {
      const glm::dvec3& w = hit->weights;
      const int corner = w.x >= w.y && w.x >= w.z ? 0 : (w.y >= w.z ? 1 : 2);
      nearest = {t[static_cast<std::size_t>(corner)], origin + hit->distance_m * direction, hit->distance_m};
    }
  }
  return nearest;
}

std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through, const renderer::Camera& camera) {
  const glm::dvec3 facing(glm::normalize(camera.target - camera.eye));
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  const double slant = glm::dot(direction, facing);
  const double distance = glm::dot(through - origin, facing) / slant;
  if (!(slant > 1e-6) || !std::isfinite(distance) || distance <= 0.0) return std::nullopt;
  return origin + distance * direction;
}

std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area) {
  const renderer::Camera seen = camera.camera();
  const glm::dmat4 to_clip(seen.projection(area.aspect()) * seen.view());
  // By triangles: seen from near by, one may fill the picture with its corners outside.
  const bool is_seen = std::ranges::any_of(triangles, [&](const sim::Triangle& triangle) {
    const auto beyond = [&](int corner) { return sides_beyond(positions[triangle[corner]], to_clip); };
    return (beyond(0) & beyond(1) & beyond(2)) == 0U;
  });
  if (is_seen) return "";
  const bool is_in_reach = std::ranges::any_of(positions, [](const sim::Vec3& position) {
    const auto is_near = [](double coordinate) { return std::abs(coordinate) < OrbitCamera::farthest_m; };
    return is_near(position.x) && is_near(position.y) && is_near(position.z);
  });
  return is_in_reach ? "the cloth has left the picture: F looks at it, R starts again"
                     : "the cloth has left the world: R starts again";
}

}  // namespace taut::app
