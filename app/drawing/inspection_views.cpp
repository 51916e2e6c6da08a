#include "app/drawing/inspection_views.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"

namespace taut::app {
namespace {

constexpr float degree = 0.017453293F;
constexpr float elevation_rad = 10.0F * degree;
constexpr std::array azimuths_rad = {20.0F * degree, 200.0F * degree};
// A narrow view has little perspective, so that one scale bar is valid for the whole garment.
constexpr float field_of_view_rad = 0.12F;
// Fraction of the picture that stays free, for lines and balls at the garment's edge.
constexpr float margin = 0.025F;
// Limits on the height of a view, as fractions of its width. They give a flat garment some height and keep a
// scarf from filling the page.
constexpr float lowest_panel = 0.2F;
constexpr float highest_panel = 1.3F;

renderer::Framing framing_of(float azimuth_rad) {
  return {.azimuth_rad = azimuth_rad,
          .elevation_rad = elevation_rad,
          .vertical_fov_rad = field_of_view_rad,
          .margin = margin};
}

/// The vertices, and of those that are held the balls that show it.
std::vector<glm::vec3> points_to_be_seen(const sim::Garment& garment, std::span<const sim::Index> pins,
                                         float ball_radius_m) {
  std::vector<glm::vec3> points = to_float(garment.mesh.positions);
  for (const sim::Index pin : pins) {
    const glm::vec3 centre(garment.mesh.positions[pin]);
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 radius(0.0F);
      radius[axis] = ball_radius_m;
      points.push_back(centre + radius);
      points.push_back(centre - radius);
    }
  }
  return points;
}

/// Height by width of what a camera sees of the points.
glm::vec2 seen_size(std::span<const glm::vec3> points, const renderer::Camera& camera) {
  const glm::mat4 to_eye = camera.view();
  glm::vec2 lower(INFINITY), upper(-INFINITY);
  for (const glm::vec3& point : points) {
    const glm::vec4 seen = to_eye * glm::vec4(point, 1.0F);
    lower = {std::min(lower.x, -seen.x / seen.z), std::min(lower.y, -seen.y / seen.z)};
    upper = {std::max(upper.x, -seen.x / seen.z), std::max(upper.y, -seen.y / seen.z)};
  }
  return upper - lower;
}

/// Of the views from the garment's front and from behind.
std::array<float, 2> azimuths_of(std::span<const glm::vec3> points) {
  const renderer::Box box = renderer::bounding_box(points);
  const float turned_rad = azimuth_of_broad_side(box.upper - box.lower);
  return {azimuths_rad[0] + turned_rad, azimuths_rad[1] + turned_rad};
}

int panel_height_px(std::span<const glm::vec3> points) {
  float width = 0.0F, height = 0.0F;
  for (const float azimuth_rad : azimuths_of(points)) {
    const glm::vec2 size =
        seen_size(points, renderer::fit_camera_to_points(points, framing_of(azimuth_rad), 1.0F));
    width = std::max(width, size.x);
    height = std::max(height, size.y);
  }
  const float wanted = width > 0.0F ? height / width : highest_panel;
  return static_cast<int>(std::lround(inspection_panel_px * std::clamp(wanted, lowest_panel, highest_panel)));
}

DrawnScene scene_of_side(const DrawnScene& asked, int height_px) {
  DrawnScene scene = asked;
  scene.camera = {};
  scene.camera.framing.vertical_fov_rad = field_of_view_rad;
  scene.picture = {};
  scene.picture.settings.width_px = inspection_panel_px;
  scene.picture.settings.height_px = height_px;
  scene.picture.settings.samples = 1;
  scene.picture.settings.supersampling = 3;
  scene.picture.settings.shadows = false;
  scene.picture.ground.kind = GroundKind::none;
  scene.picture.cloth.weave = 0.0F;
  scene.picture.cloth.sheen = 0.0F;
  scene.picture.cloth.translucency = 0.0F;
  scene.surroundings.bodies.clear();
  return scene;
}

}  // namespace

InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Index> pins) {
  const std::vector<glm::vec3> points =
      points_to_be_seen(garment, pins, pin_radius_m(expected_reach(asked, garment, pins)));
  InspectionViews views{.sides = {{{"from the front", {}}, {"from behind", {}}}},
                        .height_px = panel_height_px(points)};
  const float aspect = static_cast<float>(inspection_panel_px) / static_cast<float>(views.height_px);
  const std::array<float, 2> azimuths = azimuths_of(points);
  std::array<renderer::Camera, azimuths.size()> cameras;
  float distance_m = 0.0F;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    cameras[k] = renderer::fit_camera_to_points(points, framing_of(azimuths[k]), aspect);
    distance_m = std::max(distance_m, glm::distance(cameras[k].eye, cameras[k].target));
  }
  // All from as far as the side that needs it.
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    const glm::vec3 backwards = glm::normalize(cameras[k].eye - cameras[k].target);
    DrawnScene& scene = views.sides[k].scene;
    scene = scene_of_side(asked, views.height_px);
    scene.camera.target = cameras[k].target;
    scene.camera.eye = cameras[k].target + distance_m * backwards;
  }
  views.px_per_m =
      static_cast<float>(views.height_px) / (2.0F * distance_m * std::tan(0.5F * field_of_view_rad));
  return views;
}

}  // namespace taut::app
