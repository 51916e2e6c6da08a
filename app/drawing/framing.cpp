#include "app/drawing/framing.hpp"

#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/hanger.hpp"

namespace taut::app {
namespace {

const renderer::Colour body_colour = renderer::rgb(0xB9B4AC);

// Largest distance of the drawn surface from its triangles where no cloth is near, as a fraction of the edge length.
constexpr float max_body_bulge = 0.2F;

float mean_edge_m(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
  double sum_m = 0.0;
  for (std::uint32_t side = 0; side < triangles.size(); ++side) {
    sum_m += glm::distance(positions[triangles[side]], positions[triangles[renderer::next_corner(side)]]);
  }
  return static_cast<float>(sum_m / static_cast<double>(std::max<std::size_t>(triangles.size(), 1)));
}

renderer::SurfaceView plain_view(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                 std::span<const std::uint32_t> triangles) {
  renderer::SurfaceView view;
  view.positions = positions;
  view.normals = normals;
  view.triangles = triangles;
  view.style.inside_colour = view.style.outside_colour = body_colour;
  view.style.translucency = 0.0F;
  return view;
}

// Adds the drawn meshes of a round body. A capsule with two radii is drawn as two balls joined by a capsule of the
// larger radius.
struct RoundMaker {
  std::vector<renderer::TriangleMesh>& meshes;

  void operator()(const auto&) const {}
  void operator()(const sim::Sphere& ball) const {
    meshes.push_back(renderer::make_sphere(glm::vec3(ball.centre_m), static_cast<float>(ball.radius_m)));
  }
  void operator()(const sim::Capsule& limb) const {
    meshes.push_back(renderer::make_capsule(glm::vec3(limb.start_m), glm::vec3(limb.end_m),
                                            static_cast<float>(std::min(limb.start_radius_m, limb.end_radius_m))));
    if (limb.start_radius_m != limb.end_radius_m) {
      (*this)(sim::Sphere{limb.start_m, limb.start_radius_m});
      (*this)(sim::Sphere{limb.end_m, limb.end_radius_m});
    }
  }
};

// Hook of a hanger, in metres: radius of the wire, length of the neck, radius of the bend; fraction of a circle that
// the bend covers.
constexpr float wire_m = 0.0022F, neck_m = 0.03F, bend_m = 0.02F, bend_fraction = 0.7F;
constexpr int bend_segment_count = 16;
constexpr double bar_radius_factor = 0.75;

void add_hook(const sim::Capsule& bar, std::vector<renderer::TriangleMesh>& meshes) {
  const glm::vec3 foot(bar.start_m);
  const glm::vec3 up{0.0F, 1.0F, 0.0F};
  glm::vec3 aside(bar.end_m - bar.start_m);
  aside = glm::normalize(glm::vec3{aside.x, 0.0F, aside.z});
  const glm::vec3 middle = foot + (neck_m + bend_m) * up;
  glm::vec3 from = foot;
  for (int i = 0; i <= bend_segment_count; ++i) {
    const float turn = 2.0F * std::numbers::pi_v<float> * bend_fraction * static_cast<float>(i) / bend_segment_count;
    const glm::vec3 to = middle + bend_m * (std::sin(turn) * aside - std::cos(turn) * up);
    meshes.push_back(renderer::make_capsule(from, to, wire_m, 10));
    from = to;
  }
}

// Wind speed that gets the longest arrows.
constexpr float max_arrow_wind_m_per_s = 20.0F;
// Fractions of the box's radius: shortest arrow, distance between arrows, gap between arrow heads and box, and length
// of an arrow head; the head's half width as a fraction of its length.
constexpr float min_arrow_ratio = 0.25F;
constexpr float arrow_spacing_ratio = 0.4F;
constexpr float arrow_gap_ratio = 0.1F;
constexpr float arrow_head_ratio = 0.12F;
constexpr float arrow_head_width_ratio = 0.5F;

// Gap between cloth and floor, as a fraction of the height of everything shown. Without it hanging cloth seems to
// stand.
constexpr float ground_gap_fraction = 0.06F;

// Ratio of depth to width above which a garment is viewed from its side, where it is broader.
constexpr float min_depth_ratio = 1.5F;

// Component of the front direction towards the camera above which the view is already from the front.
constexpr double min_front_component = 0.7;

// Maximum number of vertex-pin pairs to compare. Above it some pins are skipped, which can enlarge the reach of a fine
// mesh by about an edge length. A lower limit saves time.
constexpr std::size_t max_pin_comparisons = 50'000'000;

// Casting a value that no float can hold is undefined behaviour.
float round_to_float(double coordinate) {
  constexpr double max_float = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(coordinate, -max_float, max_float));
}

double distance_to_nearest_pin(const sim::Garment& garment, std::span<const sim::Index> pins, const sim::Vec3& point,
                               sim::Vec3& pin_m) {
  const std::size_t stride = 1 + pins.size() * garment.mesh.positions.size() / max_pin_comparisons;
  double min_distance_m = INFINITY;
  for (std::size_t k = 0; k < pins.size(); k += stride) {
    const sim::Index pin = pins[k];
    const double distance_m = glm::distance(garment.mesh.positions[pin], point);
    if (distance_m < min_distance_m) {
      min_distance_m = distance_m;
      pin_m = garment.mesh.positions[pin];
    }
  }
  return min_distance_m;
}

renderer::Box box_of_ball(const sim::Vec3& centre_m, double radius_m) {
  const glm::vec3 centre(centre_m), half(static_cast<float>(radius_m));
  return {centre - half, centre + half};
}

// Returns the aspect ratio without the legend at the left and an equal strip at the right, which keeps the garment
// centred.
float aspect_beside_legend(const PictureStyle& style) {
  constexpr float legend_share = 0.23F;  // fraction of the picture's height
  constexpr float min_aspect = 0.4F;
  const float aspect = style.settings.aspect();
  const bool has_legend = style.surface == SurfaceLook::stretch && style.legend;
  return has_legend ? std::max(aspect - 2.0F * legend_share, std::min(aspect, min_aspect)) : aspect;
}

/// Returns the height in metres of the lowest point of the mesh bodies at the run's start. Empty if there are no such
/// bodies or they float above min_height_m, the lowest point of everything.
std::optional<float> standing_height(std::span<const sim::Body> bodies, float min_height_m) {
  std::optional<float> height_m;
  for (const sim::Body& body : bodies) {
    if (std::holds_alternative<sim::BodyMesh>(body.shape)) {
      height_m = std::min(height_m.value_or(INFINITY), bounding_box(body, 0.0)->lower.y);
    }
  }
  return height_m && *height_m <= min_height_m ? height_m : std::nullopt;
}

/// Returns the height in metres of a floor slightly below everything between the two heights.
float ground_below(float min_height_m, float max_height_m) {
  return min_height_m - ground_gap_fraction * (max_height_m - min_height_m);
}

}  // namespace

DrawnBodies::DrawnBodies(std::vector<sim::Body> bodies)
    : bodies_(std::move(bodies)),
      move_(std::ranges::any_of(bodies_, [](const sim::Body& body) { return sim::is_moving_after(body, 0.0); })),
      round_(bodies_.size()) {
  std::size_t first_clearance = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (const auto* shape = std::get_if<sim::BodyMesh>(&bodies_[b].shape)) {
      ShownMesh& mesh = meshes_[b];
      mesh.rest_positions = to_float(shape->data->positions_m);
      mesh.triangles = flat(shape->data->triangles);
      mesh.edge_m = mean_edge_m(mesh.rest_positions, mesh.triangles);
      mesh.first_clearance = first_clearance;
      first_clearance += mesh.rest_positions.size();
    }
  }
}

void DrawnBodies::set_detail(float pixels_per_m, std::optional<float> min_edge_px) {
  for (auto& [body, mesh] : meshes_) {
    const int levels =
        !min_edge_px ? 0
                     : renderer::refinement_levels(mesh.edge_m * pixels_per_m, mesh.triangles.size() / 3, *min_edge_px);
    if (!mesh.surface || levels != mesh.levels) {
      mesh.levels = levels;
      mesh.surface.emplace(mesh.rest_positions, mesh.triangles, levels,
                           renderer::SurfaceFreedom{max_body_bulge * mesh.edge_m});
      placed_s_.reset();
    }
  }
}

void DrawnBodies::move_to(double time_s, std::span<const float> clearances_m) {
  const bool stays = placed_s_ && (!move_ || *placed_s_ == time_s);
  if (stays && clearances_m.empty()) return;
  for (auto& [body, mesh] : meshes_) {
    mesh.surface->place(
        to_float(mesh_positions_m(bodies_[body], time_s)),
        clearances_m.empty() ? clearances_m : clearances_m.subspan(mesh.first_clearance, mesh.rest_positions.size()));
  }
  for (std::size_t b = 0; b < bodies_.size() && !stays; ++b) {
    round_[b].clear();
    sim::Shape shape = sim::shape_at(bodies_[b], time_s);
    if (auto* bar = std::get_if<sim::Capsule>(&shape); bar != nullptr && bodies_[b].name.starts_with("hanger, ")) {
      // The drawn surface cuts corners and would show a bar of full radius.
      bar->start_radius_m *= bar_radius_factor;
      bar->end_radius_m *= bar_radius_factor;
      if (bodies_[b].name == hanger_left) add_hook(*bar, round_[b]);
    }
    std::visit(RoundMaker{round_[b]}, shape);
  }
  placed_s_ = time_s;
}

std::vector<renderer::SurfaceView> DrawnBodies::views() const {
  std::vector<renderer::SurfaceView> views;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (const renderer::TriangleMesh& mesh : round_[b]) {
      views.push_back(plain_view(mesh.positions, mesh.normals, mesh.triangles));
    }
    if (const auto mesh = meshes_.find(b); mesh != meshes_.end()) {
      const renderer::SmoothSurface& surface = *mesh->second.surface;
      renderer::SurfaceView& view =
          views.emplace_back(plain_view(surface.positions(), surface.normals(), surface.triangles()));
      view.refinement = renderer::Refinement{surface.mesh().coarse_vertex_count(), mesh->second.triangles,
                                             surface.parents(), surface.parent_triangles()};
    }
  }
  return views;
}

std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions,
                                   const renderer::Camera& camera) {
  std::vector<glm::vec3> lines;
  const auto speed = static_cast<float>(wind.speed_m_per_s);
  if (speed <= 0.0F) return lines;
  const glm::vec3 along = glm::normalize(glm::vec3(wind.direction));
  const glm::mat3 view_axes = glm::transpose(glm::mat3(camera.view()));  // right, up and towards the eye
  const glm::vec3 aside = glm::dot(view_axes[0], along) > 0.0F ? -view_axes[0] : view_axes[0];
  const glm::vec3 across = glm::cross(along, view_axes[2]);
  const glm::vec3 head_side = glm::length(across) > 1e-3F ? glm::normalize(across) : aside;
  const renderer::Box around = renderer::bounding_box(to_float(positions));
  const glm::vec3 half = 0.5F * (around.upper - around.lower);
  const float radius = glm::length(half);
  const float length = radius * std::clamp(speed / max_arrow_wind_m_per_s, min_arrow_ratio, 1.0F);
  const float gap = glm::dot(glm::abs(aside), half) + arrow_gap_ratio * radius;
  for (const float row : {-1.0F, 0.0F, 1.0F}) {
    const glm::vec3 tip =
        0.5F * (around.lower + around.upper) + gap * aside + glm::vec3(0.0F, arrow_spacing_ratio * radius * row, 0.0F);
    lines.insert(lines.end(), {tip - length * along, tip});
    for (const float side : {-arrow_head_width_ratio, arrow_head_width_ratio}) {
      lines.insert(lines.end(), {tip, tip - arrow_head_ratio * radius * (along + side * head_side)});
    }
  }
  return lines;
}

std::optional<renderer::Box> bounding_box(const sim::Body& body, double time_s) {
  const sim::Shape shape = sim::shape_at(body, time_s);
  if (const auto* ball = std::get_if<sim::Sphere>(&shape)) return box_of_ball(ball->centre_m, ball->radius_m);
  if (const auto* limb = std::get_if<sim::Capsule>(&shape)) {
    return renderer::unite(box_of_ball(limb->start_m, limb->start_radius_m),
                           box_of_ball(limb->end_m, limb->end_radius_m));
  }
  if (std::holds_alternative<sim::Plane>(shape)) return std::nullopt;
  return renderer::bounding_box(to_float(mesh_positions_m(body, time_s)));
}

float azimuth_of_broad_side(const glm::vec3& size) {
  return size.z > min_depth_ratio * size.x ? 0.5F * std::numbers::pi_v<float> : 0.0F;
}

std::optional<float> level_plane(std::span<const sim::Body> bodies, double time_s) {
  for (const sim::Body& body : bodies) {
    const sim::Shape shape = sim::shape_at(body, time_s);
    const auto* plane = std::get_if<sim::Plane>(&shape);
    if (plane != nullptr && plane->normal.y > 0.999) return static_cast<float>(plane->point_m.y);
  }
  return std::nullopt;
}

std::vector<glm::vec3> to_float(std::span<const sim::Vec3> points) {
  std::vector<glm::vec3> nearest(points.size());
  std::ranges::transform(points, nearest.begin(), [](const sim::Vec3& point) {
    return glm::vec3{round_to_float(point.x), round_to_float(point.y), round_to_float(point.z)};
  });
  return nearest;
}

glm::vec3 mean_position(std::span<const sim::Vec3> points) {
  const sim::Vec3 sum = std::accumulate(points.begin(), points.end(), sim::Vec3(0.0));
  return glm::vec3(sum / static_cast<double>(points.size()));
}

renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment, std::span<const sim::Body> bodies,
                             std::span<const sim::Index> pins) {
  renderer::Box reach = renderer::bounding_box(to_float(garment.mesh.positions));
  for (const sim::Vec3& position : pins.empty() ? std::vector<sim::Vec3>{} : garment.mesh.positions) {
    sim::Vec3 pin(0.0);
    const double distance_m = distance_to_nearest_pin(garment, pins, position, pin);
    reach.lower.y = std::min(reach.lower.y, static_cast<float>(pin.y - distance_m));
  }
  for (const sim::Body& body : bodies) {
    if (const auto box = bounding_box(body, 0.0)) reach = renderer::unite(reach, *box);
  }
  if (const auto height_m = level_plane(bodies, 0.0)) {
    reach.lower.y = std::min(reach.lower.y, *height_m);
  }
  const glm::vec3 swing(glm::abs(glm::vec3(scene.surroundings.pin_motion.amplitude_m)));
  return {reach.lower - swing, reach.upper + swing};
}

renderer::Framing choose_framing(const DrawnScene& scene, const renderer::Box& reach) {
  renderer::Framing framing = scene.camera.framing;
  if (!scene.garment.file.empty() && framing.azimuth_rad == CameraSettings{}.framing.azimuth_rad) {
    framing.azimuth_rad += azimuth_of_broad_side(reach.upper - reach.lower);
  }
  return framing;
}

void face_front(const LoadedGarment& loaded, DrawnScene& scene) {
  float& azimuth_rad = scene.camera.framing.azimuth_rad;
  if (scene.garment.file.empty() || scene.camera.box || scene.camera.eye ||
      azimuth_rad != CameraSettings{}.framing.azimuth_rad) {
    return;
  }
  const GarmentMarks marks =
      find_garment_marks(*loaded.garment, surface_at_start(loaded).positions_m, loaded.landmarks);
  if (marks.is_front_known && !marks.is_worn_at_waist && marks.front.z < min_front_component) {
    azimuth_rad += static_cast<float>(std::atan2(marks.front.x, marks.front.z));
  }
}

renderer::Camera camera_at(const glm::vec3& eye, const glm::vec3& target, float vertical_fov_rad) {
  const float distance_m = glm::distance(eye, target);
  return {.eye = eye,
          .target = target,
          .vertical_fov_rad = vertical_fov_rad,
          .near_m = 0.02F * distance_m,
          .far_m = 20.0F * distance_m};
}

renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect) {
  const CameraSettings& asked = scene.camera;
  if (asked.eye) return camera_at(*asked.eye, *asked.target, asked.framing.vertical_fov_rad);
  return renderer::fit_camera_to_box(asked.box.value_or(reach), choose_framing(scene, reach), aspect);
}

std::optional<float> ground_height(const DrawnScene& scene, std::span<const sim::Body> bodies,
                                   const renderer::Box& reach) {
  const auto& ground = scene.picture.ground;
  if (ground.kind == GroundKind::none) return std::nullopt;
  if (ground.kind == GroundKind::fixed) return static_cast<float>(ground.height_m);
  const renderer::Box box = scene.camera.box.value_or(reach);
  const std::optional<float> plane_m = level_plane(bodies, 0.0);
  return plane_m ? plane_m : standing_height(bodies, reach.lower.y).value_or(ground_below(box.lower.y, box.upper.y));
}

bool is_fitted(const DrawnScene& scene) { return !scene.camera.box && !scene.camera.eye; }

FittedView::FittedView(const DrawnScene& scene, const sim::Garment& garment, std::vector<sim::Body> bodies)
    : scene_(scene),
      bodies_(std::move(bodies)),
      garment_(garment),
      framing_(choose_framing(scene, renderer::bounding_box(to_float(garment.mesh.positions)))),
      aspect_(aspect_beside_legend(scene.picture)) {}

void FittedView::add(const std::vector<sim::Vec3>& positions, const std::vector<sim::Vec3>& shown, double time_s) {
  std::vector<glm::vec3> points = to_float(shown);
  for (const sim::Body& body : bodies_) {
    if (const std::optional<renderer::Box> box = bounding_box(body, time_s)) {
      const auto corners = renderer::box_corners(*box);
      points.insert(points.end(), corners.begin(), corners.end());
    }
  }
  const glm::vec3 shift =
      scene_.camera.follow ? mean_position(positions) - mean_position(garment_.mesh.positions) : glm::vec3(0.0F);
  for (glm::vec3& point : points) {
    min_height_m_ = std::min(min_height_m_, point.y);
    max_height_m_ = std::max(max_height_m_, point.y);
    point -= shift;
  }
  const auto outermost = renderer::outermost_points(points, framing_, aspect_);
  outermost_.insert(outermost_.end(), outermost.begin(), outermost.end());
}

void FittedView::place_camera(DrawnScene& scene) const {
  if (outermost_.empty()) return;
  std::vector<glm::vec3> points = outermost_;
  renderer::Camera camera = renderer::fit_camera_to_points(points, framing_, aspect_);
  if (scene_.picture.show_wind) {
    const std::vector<glm::vec3> arrows = wind_arrows(scene_.surroundings.forces.wind, garment_.mesh.positions, camera);
    points.insert(points.end(), arrows.begin(), arrows.end());
    camera = renderer::fit_camera_to_points(points, framing_, aspect_);
  }
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  Ground& ground = scene.picture.ground;
  if (ground.kind == GroundKind::automatic && !level_plane(bodies_, 0.0)) {
    const float below_m = ground_below(min_height_m_, max_height_m_);
    const float gap_m = min_height_m_ - below_m;  // feet rise and sink a little as they walk
    ground = {GroundKind::fixed,
              static_cast<double>(standing_height(bodies_, min_height_m_ + gap_m).value_or(below_m))};
  }
}

}  // namespace taut::app
