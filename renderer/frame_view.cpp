#include "renderer/frame_view.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace taut::renderer {
namespace {

// Smallest half side of a box, m. A smaller box counts as a cube of this size.
constexpr float min_half_side_m = 0.0005F;
// Smallest distance of the near plane, as a fraction of the eye's distance. Lower values show points closer to the eye,
// higher ones keep more depth precision.
constexpr float min_near_fraction = 0.02F;
// Distances of the near plane in front of the target and of the far plane behind it, in radii of the box. Higher values
// show more around the box, lower ones keep more depth precision.
constexpr float near_radii = 2.0F;
constexpr float far_radii = 20.0F;

// Axes of a camera that looks along -back.
struct CameraAxes {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 back;
};

CameraAxes camera_axes(const Framing& framing) {
  const float flat = std::cos(framing.elevation_rad);
  const glm::vec3 back{flat * std::sin(framing.azimuth_rad), std::sin(framing.elevation_rad),
                       flat * std::cos(framing.azimuth_rad)};
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3{0.0F, 1.0F, 0.0F}, back));
  return {right, glm::cross(back, right), back};
}

struct LineFit {
  float centre;    // centre across, halfway between the two limits
  float distance;  // distance along the view, from the origin of the axes
};

// Fits the opening across one axis. A point at `across` and `depth` (towards the camera) is inside an opening of
// tangent t if |across - centre| <= t (distance - depth). The two tightest of these lines meet at the result.
LineFit fit_across(std::span<const glm::vec3> points, const glm::vec3& axis, const glm::vec3& back, float tangent) {
  float right_most = -INFINITY, left_most = -INFINITY;
  for (const glm::vec3& point : points) {
    const float across = glm::dot(point, axis);
    const float depth = tangent * glm::dot(point, back);
    right_most = std::max(right_most, across + depth);
    left_most = std::max(left_most, -across + depth);
  }
  return {0.5F * (right_most - left_most), 0.5F * (right_most + left_most) / tangent};
}

// Returns the half opening as a fraction of the picture's height; the width has `aspect` times as much.
float half_opening(const Framing& framing) {
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

// Returns a camera that fits points given relative to `middle`, all within `half` of it along every axis.
Camera fit_camera(std::span<const glm::vec3> points, const glm::vec3& middle, const glm::vec3& half,
                  const Framing& framing, float aspect) {
  const CameraAxes axes = camera_axes(framing);
  const float opening = half_opening(framing);
  const LineFit vertical = fit_across(points, axes.up, axes.back, opening);
  const LineFit horizontal = fit_across(points, axes.right, axes.back, opening * aspect);
  const float distance = std::max(vertical.distance, horizontal.distance);

  Camera camera;
  camera.target = middle + horizontal.centre * axes.right + vertical.centre * axes.up;
  camera.eye = camera.target + distance * axes.back;
  camera.vertical_fov_rad = framing.vertical_fov_rad;
  const float radius = glm::length(half);
  camera.near_m = std::max(min_near_fraction * distance, distance - near_radii * radius);
  camera.far_m = distance + far_radii * radius;
  return camera;
}

// Positions of the lamps relative to the camera: x right, y up, z from the scene towards the camera. Higher lamps make
// shorter shadows; lamps farther to the side show more of the folds.
constexpr glm::vec3 key_lamp{-0.90F, 1.50F, 0.42F};
constexpr glm::vec3 fill_lamp{0.95F, 0.30F, 0.55F};
constexpr glm::vec3 rim_lamp{0.45F, 0.60F, -1.0F};

constexpr int max_side_px = 16384;

bool is_within(int number, int lowest, int highest) { return number >= lowest && number <= highest; }

bool are_finite(std::span<const glm::vec3> values) {
  return std::ranges::all_of(
      values, [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); });
}

// Returns whether the indices form whole groups and are below `count`.
bool are_indices(std::span<const std::uint32_t> indices, std::size_t group, std::size_t count) {
  return indices.size() % group == 0 &&
         std::ranges::all_of(indices, [=](std::uint32_t index) { return index < count; });
}

bool is_map(const BaseColourMap& map, const SurfaceView& surface) {
  return map.rgba == nullptr || (!surface.corner_coordinates.empty() && is_within(map.width_px, 1, max_side_px) &&
                                 is_within(map.height_px, 1, max_side_px) &&
                                 map.rgba->size() == std::size_t{4} * static_cast<std::size_t>(map.width_px) *
                                                         static_cast<std::size_t>(map.height_px));
}

bool has_sound_colours(const SurfaceView& surface) {
  const auto& corners = surface.corner_coordinates;
  const auto& of_triangle = surface.base_colour_of_triangle;
  return (corners.empty() || corners.size() == surface.triangles.size()) &&
         std::ranges::all_of(corners,
                             [](const glm::vec2& place) { return std::isfinite(place.x) && std::isfinite(place.y); }) &&
         std::ranges::all_of(surface.base_colours,
                             [&](const BaseColour& colour) { return is_map(colour.map, surface); }) &&
         (of_triangle.empty() || of_triangle.size() == surface.triangles.size() / 3) &&
         are_indices(of_triangle, 1, surface.base_colours.size());
}

bool is_sound(const Refinement& refinement, const SurfaceView& surface) {
  for (std::size_t i = 0; i < refinement.parents.size(); ++i) {
    if (!are_indices(refinement.parents[i], 2, refinement.coarse_vertices + i)) return false;
  }
  return refinement.coarse_vertices + refinement.parents.size() == surface.positions.size() &&
         are_indices(refinement.coarse_triangles, 3, refinement.coarse_vertices) &&
         refinement.parent_triangles.size() == surface.triangles.size() / 3 &&
         are_indices(refinement.parent_triangles, 1, refinement.coarse_triangles.size() / 3);
}

bool is_sound(const SurfaceView& surface) {
  const std::size_t count = surface.positions.size();
  const auto& material = surface.material_coordinates;
  return are_finite(surface.positions) && surface.normals.size() == count && are_finite(surface.normals) &&
         (material.empty() || material.size() == count) && are_finite(material) &&
         are_indices(surface.triangles, 3, count) && has_sound_colours(surface) &&
         (!surface.refinement || is_sound(*surface.refinement, surface)) &&
         std::ranges::all_of(
             surface.trims,
             [&](const TrimmedTriangle& trim) { return trim.triangle < surface.triangles.size() / 3; }) &&
         (!surface.wireframe || std::ranges::all_of(surface.wireframe->edges,
                                                    [&](const auto& edge) { return are_indices(edge, 2, count); })) &&
         (!surface.scalars ||
          (surface.scalars->values.size() == count && surface.scalars->maximum > surface.scalars->minimum));
}

// Returns a sphere of rings around the axis `up`; the ring at the equator is doubled and moved apart by `axis`.
TriangleMesh make_rounded_mesh(const glm::vec3& a, const glm::vec3& axis, const glm::vec3& up, float radius_m,
                               int segments) {
  const int around = std::max(segments, 3);
  const int half_rings = std::max(around / 4, 1);
  const glm::vec3 other = std::abs(up.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
  const glm::vec3 side = glm::normalize(glm::cross(other, up));
  const glm::vec3 forward = glm::cross(side, up);
  TriangleMesh mesh;
  for (int ring = 0; ring <= 2 * half_rings + 1; ++ring) {
    const bool upper = ring > half_rings;
    const int step = upper ? ring - 1 : ring;
    const float latitude =
        std::numbers::pi_v<float> * (static_cast<float>(step) / static_cast<float>(2 * half_rings) - 0.5F);
    for (int i = 0; i < around; ++i) {
      const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
      const glm::vec3 normal =
          std::cos(latitude) * (std::cos(turn) * side + std::sin(turn) * forward) + std::sin(latitude) * up;
      mesh.normals.push_back(normal);
      mesh.positions.push_back(a + (upper ? axis : glm::vec3{0.0F}) + radius_m * normal);
    }
  }
  for (int ring = 0; ring <= 2 * half_rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const auto p = static_cast<std::uint32_t>(ring * around + i);
      const auto q = static_cast<std::uint32_t>(ring * around + (i + 1) % around);
      const auto row = static_cast<std::uint32_t>(around);
      mesh.triangles.insert(mesh.triangles.end(), {p, p + row, q, q, p + row, q + row});
    }
  }
  return mesh;
}

float angle_between(const glm::vec3& a, const glm::vec3& b) {
  // atan2 keeps its precision for needles, where the arc cosine loses it.
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void add_triangle(const std::array<std::uint32_t, 3>& corners, std::span<const glm::vec3> positions,
                  std::span<glm::vec3> normals) {
  const std::array p{positions[corners[0]], positions[corners[1]], positions[corners[2]]};
  const glm::vec3 twice_area = glm::cross(p[1] - p[0], p[2] - p[0]);
  const float length = glm::length(twice_area);
  if (!(length > 0.0F && std::isfinite(length))) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const float angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    normals[corners[i]] += twice_area * (angle / length);
  }
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

Box unite(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

std::array<glm::vec3, 8> box_corners(const Box& box) {
  std::array<glm::vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
                  (i & 4U) != 0 ? box.upper.z : box.lower.z};
  }
  return corners;
}

Camera fit_camera_to_box(const Box& box, const Framing& framing, float aspect) {
  check(box, framing, aspect);
  const glm::vec3 middle = 0.5F * (box.lower + box.upper);
  const glm::vec3 half = glm::max(0.5F * (box.upper - box.lower), glm::vec3{min_half_side_m});
  return fit_camera(box_corners({-half, half}), middle, half, framing, aspect);
}

std::array<glm::vec3, 4> outermost_points(std::span<const glm::vec3> points, const Framing& framing, float aspect) {
  const Box box = bounding_box(points);
  check(box, framing, aspect);
  const glm::vec3 middle = 0.5F * (box.lower + box.upper);
  const CameraAxes axes = camera_axes(framing);
  const float opening = half_opening(framing);
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
  if (std::max({half.x, half.y, half.z}) < min_half_side_m) return fit_camera_to_box(box, framing, aspect);
  std::vector<glm::vec3> from_middle(points.begin(), points.end());
  for (glm::vec3& point : from_middle) point -= middle;
  return fit_camera(from_middle, middle, half, framing, aspect);
}

const char* to_name(WeaveKind kind) {
  constexpr std::array names = {"knit", "plain", "twill", "satin"};
  return names[static_cast<std::size_t>(kind)];
}

Lighting studio_lighting(const Camera& camera) {
  const glm::vec3 back = camera.eye - camera.target;
  // Lamps stand on the studio's floor: they follow the camera around but not up and down.
  glm::vec3 towards{back.x, 0.0F, back.z};
  towards = glm::length(towards) > 1e-4F * glm::length(back) ? glm::normalize(towards) : glm::vec3{0, 0, 1};
  const glm::vec3 right{towards.z, 0.0F, -towards.x};
  const glm::vec3 up{0.0F, 1.0F, 0.0F};
  Lighting lighting;
  const auto in_world = [&](const glm::vec3& lamp) { return lamp.x * right + lamp.y * up + lamp.z * towards; };
  lighting.towards_key = in_world(key_lamp);
  lighting.towards_fill = in_world(fill_lamp);
  lighting.towards_rim = in_world(rim_lamp);
  return lighting;
}

bool is_sound(const FrameView& frame) {
  const Camera& camera = frame.camera;
  const auto all = [](const auto& views, const auto& are_sound) { return std::ranges::all_of(views, are_sound); };
  return camera.vertical_fov_rad > 0.0F && camera.vertical_fov_rad < 3.1F && camera.near_m > 0.0F &&
         camera.far_m > camera.near_m && std::isfinite(camera.far_m) &&
         all(frame.surfaces, [](const SurfaceView& surface) { return is_sound(surface); }) &&
         all(frame.lines,
             [](const LineView& line) {
               return line.points.size() % 2 == 0 && are_finite(line.points) && are_finite({&line.colour, 1});
             }) &&
         all(frame.points,
             [](const PointView& points) {
               return are_finite(points.centres) && are_finite({&points.colour, 1});
             }) &&
         all(frame.spheres, [](const SphereView& spheres) {
           return are_finite(spheres.centres) && spheres.radius_m > 0.0F && std::isfinite(spheres.radius_m);
         });
}

bool is_sound(const PictureSettings& settings) {
  return is_within(settings.width_px, 1, max_side_px) && is_within(settings.height_px, 1, max_side_px) &&
         is_within(settings.samples, 1, 64) && is_within(settings.supersampling, 1, 8) &&
         is_within(settings.shadow_map_px, 256, 8192) && is_within(settings.shading_px, 1, 2) &&
         is_within(settings.shadow_taps, 1, 64) && is_within(settings.sky_directions, 0, 32) &&
         is_within(settings.passes, 1, max_passes);
}

void check(const FrameView& frame, const PictureSettings& settings) {
  const Camera& camera = frame.camera;
  if (!is_near({camera.eye, camera.eye}) || !is_near({camera.target, camera.target}) || camera.eye == camera.target) {
    throw std::invalid_argument("camera: eye and target have to be different and no farther than 1e9 m");
  }
  if (!is_sound(frame) || !is_sound(settings)) {
    throw std::invalid_argument("renderer: a frame or settings do not keep what frame_view.hpp requires of them");
  }
}

TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments) {
  return make_rounded_mesh(centre, glm::vec3{0.0F}, glm::vec3{0.0F, 1.0F, 0.0F}, radius_m, segments);
}

TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments) {
  const glm::vec3 axis = b - a;
  const float length = glm::length(axis);
  if (!(length > 0.0F)) return make_sphere(a, radius_m, segments);
  return make_rounded_mesh(a, axis, axis / length, radius_m, segments);
}

void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals) {
  assert(normals.size() == positions.size());
  assert(triangles.size() % 3 == 0);
  std::ranges::fill(normals, glm::vec3{0.0F});
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    assert(std::max({triangles[i], triangles[i + 1], triangles[i + 2]}) < positions.size());
    add_triangle({triangles[i], triangles[i + 1], triangles[i + 2]}, positions, normals);
  }
  for (glm::vec3& normal : normals) {
    const float length = glm::length(normal);
    normal = length > 0.0F && std::isfinite(length) ? normal / length : glm::vec3{0.0F, 1.0F, 0.0F};
  }
}

}  // namespace taut::renderer
