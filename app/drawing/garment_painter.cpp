#include "app/drawing/garment_painter.hpp"

namespace taut::app {
namespace {

// Fractions of an edge length. Layers farther than max_clearance_fraction are not searched for, which saves time; they
// would hardly show.
constexpr float max_bulge_fraction = 0.1F;
constexpr float max_fairing_fraction = 0.15F;
constexpr float max_clearance_fraction = 0.45F;
// Limit in metres on the fairing of meshes with long edges, so that the surface still follows the vertices.
constexpr float max_fairing_m = 0.004F;
// Fraction of the distance between two layers or bodies that each surface may use.
constexpr float clearance_share = 0.45F;
// Size of a garment beyond which its motion has failed; distances are then not searched for.
constexpr double max_size_m = 1e4;

std::vector<sim::Triangle> collect_triangles(std::span<const sim::Body> bodies, std::size_t first_vertex) {
  std::vector<sim::Triangle> triangles;
  auto first = static_cast<sim::Index>(first_vertex);
  for (const sim::Body& body : bodies) {
    if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
      for (const sim::Triangle& t : mesh->data->triangles) {
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
      first += static_cast<sim::Index>(mesh->data->positions_m.size());
    }
  }
  return triangles;
}

void append_mesh_positions(std::span<const sim::Body> bodies, double time_s, std::vector<sim::Vec3>& positions_m) {
  for (const sim::Body& body : bodies) {
    if (!std::holds_alternative<sim::BodyMesh>(body.shape)) continue;
    const std::vector<sim::Vec3> own_m = mesh_positions_m(body, time_s);
    positions_m.insert(positions_m.end(), own_m.begin(), own_m.end());
  }
}

const renderer::Colour outline_colour = renderer::rgb(0xC0392B);
const renderer::Colour wind_colour = renderer::rgb(0x24303C);
const renderer::Colour wind_rim_colour = renderer::rgb(0xFFFFFF);

// Picture height in pixels up to which lines are one pixel wide. In larger pictures line widths grow in proportion, so
// that a large picture looks like a small one.
constexpr float one_pixel_line_height_px = 600.0F;

// Maximum number of pins that throw shadows. The gaps between the shadows of a row of pins would streak the cloth.
constexpr std::size_t max_pins_with_shadows = 8;

// Size limit of a following model that is smoothed; a finer one is smooth already.
constexpr std::size_t max_smoothed_vertices = 20'000;

// Width of spring lines, in units of line_width_px.
constexpr float spring_width_factor = 1.2F;

float line_width_px(const renderer::PictureSettings& settings) {
  return std::max(1.0F, static_cast<float>(settings.height_px) / one_pixel_line_height_px);
}

PictureStyle drawn_style(PictureStyle style) {
  style.settings = to_picture_settings(style);
  return style;
}

std::vector<glm::vec3> borders(const sim::Garment& garment) {
  std::vector<glm::vec3> points;
  for (std::size_t e = 0; e < garment.adjacency.edges.size(); ++e) {
    if (garment.adjacency.edge_triangles[e].size() == 1) {
      for (const sim::Index end : garment.adjacency.edges[e]) points.emplace_back(garment.mesh.positions[end]);
    }
  }
  return points;
}

sim::Garment part_measured(const sim::Garment& garment, const PictureStyle& style) {
  sim::Garment part;
  if (style.surface != SurfaceLook::stretch) return part;
  if (style.stretch_of == StretchOf::surface) {
    part.mesh = garment.mesh;
    part.triangles_at_rest = garment.triangles_at_rest;
  } else {
    part.springs = garment.springs;
  }
  return part;
}

/// Returns true for styles that draw the simulated mesh even if a model follows it.
bool shows_simulated(const PictureStyle& style) {
  return style.surface != SurfaceLook::shaded || style.wireframe || style.springs != WhichSprings::none;
}

/// Returns the colours of the drawn triangles.
DrawnColours shown_colours(const PictureStyle& style, DrawnColours colours) {
  return colours.following && shows_simulated(style) ? DrawnColours{} : std::move(colours);
}

std::optional<sim::Garment> followed_model(const DrawnColours& colours, const sim::Garment& garment) {
  if (!colours.following) return std::nullopt;
  return sim::make_garment(colours.following->mesh, {.flexural_rule = sim::FlexuralRule::none}, garment.material);
}

}  // namespace

SurfaceClearances::SurfaceClearances(const DrawnScene& scene, const sim::Garment& garment,
                                     std::vector<sim::Body> bodies, float edge_m, float rim_radius_m)
    : freedom_{max_bulge_fraction * edge_m, std::min(max_fairing_fraction * edge_m, max_fairing_m)},
      max_clearance_m_(max_clearance_fraction * edge_m + renderer::rim_depth_radii * rim_radius_m / clearance_share),
      bodies_(std::move(bodies)),
      garment_vertices_(garment.mesh.positions.size()),
      positions_m_(garment.mesh.positions) {
  const SolverChoice& solver = scene.simulation.solver;
  const bool layers_apart = solver.kind == sim::SolverKind::bounded && solver.bounded.contact;
  if (!layers_apart && bodies_.empty()) return;
  append_mesh_positions(bodies_, 0.0, positions_m_);
  clearances_.emplace(garment.mesh.triangles, collect_triangles(bodies_, garment_vertices_), layers_apart,
                      positions_m_);
}

std::span<const float> SurfaceClearances::find(const std::vector<sim::Vec3>& positions, double time_s) {
  if (!clearances_) return {};
  const double size_m = glm::length(sim::compute_extent(positions).size());
  if (!(size_m < max_size_m)) {
    vertex_clearances_m_.assign(positions_m_.size(), 0.0F);
    return vertex_clearances_m_;
  }
  positions_m_.assign(positions.begin(), positions.end());
  append_mesh_positions(bodies_, time_s, positions_m_);
  const std::span<const float> clearances_m = clearances_->find(positions_m_, max_clearance_m_);
  vertex_clearances_m_.assign(clearances_m.begin(), clearances_m.end());
  keep_off_shapes(time_s);
  for (float& room_m : vertex_clearances_m_) room_m *= clearance_share;
  return vertex_clearances_m_;
}

void SurfaceClearances::keep_off_shapes(double time_s) {
  for (const sim::Body& body : bodies_) {
    if (std::holds_alternative<sim::BodyMesh>(body.shape)) continue;
    const sim::Shape shape = sim::shape_at(body, time_s);
    for (std::size_t v = 0; v < garment_vertices_; ++v) {
      const double distance_m = sim::nearest_surface(shape, positions_m_[v]).distance_m;
      vertex_clearances_m_[v] = std::clamp(static_cast<float>(distance_m), 0.0F, vertex_clearances_m_[v]);
    }
  }
}

float pin_radius_m(const renderer::Box& reach) { return 0.008F * glm::distance(reach.lower, reach.upper); }

GarmentPainter::GarmentPainter(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                               const std::vector<sim::Body>& bodies, std::span<const sim::Index> pins,
                               DrawnColours colours)
    : renderer_(renderer),
      style_(drawn_style(scene.picture)),
      legend_(stretch_legend(scene)),
      stretch_source_(part_measured(garment, scene.picture)),
      pins_(pins.begin(), pins.end()),
      colours_(shown_colours(style_, std::move(colours))),
      simulated_(garment.mesh.triangles),
      model_(followed_model(colours_, garment)),
      surface_(model_ ? *model_ : garment, colours_.corner_coordinates, colours_.base_colour_of_triangle),
      surface_clearances_(scene, model_ ? *model_ : garment, bodies, surface_.edge_m(), surface_.rim_radius_m()),
      structural_edges_(garment.springs.ends.begin(),
                        garment.springs.ends.begin() + static_cast<std::ptrdiff_t>(garment.springs.structural_count)),
      line_width_px_(line_width_px(style_.settings)),
      spring_lines_(garment, style_.springs, spring_width_factor * line_width_px_),
      bodies_(bodies) {
  const renderer::Box reach = expected_reach(scene, garment, bodies, pins);
  surface_.set_freedom(surface_clearances_.freedom());
  surface_.set_wrinkled(style_.wrinkles && style_.surface == SurfaceLook::shaded);
  camera_ = scene_camera(scene, reach, style_.settings.aspect());
  look_from(camera_, min_edge_px(style_));
  if (scene.camera.follow) rest_centre_m_ = mean_position(garment.mesh.positions);
  frame_.ground_height_m = ground_height(scene, bodies, reach);
  frame_.backdrop = to_backdrop(scene.picture.background);
  pin_radius_m_ = pin_radius_m(reach);
  if (style_.rest_outline) add_rest_outline(garment);
  if (style_.show_wind) add_wind(scene, garment);
  fixed_line_count_ = frame_.lines.size();
}

void GarmentPainter::place_bodies(double time_s, std::span<const float> clearances_m) {
  bodies_.move_to(time_s, clearances_m);
  frame_.surfaces = bodies_.views();
  if (style_.ground.kind == GroundKind::automatic) {
    if (const auto height_m = level_plane(bodies_.bodies(), time_s)) frame_.ground_height_m = height_m;
  }
}

void GarmentPainter::add_rest_outline(const sim::Garment& garment) {
  rest_outline_ = borders(garment);
  frame_.lines.push_back({.points = rest_outline_,
                          .colour = outline_colour,
                          .width_px = 1.5F * line_width_px_,
                          .hidden_by_surfaces = false});
}

void GarmentPainter::add_wind(const DrawnScene& scene, const sim::Garment& garment) {
  wind_arrows_ = wind_arrows(scene.surroundings.forces.wind, garment.mesh.positions, camera_);
  for (const bool is_rim : {true, false}) {
    frame_.lines.push_back({.points = wind_arrows_,
                            .colour = is_rim ? wind_rim_colour : wind_colour,
                            .width_px = (is_rim ? 8.0F : 5.0F) * line_width_px_,
                            .hidden_by_surfaces = false});
  }
}

void GarmentPainter::look_from(const renderer::Camera& camera, float min_edge_px) {
  camera_ = frame_.camera = camera;
  frame_.lighting = renderer::studio_lighting(camera);
  const float seen_m = 2.0F * glm::distance(camera.eye, camera.target) * std::tan(0.5F * camera.vertical_fov_rad);
  // Spring lines lie on the simulated triangles.
  const bool is_smooth = style_.smooth && style_.surface != SurfaceLook::wireframe &&
                         style_.springs == WhichSprings::none &&
                         !(model_ && model_->mesh.triangles.size() > max_smoothed_vertices);
  const float pixels_per_m = static_cast<float>(style_.settings.height_px) / seen_m;
  const std::optional<float> shortest = is_smooth ? std::optional(min_edge_px) : std::nullopt;
  surface_.set_detail(pixels_per_m, shortest);
  // A finer body would show through coarse cloth.
  bodies_.set_detail(pixels_per_m, surface_.is_refined() ? shortest : std::nullopt);
}

renderer::SurfaceView GarmentPainter::garment_view() {
  renderer::SurfaceView surface = surface_.view();
  surface.style = style_.cloth;
  const bool is_wireframe = style_.surface == SurfaceLook::wireframe;
  if (is_wireframe || style_.springs != WhichSprings::none) {
    surface.style.outside_colour = pale_outside;
    surface.style.inside_colour = pale_inside;
    surface.base_colour_of_triangle = {};
  } else {
    surface.base_colours = colours_.base_colours;
  }
  if (style_.surface == SurfaceLook::stretch) {
    surface.scalars = renderer::ScalarColours{stretch_, legend_.minimum, legend_.maximum, legend_.map};
    surface.trims = {};  // trims would change the scalars that stand for stretch
  }
  if (style_.wireframe || is_wireframe) {
    wireframe_ = surface_.refined_edges(structural_edges_);
    surface.wireframe = renderer::Wireframe{.edges = wireframe_, .width_px = line_width_px_};
  }
  return surface;
}

const renderer::FrameView& GarmentPainter::view(const std::vector<sim::Vec3>& positions, double time_s,
                                                const std::vector<sim::Vec3>& given_m) {
  const std::vector<sim::Vec3> shown_m = !model_           ? positions
                                         : given_m.empty() ? colours_.following->shown_m(positions, simulated_)
                                                           : given_m;
  positions_ = to_float(shown_m);
  const std::span<const float> clearances_m =
      surface_.leaves_triangles() ? surface_clearances_.find(shown_m, time_s) : std::span<const float>();
  const std::size_t own_count = std::min(clearances_m.size(), shown_m.size());
  surface_.place(positions_, clearances_m.first(own_count));
  place_bodies(time_s, clearances_m.subspan(own_count));
  if (style_.surface == SurfaceLook::stretch) {
    const std::vector<double> stretch = style_.stretch_of == StretchOf::surface
                                            ? sim::vertex_surface_stretch(stretch_source_, positions)
                                            : sim::vertex_stretch(stretch_source_.springs, positions);
    stretch_.assign(stretch.begin(), stretch.end());
    surface_.interpolate(stretch_);
  }
  if (rest_centre_m_) {
    const glm::vec3 shift = mean_position(positions) - *rest_centre_m_;
    frame_.camera.eye = camera_.eye + shift;
    frame_.camera.target = camera_.target + shift;
  }
  frame_.surfaces.push_back(garment_view());
  frame_.lines.resize(fixed_line_count_);
  spring_lines_.add(positions_, frame_);
  frame_.spheres.clear();
  if (style_.show_pins && !pins_.empty()) {
    pin_positions_.clear();
    for (const sim::Index pin : pins_) pin_positions_.emplace_back(positions[pin]);
    frame_.spheres.push_back(
        {.centres = pin_positions_, .radius_m = pin_radius_m_, .casts_shadow = pins_.size() <= max_pins_with_shadows});
  }
  return frame_;
}

renderer::Legend stretch_legend(const DrawnScene& scene) {
  const auto [lowest, highest] = shown_stretch_range(scene);
  renderer::Legend legend;
  legend.title = legend_title(scene.picture.stretch_of);
  legend.minimum = static_cast<float>(lowest);
  legend.maximum = static_cast<float>(highest);
  legend.map = scene.picture.stretch_colours;
  if (const std::optional<double> bound = shown_bound(scene)) legend.bound = static_cast<float>(*bound);
  legend.factor = 100.0F;
  legend.suffix = " %";
  legend.more_above = true;
  return legend;
}

}  // namespace taut::app
