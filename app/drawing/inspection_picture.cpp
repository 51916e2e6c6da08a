#include "app/drawing/inspection_picture.hpp"

#include "app/drawing/garment_painter.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

/// Colour of crossing triangles.
const renderer::Colour crossing_colour = renderer::rgb(0x00B140);
/// Width of the dark outline of dots.
constexpr float mark_outline_px = 2.0F;

constexpr int inspection_panel_px = 1000;  ///< width of one view

/// Two views of the garment as modelled, of the same size and scale.
struct InspectionViews {
  struct PanelSide {
    const char* name;
    DrawnScene scene;
  };
  std::array<PanelSide, 2> sides;
  float px_per_m = 0.0F;  ///< scale at the distance of the garment's middle
  int height_px = 0;      ///< height of a view, as small as the garment allows
};

const renderer::Colour border_colour = renderer::rgb(0x1C1C1C);
const renderer::Colour non_manifold_colour = renderer::rgb(0xD00000);
const renderer::Colour misoriented_colour = renderer::rgb(0x7B2CBF);
const renderer::Colour hanger_colour = renderer::rgb(0xB8860B);
const renderer::Colour joined_colour = renderer::rgb(0xFFD000);

// Maximum fraction of vertices for which welded vertices are marked. A model without shared vertices would be covered
// in marks.
constexpr double max_marked_fraction = 0.3;

void add_line(const LoadedGarment& loaded, const sim::Edge& ends, InspectionMarks& marks) {
  for (const sim::Index end : ends) marks.points.emplace_back(loaded.garment->mesh.positions[end]);
}

InspectionMarks mark_springs(const LoadedGarment& loaded, sim::SpringKind kind, float width_px) {
  const sim::Springs& springs = loaded.garment->springs;
  InspectionMarks marks{.meaning = fmt::format("{} springs: {}", sim::to_name(kind), springs.count(kind)),
                        .colour = spring_colour(kind),
                        .width_px = width_px};
  for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
    add_line(loaded, springs.ends[s], marks);
  }
  return marks;
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

// Marks positions that several vertices of the file share: the two sides of a seam, or coincident layers.
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
      max_marked_fraction * static_cast<double>(loaded.garment->mesh.positions.size())) {
    marks.points.clear();
  }
  marks.meaning = fmt::format("several vertices in the file: {}", marks.points.size());
  return marks;
}

InspectionMarks crossing_triangles(const LoadedGarment& loaded, std::span<const sim::CrossingPair> crossings) {
  InspectionMarks marks{.meaning = fmt::format("pairs of triangles that cross: {}", crossings.size()),
                        .colour = crossing_colour,
                        .width_px = 5.0F,
                        .seen_through = true};
  for (const sim::CrossingPair& pair : crossings) {
    for (const sim::Index triangle : {pair.first, pair.second}) {
      const sim::Triangle& t = loaded.garment->mesh.triangles[triangle];
      add_line(loaded, {t[0], t[1]}, marks);
      add_line(loaded, {t[1], t[2]}, marks);
      add_line(loaded, {t[2], t[0]}, marks);
    }
  }
  return marks;
}

InspectionMarks mark_hanger(const LoadedGarment& loaded) {
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
// Narrow field of view with little perspective, so that one scale bar is valid for the whole garment.
constexpr float field_of_view_rad = 0.12F;
// Fraction of the picture that stays free, for lines and balls at the garment's edge.
constexpr float margin = 0.025F;
// Minimum and maximum height of a view, as fractions of its width. They give a flat garment some height and keep a
// scarf from filling the page.
constexpr float min_height_to_width = 0.2F;
constexpr float max_height_to_width = 1.3F;

renderer::Framing make_framing(float azimuth_rad) {
  return {.azimuth_rad = azimuth_rad,
          .elevation_rad = elevation_rad,
          .vertical_fov_rad = field_of_view_rad,
          .margin = margin};
}

/// Returns the vertices, and the extreme points of the balls at pins.
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

/// Returns width and height of the points in the camera's view, divided by their distance.
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
std::array<float, 2> choose_azimuths(std::span<const glm::vec3> points) {
  const renderer::Box box = renderer::bounding_box(points);
  const float turned_rad = azimuth_of_broad_side(box.upper - box.lower);
  return {azimuths_rad[0] + turned_rad, azimuths_rad[1] + turned_rad};
}

int height_of_panel_px(std::span<const glm::vec3> points) {
  float width = 0.0F, height = 0.0F;
  for (const float azimuth_rad : choose_azimuths(points)) {
    const glm::vec2 size = seen_size(points, renderer::fit_camera_to_points(points, make_framing(azimuth_rad), 1.0F));
    width = std::max(width, size.x);
    height = std::max(height, size.y);
  }
  const float wanted = width > 0.0F ? height / width : max_height_to_width;
  return static_cast<int>(
      std::lround(inspection_panel_px * std::clamp(wanted, min_height_to_width, max_height_to_width)));
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
  scene.picture.smooth = false;
  scene.picture.cloth.outside_colour = pale_outside;
  scene.picture.cloth.inside_colour = pale_inside;
  scene.picture.cloth.weave = 0.0F;
  scene.picture.cloth.sheen = 0.0F;
  scene.picture.cloth.translucency = 0.0F;
  return scene;
}

void add_marks(const std::vector<InspectionMarks>& all, renderer::FrameView& frame) {
  for (const InspectionMarks& marks : all) {
    if (marks.dots) {
      // Outlined dots stand out from springs of any colour.
      frame.points.push_back({.centres = marks.points,
                              .colour = palette::ink,
                              .diameter_px = marks.width_px + 2.0F * mark_outline_px,
                              .hidden_by_surfaces = !marks.seen_through});
      frame.points.push_back({.centres = marks.points,
                              .colour = marks.colour,
                              .diameter_px = marks.width_px,
                              .hidden_by_surfaces = !marks.seen_through});
    } else {
      frame.lines.push_back({.points = marks.points,
                             .colour = marks.colour,
                             .width_px = marks.width_px,
                             .opacity = marks.opacity,
                             .hidden_by_surfaces = !marks.seen_through});
    }
  }
}

/// Draws a garment at these positions with marks. `is_page`: on a white page.
renderer::Image draw_marked(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                            const std::vector<sim::Body>& bodies, std::span<const sim::Index> pins,
                            const std::vector<sim::Vec3>& positions_m, double time_s,
                            const std::vector<InspectionMarks>& marks, bool is_page) {
  GarmentPainter painter(renderer, scene, garment, bodies, pins);
  renderer::FrameView frame = painter.view(positions_m, time_s);
  if (is_page) {
    frame.backdrop.plain = true;
    frame.backdrop.lower_colour = renderer::rgb(0xFFFFFF);
  }
  add_marks(marks, frame);
  return renderer.draw(frame, scene.picture.settings);
}

/// Makes both views from the user's scene.
InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Body> bodies, std::span<const sim::Index> pins) {
  const std::vector<glm::vec3> points =
      points_to_be_seen(garment, pins, pin_radius_m(expected_reach(asked, garment, bodies, pins)));
  InspectionViews views{.sides = {{{"from the front", {}}, {"from behind", {}}}},
                        .height_px = height_of_panel_px(points)};
  const float aspect = static_cast<float>(inspection_panel_px) / static_cast<float>(views.height_px);
  const std::array<float, 2> azimuths = choose_azimuths(points);
  std::array<renderer::Camera, azimuths.size()> cameras;
  float distance_m = 0.0F;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    cameras[k] = renderer::fit_camera_to_points(points, make_framing(azimuths[k]), aspect);
    distance_m = std::max(distance_m, glm::distance(cameras[k].eye, cameras[k].target));
  }
  // All views have the largest distance that one of them needs.
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

constexpr float border_px = 40.0F;
constexpr float gap_px = 24.0F;
constexpr float header_px = 175.0F;
constexpr float text_px = 26.0F;
constexpr float row_px = 1.7F * text_px;
constexpr auto panel_px = static_cast<float>(inspection_panel_px);
constexpr std::size_t legend_columns = 3;
constexpr float page_px = 2.0F * border_px + 2.0F * panel_px + gap_px;

const renderer::Colour pin_colour = renderer::rgb(0xC0392B);

// Returns the longest of 1, 2 and 5 times a power of ten that takes at most a quarter of a panel.
double bar_length_m(float px_per_m) {
  const double max_length_m = 0.25 * inspection_panel_px / static_cast<double>(px_per_m);
  const double power = std::pow(10.0, std::floor(std::log10(max_length_m)));
  return power * (max_length_m >= 5.0 * power ? 5.0 : max_length_m >= 2.0 * power ? 2.0 : 1.0);
}

std::string length_text(double length_m) {
  return length_m >= 1.0     ? fmt::format("{:g} m", length_m)
         : length_m >= 0.01  ? fmt::format("{:g} cm", 100.0 * length_m)
         : length_m >= 0.001 ? fmt::format("{:g} mm", 1e3 * length_m)
                             : fmt::format("{:g} m", length_m);
}

void draw_bar(renderer::Canvas& canvas, float x_px, float y_px, float px_per_m) {
  const double length_m = bar_length_m(px_per_m);
  const float end_px = x_px + static_cast<float>(length_m) * px_per_m;
  canvas.line(x_px, y_px, end_px, y_px, palette::ink, 3.0F);
  for (const float at_px : {x_px, end_px}) canvas.line(at_px, y_px - 8.0F, at_px, y_px + 8.0F, palette::ink, 3.0F);
  const renderer::TextStyle text = text_style(text_px).with_alignment(renderer::HorizontalAlign::centre);
  canvas.text(0.5F * (x_px + end_px), y_px - 0.6F * text_px, length_text(length_m), text);
}

// Shortens a text that is too long, such as a path, and ends it in dots.
std::string shorten(const renderer::Canvas& canvas, std::string text, const renderer::TextStyle& style) {
  const float max_width_px = page_px - 2.0F * border_px;
  if (canvas.measure(text, style).width_px <= max_width_px) return text;
  while (!text.empty() && canvas.measure(text + "…", style).width_px > max_width_px) {
    do {
      text.pop_back();
      // Stops only between letters, which may have several bytes.
    } while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U);
  }
  return text + "…";
}

std::vector<std::string> list_facts(const Json& facts) {
  const auto counted_of = [](const Json& count, const char* one, const char* many) {
    return count_text(count.get<std::size_t>(), one, many);
  };
  const Json &box = facts["bounding_box_m"], &repairs = facts["repairs"], &placement = facts["placement"];
  const auto size = [&](std::size_t k) { return box[1][k].get<double>() - box[0][k].get<double>(); };
  const auto repaired = [&](const char* name) { return repairs[name].get<std::size_t>(); };
  return {fmt::format("{}, {}, {}; {:.3g} x {:.3g} x {:.3g} m; unit: {}; up: {}",
                      counted_of(facts["vertices"], "vertex", "vertices"),
                      counted_of(facts["triangles"], "triangle", "triangles"),
                      counted_of(facts["topology"]["components"], "part", "parts"), size(0), size(1), size(2),
                      placement["unit"].get<std::string>(), placement["up_from"].get<std::string>()),
          fmt::format("repaired: {} joined, {} degenerate and {} repeated triangles removed, {} turned",
                      count_text(repaired("welded_vertices") + repaired("near_vertices") + repaired("sewn_vertices"),
                                 "vertex", "vertices"),
                      repaired("degenerate_triangles"), repaired("duplicate_triangles"), repaired("turned_triangles"))};
}

void draw_header(renderer::Canvas& canvas, const Json& facts) {
  const renderer::TextStyle name = text_style(1.4F * text_px, palette::ink, true);
  canvas.text(border_px, border_px + text_px,
              shorten(canvas, std::filesystem::path(facts["file"].get<std::string>()).filename().string(), name), name);
  const renderer::TextStyle fact = text_style(0.85F * text_px, palette::quiet_ink);
  float y_px = border_px + text_px + row_px;
  for (const std::string& line : list_facts(facts)) {
    canvas.text(border_px, y_px, shorten(canvas, line, fact), fact);
    y_px += 0.8F * row_px;
  }
}

struct LegendRow {
  std::string meaning;
  renderer::Colour colour{0.0F};
  enum class Sample { line, dot, area } sample = Sample::line;
  float width_px = 0.0F;
  bool outlined = false;
};

std::vector<LegendRow> make_legend(const std::vector<InspectionMarks>& all, std::size_t pins) {
  std::vector<LegendRow> rows;
  for (const InspectionMarks& marks : all) {
    rows.push_back({marks.meaning, marks.colour, marks.dots ? LegendRow::Sample::dot : LegendRow::Sample::line,
                    std::max(3.0F, marks.width_px), marks.dots});
  }
  if (pins > 0) {
    rows.push_back(
        {fmt::format("held: {}", count_text(pins, "vertex", "vertices")), pin_colour, LegendRow::Sample::dot, 16.0F});
  }
  rows.push_back({"outside", pale_outside, LegendRow::Sample::area});
  rows.push_back({"inside", pale_inside, LegendRow::Sample::area});
  return rows;
}

void draw_legend_rows(renderer::Canvas& canvas, const std::vector<LegendRow>& rows, float top_px) {
  constexpr float sample_px = 60.0F;
  const float column_px = (page_px - 2.0F * border_px) / static_cast<float>(legend_columns);
  const renderer::TextStyle text =
      text_style(0.85F * text_px).with_alignment(renderer::HorizontalAlign::left, renderer::VerticalAlign::middle);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float x_px = border_px + column_px * static_cast<float>(i % legend_columns);
    const float y_px = top_px + row_px * (0.5F + static_cast<float>(i / legend_columns));
    const auto& [meaning, colour, sample, width_px, outlined] = rows[i];
    const float middle_px = x_px + 0.5F * sample_px;
    if (sample == LegendRow::Sample::line) canvas.line(x_px, y_px, x_px + sample_px, y_px, colour, width_px);
    if (outlined) canvas.circle(middle_px, y_px, 0.5F * width_px + mark_outline_px, palette::ink);
    if (sample == LegendRow::Sample::dot) canvas.circle(middle_px, y_px, 0.5F * width_px, colour);
    if (sample == LegendRow::Sample::area) {
      canvas.fill_rectangle(x_px, y_px - 0.45F * text_px, sample_px, 0.9F * text_px, colour);
      canvas.rectangle(x_px, y_px - 0.45F * text_px, sample_px, 0.9F * text_px, palette::hairline);
    }
    canvas.text(x_px + sample_px + 16.0F, y_px, meaning, text);
  }
}

// Returns widths at which springs leave the surface between them visible, and dots leave the springs visible.
MarkWidths mark_widths(const Json& facts, float px_per_m) {
  const float edge_px = facts["edge_length_m"]["mean"].get<float>() * px_per_m;
  return {.spring_px = std::clamp(0.09F * edge_px, 0.4F, 2.0F), .dot_px = std::clamp(0.4F * edge_px, 5.0F, 13.0F)};
}

constexpr float dot_px = 13.0F;
/// Mean edge lengths that the close-up shows on each side of the position.
constexpr double close_up_edge_count = 3.0;

DrawnScene close_up_scene(const DrawnScene& asked, const sim::Simulation& simulation, const sim::Vec3& place_m) {
  DrawnScene scene = asked;
  const glm::vec3 centre(place_m);
  const glm::vec3 around(static_cast<float>(close_up_edge_count * sim::mean_edge_m(simulation.garment().springs)));
  scene.camera.eye.reset();
  scene.camera.target.reset();
  scene.camera.box = renderer::Box{centre - around, centre + around};
  return scene;
}

std::vector<InspectionMarks> make_marks(const sim::Simulation& simulation, const sim::BlockedContact& blocked) {
  InspectionMarks outlines{.meaning = "", .colour = crossing_colour, .width_px = 5.0F, .seen_through = true};
  InspectionMarks dots{
      .meaning = "", .colour = crossing_colour, .width_px = dot_px, .dots = true, .seen_through = true};
  dots.points.emplace_back(blocked.place_m);
  for (const sim::ContactSide& side : blocked.sides) {
    const std::vector<sim::Index>& v = side.vertices;
    for (std::size_t k = 0; k < v.size() && v.size() > 1; ++k) {
      outlines.points.emplace_back(simulation.state().current[v[k]]);
      outlines.points.emplace_back(simulation.state().current[v[(k + 1) % v.size()]]);
    }
  }
  return {outlines, dots};
}

std::vector<std::string> wrap(const renderer::Canvas& canvas, const std::string& text, const renderer::TextStyle& style,
                              float max_width_px) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back() + (lines.back().empty() ? "" : " ") + word;
    if (canvas.measure(longer, style).width_px > max_width_px && !lines.back().empty()) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

constexpr float fit_gap_px = 20.0F;
constexpr float fit_panel_px = 700.0F;
constexpr float fit_panel_height_px = 860.0F;
constexpr float fit_legend_px = 275.0F;
constexpr float fit_header_px = border_px + 3.4F * text_px;
constexpr float fit_page_px = 2.0F * border_px + 2.0F * fit_panel_px + fit_gap_px + fit_legend_px;

/// Views the positions from the front, turned by `turned_rad`.
void look_from_front(const sim::Vec3& front, std::span<const sim::Vec3> positions_m, float turned_rad,
                     DrawnScene& scene) {
  renderer::Framing& framing = scene.camera.framing;
  framing.azimuth_rad = static_cast<float>(std::atan2(front.x, front.z)) + turned_rad;
  framing.elevation_rad = 0.05F;
  framing.vertical_fov_rad = 0.35F;
  scene.camera.eye.reset();
  scene.camera.box = renderer::bounding_box(to_float({positions_m.begin(), positions_m.end()}));
  PictureStyle& style = scene.picture;
  style.settings.width_px = static_cast<int>(fit_panel_px);
  style.settings.height_px = static_cast<int>(fit_panel_height_px);
  style.settings.supersampling = 2;
  style.ground.kind = GroundKind::none;
  style.legend = false;
  style.show_pins = false;
}

renderer::Image draw_side(OffscreenRenderer& offscreen, const WornGarment& worn, float turned_rad) {
  DrawnScene scene = worn.scene;
  look_from_front(front_of_dressed(worn.bodies), worn.positions_m, turned_rad, scene);
  scene.picture.surface = SurfaceLook::stretch;
  return draw_marked(offscreen.renderer(), scene, worn.garment, worn.bodies.all, {}, worn.positions_m, worn.time_s, {},
                     true);
}

void draw_table(renderer::Canvas& canvas, const WornGarment& worn, float top_px) {
  const std::span<const FitRow> rows = worn.fit;
  constexpr std::array columns_px = {0.0F, 420.0F, 640.0F, 860.0F, 930.0F};
  const float end_px = border_px + 1130.0F;
  const auto line = [&](float y_px, const std::array<std::string, 5>& cells, const renderer::TextStyle& look) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      renderer::TextStyle style = look;
      const bool is_number = c > 0 && c < 4;
      style.horizontal = is_number ? renderer::HorizontalAlign::right : renderer::HorizontalAlign::left;
      canvas.text(border_px + columns_px[c], y_px, cells[c], style);
    }
    canvas.line(border_px, y_px + 0.45F * text_px, end_px, y_px + 0.45F * text_px, palette::hairline);
  };
  line(top_px + text_px, {"", "body", "garment", "ease", ""}, text_style(text_px, palette::quiet_ink));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const FitRow& row = rows[r];
    const auto cm = [](double length_m) { return fmt::format("{:.1f} cm", 100.0 * length_m); };
    line(top_px + text_px + static_cast<float>(r + 1) * row_px,
         {row.name, cm(row.body_m), cm(row.garment_m), fmt::format("{:+.1f} cm", 100.0 * row.ease_m()), fit_word(row)},
         text_style(text_px, is_too_small(row) ? palette::vermilion : palette::ink));
  }
  const std::string words = rows.empty() ? "no girth of the garment goes all around the body"
                                         : "ease below 0: too small; " + fit_thresholds();
  canvas.text(border_px, top_px + text_px + static_cast<float>(rows.size() + 1) * row_px, words,
              text_style(0.75F * text_px, palette::quiet_ink));
  canvas.text(border_px, top_px + text_px + static_cast<float>(rows.size() + 2) * row_px, worn.tightness,
              text_style(0.85F * text_px, palette::ink));
}

}  // namespace

std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, std::span<const sim::CrossingPair> crossings,
                                              const MarkWidths& widths) {
  const float spring_width_px = widths.spring_px;
  const sim::Adjacency& adjacency = loaded.garment->adjacency;
  std::vector<InspectionMarks> all;
  // Flexural springs lie under the structural springs that they run along. Their lines are wider, to show on both
  // sides, and pale, to leave the structural springs visible.
  all.push_back(mark_springs(loaded, sim::SpringKind::flexural, 2.4F * spring_width_px));
  all.back().opacity = 0.45F;
  all.push_back(mark_springs(loaded, sim::SpringKind::shear, spring_width_px));
  all.push_back(mark_springs(loaded, sim::SpringKind::structural, spring_width_px));
  all.push_back(
      edges_where(loaded, {.meaning = "edges of a border", .colour = border_colour, .width_px = 3.0F + spring_width_px},
                  [&](std::size_t e) { return adjacency.edge_triangles[e].size() == 1; }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges whose sides disagree about the outside",
                             .colour = misoriented_colour,
                             .width_px = 5.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return sim::is_misoriented(loaded.garment->mesh, adjacency, e); }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges with more than two triangles",
                             .colour = non_manifold_colour,
                             .width_px = 6.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return adjacency.edge_triangles[e].size() > 2; }));
  all.push_back(crossing_triangles(loaded, crossings));
  all.push_back(joined_vertices(loaded, widths.dot_px));
  all.push_back(mark_hanger(loaded));
  std::erase_if(all, [](const InspectionMarks& marks) { return marks.points.empty(); });
  return all;
}

renderer::Image draw_inspection(const Inspection& inspection, const LoadedGarment& loaded, const DrawnScene& scene,
                                std::span<const sim::Body> bodies, const std::string& backend) {
  OffscreenRenderer offscreen(backend);
  InspectionViews views = inspection_views(scene, *loaded.garment, bodies, loaded.pins);
  const MarkWidths widths = mark_widths(inspection.facts, views.px_per_m);
  std::array<LoadedGarment, 2> shown = {loaded, loaded};
  if (loaded.following) {
    shown[0] = as_modelled(loaded, scene.mapping);
    views.sides[1] = {"the fitted mesh that is simulated", views.sides[0].scene};
    views.sides[0].name = "the model, which follows";
  }
  const std::vector<InspectionMarks> all = inspection_marks(shown[0], inspection.crossings, widths);
  const std::vector<InspectionMarks> simulated = loaded.following ? inspection_marks(loaded, {}, widths) : all;
  const std::vector<LegendRow> legend = make_legend(all, loaded.pins.size());
  const float caption_px = 1.6F * row_px;
  const float below_px = header_px + static_cast<float>(views.height_px);
  const float legend_top_px = below_px + caption_px;
  const auto legend_rows = static_cast<float>((legend.size() + legend_columns - 1) / legend_columns);
  renderer::Canvas canvas(static_cast<int>(page_px),
                          static_cast<int>(legend_top_px + legend_rows * row_px + border_px));
  draw_header(canvas, inspection.facts);
  const renderer::TextStyle caption = text_style(text_px).with_alignment(renderer::HorizontalAlign::centre);
  for (std::size_t k = 0; k < views.sides.size(); ++k) {
    const float x_px = border_px + static_cast<float>(k) * (panel_px + gap_px);
    const sim::Garment& garment = *shown[k].garment;
    canvas.image(x_px, header_px,
                 draw_marked(offscreen.renderer(), views.sides[k].scene, garment, {}, shown[k].pins,
                             garment.mesh.positions, 0.0, k == 0 ? all : simulated, true));
    canvas.text(x_px + 0.5F * panel_px, below_px + row_px, views.sides[k].name, caption);
  }
  draw_bar(canvas, border_px + 12.0F, below_px + row_px, views.px_per_m);
  draw_legend_rows(canvas, legend, legend_top_px);
  return canvas.to_image();
}

renderer::Image draw_blocked(renderer::SceneRenderer& renderer, const DrawnScene& scene,
                             const sim::Simulation& simulation, const sim::BlockedContact& blocked,
                             const std::string& text) {
  const std::vector<InspectionMarks> marks = make_marks(simulation, blocked);
  const auto draw = [&](DrawnScene seen) {
    seen.picture.smooth = false;
    return draw_marked(renderer, seen, simulation.garment(), simulation.surroundings().bodies,
                       simulation.pins().vertices, simulation.state().current, simulation.state().time_s, marks, false);
  };
  const auto width_px = static_cast<float>(scene.picture.settings.width_px);
  const renderer::TextStyle style = text_style(0.02F * width_px);
  const float edge_px = style.size_px;
  const float line_px = 1.5F * style.size_px;
  const std::vector<std::string> lines = wrap(renderer::Canvas(1, 1), text, style, 2.0F * (width_px - edge_px));
  const float head_px = static_cast<float>(lines.size()) * line_px + edge_px;
  renderer::Canvas canvas(2 * scene.picture.settings.width_px,
                          static_cast<int>(head_px) + scene.picture.settings.height_px);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    canvas.text(edge_px, line_px * static_cast<float>(k + 1), lines[k], style);
  }
  canvas.image(0.0F, head_px, draw(scene));
  canvas.image(width_px, head_px, draw(close_up_scene(scene, simulation, blocked.place_m)));
  return canvas.to_image();
}

renderer::Image draw_moments(const DrawnScene& scene, const LoadedBodies& bodies,
                             std::span<const GarmentMoment> moments, const std::string& backend) {
  OffscreenRenderer offscreen(backend);
  const float height_px = fit_panel_height_px + 1.6F * row_px;
  const auto count = static_cast<float>(moments.size());
  renderer::Canvas canvas(static_cast<int>(count * (fit_panel_px + fit_gap_px) - fit_gap_px),
                          static_cast<int>(height_px));
  const renderer::TextStyle caption = text_style(1.3F * text_px).with_alignment(renderer::HorizontalAlign::centre);
  float x_px = 0.0F;
  std::vector<sim::Vec3> about_body_m;
  for (const GarmentMoment& moment : moments) {
    if (moment.time_s) about_body_m.insert(about_body_m.end(), moment.positions_m.begin(), moment.positions_m.end());
  }
  for (const GarmentMoment& moment : moments) {
    DrawnScene shown = scene;
    look_from_front(moment.time_s ? front_of_dressed(bodies) : sim::Vec3(0.0, 0.0, 1.0),
                    moment.time_s ? about_body_m : moment.positions_m, 0.0F, shown);
    canvas.image(
        x_px, 0.0F,
        draw_marked(offscreen.renderer(), shown, moment.garment, moment.time_s ? bodies.all : std::vector<sim::Body>{},
                    {}, moment.positions_m, moment.time_s.value_or(0.0), {}, true));
    canvas.text(x_px + 0.5F * fit_panel_px, fit_panel_height_px + row_px, moment.name, caption);
    x_px += fit_panel_px + fit_gap_px;
  }
  return canvas.to_image();
}

renderer::Image draw_fit(const WornGarment& worn, const std::string& backend) {
  OffscreenRenderer offscreen(backend);
  const float caption_px = 1.6F * row_px;
  const renderer::TextStyle small = text_style(0.85F * text_px, palette::quiet_ink);
  const std::vector<std::string> measured =
      wrap(renderer::Canvas(1, 1), worn.measured, small, fit_page_px - 2.0F * border_px);
  const float panels_px = fit_header_px + static_cast<float>(measured.size() - 1) * row_px;
  const float table_px = panels_px + fit_panel_height_px + caption_px;
  // A body that is still thin, before dressing ends, does not show how the cloth around it fits.
  const bool has_table = worn.time_s >= 0.0 && !worn.fit.empty();
  const float rows = has_table ? static_cast<float>(worn.fit.size() + 3) : 0.0F;
  renderer::Canvas canvas(static_cast<int>(fit_page_px), static_cast<int>(table_px + rows * row_px + border_px));
  canvas.text(border_px, border_px + text_px, worn.title, text_style(1.4F * text_px, palette::ink, true));
  for (std::size_t k = 0; k < measured.size(); ++k) {
    canvas.text(border_px, border_px + text_px + static_cast<float>(k + 1) * row_px, measured[k], small);
  }
  const renderer::TextStyle caption = text_style(text_px).with_alignment(renderer::HorizontalAlign::centre);
  float x_px = border_px;
  for (const auto& [name, turned_rad] :
       {std::pair("from the front", 0.0F), {"from behind", std::numbers::pi_v<float>}}) {
    canvas.image(x_px, panels_px, draw_side(offscreen, worn, turned_rad));
    canvas.text(x_px + 0.5F * fit_panel_px, panels_px + fit_panel_height_px + row_px, name, caption);
    x_px += fit_panel_px + fit_gap_px;
  }
  renderer::LegendPlace place{.x_px = x_px + fit_gap_px,
                              .y_px = panels_px + 80.0F,
                              .bar_width_px = 24.0F,
                              .bar_height_px = 420.0F,
                              .text = text_style(0.85F * text_px)};
  renderer::draw_legend(canvas, stretch_legend(worn.scene), place);
  if (has_table) draw_table(canvas, worn, table_px);
  return canvas.to_image();
}

}  // namespace taut::app
