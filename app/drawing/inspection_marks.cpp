#include "app/drawing/inspection_marks.hpp"

#include "app/drawing/garment_painter.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

const renderer::Colour border_colour = renderer::rgb(0x1C1C1C);
const renderer::Colour non_manifold_colour = renderer::rgb(0xD00000);
const renderer::Colour misoriented_colour = renderer::rgb(0x7B2CBF);
const renderer::Colour hanger_colour = renderer::rgb(0xB8860B);
const renderer::Colour joined_colour = renderer::rgb(0xFFD000);

// Fraction of vertices. If more were welded, they are not marked: in a model without shared vertices all
// would be.
constexpr double most_joined = 0.3;

void add_line(const LoadedGarment& loaded, const sim::Edge& ends, InspectionMarks& marks) {
  for (const sim::Index end : ends) marks.points.emplace_back(loaded.garment->mesh.positions[end]);
}

InspectionMarks springs_of(const LoadedGarment& loaded, sim::SpringKind kind, float width_px) {
  const sim::Springs& springs = loaded.garment->springs;
  InspectionMarks marks{.meaning = fmt::format("{} springs: {}", sim::name_of(kind), springs.count(kind)),
                        .colour = spring_colour(kind),
                        .width_px = width_px};
  for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
    add_line(loaded, springs.ends[s], marks);
  }
  return marks;
}

bool is_misoriented(const sim::Garment& garment, std::size_t edge) {
  const auto triangles = garment.adjacency.edge_triangles[edge];
  return triangles.size() == 2 &&
         sim::runs_along(garment.mesh.triangles[triangles[0]], garment.adjacency.edges[edge]) ==
             sim::runs_along(garment.mesh.triangles[triangles[1]], garment.adjacency.edges[edge]);
}

template <class Chosen>
InspectionMarks edges_where(const LoadedGarment& loaded, InspectionMarks marks, const Chosen& chosen) {
  const sim::Adjacency& adjacency = loaded.garment->adjacency;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (chosen(e)) add_line(loaded, adjacency.edges[e], marks);
  }
  marks.meaning = fmt::format("{}: {}", marks.meaning, marks.points.size() / 2);
  return marks;
}

// Positions that several vertices of the file have: the two sides of its seams, or equal layers.
InspectionMarks joined_vertices(const LoadedGarment& loaded, float diameter_px) {
  InspectionMarks marks{
      .meaning = "", .colour = joined_colour, .width_px = diameter_px, .dots = true, .seen_through = false};
  if (!loaded.model || !loaded.placement) return marks;
  std::vector<sim::Vec3> places = loaded.model->positions;
  const auto before = [](const sim::Vec3& a, const sim::Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::ranges::sort(places, before);
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] == places[i - 1] && (i == 1 || places[i] != places[i - 2])) {
      marks.points.emplace_back((*loaded.placement)(places[i]));
    }
  }
  if (static_cast<double>(marks.points.size()) >
      most_joined * static_cast<double>(loaded.garment->mesh.positions.size())) {
    marks.points.clear();
  }
  marks.meaning = fmt::format("several vertices in the file: {}", marks.points.size());
  return marks;
}

InspectionMarks crossing_triangles(const LoadedGarment& loaded, std::span<const CrossingPair> crossings) {
  InspectionMarks marks{.meaning = fmt::format("pairs of triangles that cross: {}", crossings.size()),
                        .colour = crossing_colour,
                        .width_px = 5.0F,
                        .seen_through = true};
  for (const CrossingPair& pair : crossings) {
    for (const sim::Index triangle : {pair.first, pair.second}) {
      const sim::Triangle& t = loaded.garment->mesh.triangles[triangle];
      add_line(loaded, {t[0], t[1]}, marks);
      add_line(loaded, {t[1], t[2]}, marks);
      add_line(loaded, {t[2], t[0]}, marks);
    }
  }
  return marks;
}

InspectionMarks hanger_of(const LoadedGarment& loaded) {
  InspectionMarks marks{
      .meaning = "hanger", .colour = hanger_colour, .width_px = 10.0F, .opacity = 0.8F, .seen_through = true};
  for (const sim::Body& bar : loaded.hanger) {
    const auto& capsule = std::get<sim::Capsule>(bar.shape);
    marks.points.insert(marks.points.end(), {glm::vec3(capsule.start_m), glm::vec3(capsule.end_m)});
  }
  return marks;
}

constexpr float radian_per_degree = 0.017453293F;
constexpr float elevation_rad = 10.0F * radian_per_degree;
constexpr std::array azimuths_rad = {20.0F * radian_per_degree, 200.0F * radian_per_degree};
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

/// Returns the azimuths of the views of the garment's front and back, in radians.
std::array<float, 2> azimuths_of(std::span<const glm::vec3> points) {
  const renderer::Box box = renderer::bounding_box(points);
  const float turned_rad = azimuth_of_broad_side(box.upper - box.lower);
  return {azimuths_rad[0] + turned_rad, azimuths_rad[1] + turned_rad};
}

int height_of_panel_px(std::span<const glm::vec3> points) {
  float width = 0.0F, height = 0.0F;
  for (const float azimuth_rad : azimuths_of(points)) {
    const glm::vec2 size = seen_size(points, renderer::fit_camera_to_points(points, framing_of(azimuth_rad), 1.0F));
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

void add_marks(const std::vector<InspectionMarks>& all, renderer::FrameView& frame) {
  for (const InspectionMarks& marks : all) {
    if (marks.dots) {
      // Outlined, they stand out from springs of any colour.
      frame.points.push_back({.centres = marks.points,
                              .colours = std::span(&palette::ink, 1),
                              .diameter_px = marks.width_px + 2.0F * mark_outline_px,
                              .hidden_by_surfaces = !marks.seen_through});
      frame.points.push_back({.centres = marks.points,
                              .colours = std::span(&marks.colour, 1),
                              .diameter_px = marks.width_px,
                              .hidden_by_surfaces = !marks.seen_through});
    } else {
      frame.lines.push_back({.points = marks.points,
                             .colours = std::span(&marks.colour, 1),
                             .width_px = marks.width_px,
                             .opacity = marks.opacity,
                             .hidden_by_surfaces = !marks.seen_through});
    }
  }
}

}  // namespace

renderer::Image draw_marked(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                            std::span<const sim::Index> pins, const std::vector<sim::Vec3>& positions_m, double time_s,
                            const std::vector<InspectionMarks>& marks, bool is_page) {
  GarmentPainter painter(renderer, scene, garment, pins);
  renderer::FrameView frame = painter.view(positions_m, time_s);
  if (is_page) {
    frame.backdrop.plain = true;
    frame.backdrop.lower_colour = renderer::rgb(0xFFFFFF);
  }
  add_marks(marks, frame);
  return renderer.draw(frame, scene.picture.settings);
}

std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, std::span<const CrossingPair> crossings,
                                              const MarkWidths& widths) {
  const float spring_width_px = widths.spring_px;
  const sim::Adjacency& adjacency = loaded.garment->adjacency;
  std::vector<InspectionMarks> all;
  // Flexural springs lie under the structural ones they skip along: wider, they show on both sides, and pale,
  // they leave those to be seen.
  all.push_back(springs_of(loaded, sim::SpringKind::flexural, 2.4F * spring_width_px));
  all.back().opacity = 0.45F;
  all.push_back(springs_of(loaded, sim::SpringKind::shear, spring_width_px));
  all.push_back(springs_of(loaded, sim::SpringKind::structural, spring_width_px));
  all.push_back(
      edges_where(loaded, {.meaning = "edges of a border", .colour = border_colour, .width_px = 3.0F + spring_width_px},
                  [&](std::size_t e) { return adjacency.edge_triangles[e].size() == 1; }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges whose sides disagree about the outside",
                             .colour = misoriented_colour,
                             .width_px = 5.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return is_misoriented(*loaded.garment, e); }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges with more than two triangles",
                             .colour = non_manifold_colour,
                             .width_px = 6.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return adjacency.edge_triangles[e].size() > 2; }));
  all.push_back(crossing_triangles(loaded, crossings));
  all.push_back(joined_vertices(loaded, widths.dot_px));
  all.push_back(hanger_of(loaded));
  std::erase_if(all, [](const InspectionMarks& marks) { return marks.points.empty(); });
  return all;
}

InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Index> pins) {
  const std::vector<glm::vec3> points =
      points_to_be_seen(garment, pins, pin_radius_m(expected_reach(asked, garment, pins)));
  InspectionViews views{.sides = {{{"from the front", {}}, {"from behind", {}}}},
                        .height_px = height_of_panel_px(points)};
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
  views.px_per_m = static_cast<float>(views.height_px) / (2.0F * distance_m * std::tan(0.5F * field_of_view_rad));
  return views;
}

}  // namespace taut::app
