#include "app/drawing/fitted_view.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/drawing/framing.hpp"
#include "app/drawing/wind_arrows.hpp"

namespace taut::app {
namespace {

void add_box(const renderer::Box& box, std::vector<glm::vec3>& points) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    points.emplace_back((corner & 1U) != 0 ? box.upper.x : box.lower.x,
                        (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                        (corner & 4U) != 0 ? box.upper.z : box.lower.z);
  }
}

// The legend is at the left; as much stays free at the right, which keeps the garment in the middle.
float aspect_beside_legend(const PictureStyle& style) {
  constexpr float legend_share = 0.23F;  // of the picture's height
  constexpr float narrowest = 0.4F;
  const float aspect = aspect_of(style.settings);
  const bool has_legend = style.surface == SurfaceLook::stretch && style.legend;
  return has_legend ? std::max(aspect - 2.0F * legend_share, std::min(aspect, narrowest)) : aspect;
}

}  // namespace

bool is_fitted(const DrawnScene& scene) {
  return scene.camera.fit == CameraFit::frames && !scene.camera.box && !scene.camera.eye;
}

FittedView::FittedView(const DrawnScene& scene, const sim::Garment& garment)
    : scene_(scene),
      garment_(garment),
      framing_(framing_of(scene, renderer::bounding_box(to_float(garment.mesh.positions)))),
      aspect_(aspect_beside_legend(scene.picture)) {}

void FittedView::add(const std::vector<sim::Vec3>& positions, double time_s) {
  std::vector<glm::vec3> points = to_float(positions);
  for (const sim::Body& body : scene_.surroundings.bodies) {
    if (const std::optional<renderer::Box> box = box_of(body, time_s)) {
      add_box(*box, points);
    }
  }
  const glm::vec3 shift =
      scene_.camera.follow ? mean_of(positions) - mean_of(garment_.mesh.positions) : glm::vec3(0.0F);
  for (glm::vec3& point : points) {
    lowest_m_ = std::min(lowest_m_, point.y);
    highest_m_ = std::max(highest_m_, point.y);
    point -= shift;
  }
  const auto outermost = renderer::outermost_points(points, framing_, aspect_);
  outermost_.insert(outermost_.end(), outermost.begin(), outermost.end());
}

void FittedView::place_camera(DrawnScene& scene) const {
  if (outermost_.empty()) {
    return;
  }
  std::vector<glm::vec3> points = outermost_;
  if (scene_.picture.show_wind) {
    const std::vector<glm::vec3> arrows =
        wind_arrows(scene_.surroundings.forces.wind, garment_.mesh.positions);
    points.insert(points.end(), arrows.begin(), arrows.end());
  }
  const renderer::Camera camera = renderer::fit_camera_to_points(points, framing_, aspect_);
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  Ground& ground = scene.picture.ground;
  const std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  if (ground.kind == GroundKind::automatic && !level_plane(bodies, 0.0)) {
    const float below_m = ground_below(lowest_m_, highest_m_);
    const float gap = lowest_m_ - below_m;  // feet rise and sink a little as they walk
    ground = {GroundKind::fixed,
              static_cast<double>(standing_height(bodies, lowest_m_ + gap).value_or(below_m))};
  }
}

float share_in_picture(const renderer::Camera& camera, float aspect, std::span<const sim::Vec3> positions) {
  const glm::mat4 to_clip = camera.projection(aspect) * camera.view();
  const auto is_seen = [&](const sim::Vec3& position) {
    const glm::vec4 clip = to_clip * glm::vec4(glm::vec3(position), 1.0F);
    return clip.w > 0.0F && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
  };
  const auto seen = std::count_if(positions.begin(), positions.end(), is_seen);
  return static_cast<float>(seen) / static_cast<float>(std::max<std::size_t>(positions.size(), 1));
}

}  // namespace taut::app
