#include "app/viewer/picture/scene_picture.hpp"

#include "app/drawing/framing.hpp"
#include "app/scene/scene.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

// Cloth hangs from the hand by a spring, and follows it late: less than this apart it is in the hand. Smaller
// shows threads of millimetres whenever the hand moves.
constexpr float least_m = 0.005F;
// The same in the picture. Smaller shows a dot on cloth that is far away.
constexpr float least_px = 4.0F;

// Dark with a light rim shows on cloth and ground of any colour.
constexpr renderer::Colour rim_colour = renderer::rgb(0xFFFFFF);
constexpr renderer::Colour core_colour = renderer::rgb(0x1C1C1C);
constexpr float rim_width_px = 4.5F;
constexpr float core_width_px = 2.0F;
constexpr float rim_diameter_px = 11.0F;
constexpr float core_diameter_px = 7.5F;
constexpr float opacity_behind_surfaces = 0.35F;

constexpr renderer::Colour normal_colour = renderer::rgb(0x2E7D32);
// Length of lines that show normals, as a fraction of the diagonal of the garment at rest.
constexpr float normal_length = 0.012F;

}  // namespace

std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment,
                                      const ViewArea& area) {
  if (!state.held) return std::nullopt;
  const std::vector<glm::vec3> ends = to_float({garment.positions()[state.held->vertex], state.held->hand_m});
  const auto from_px = state.camera.pixel_of(ends[0], area);
  const auto to_px = state.camera.pixel_of(ends[1], area);
  const bool is_apart = glm::distance(ends[0], ends[1]) > least_m &&
                        (!from_px || !to_px || glm::distance(*from_px, *to_px) > least_px);
  return is_apart ? std::optional(HandThread{ends[0], ends[1]}) : std::nullopt;
}

void add_thread(const HandThread& thread, renderer::FrameView& frame) {
  for (const bool hidden : {false, true}) {
    renderer::LineView line{.points = thread,
                            .colours = std::span(&rim_colour, 1),
                            .width_px = rim_width_px,
                            .opacity = hidden ? 1.0F : opacity_behind_surfaces,
                            .hidden_by_surfaces = hidden};
    frame.lines.push_back(line);
    line.colours = std::span(&core_colour, 1);
    line.width_px = core_width_px;
    frame.lines.push_back(line);
  }
  renderer::PointView ends{.centres = thread,
                           .colours = std::span(&rim_colour, 1),
                           .diameter_px = rim_diameter_px,
                           .hidden_by_surfaces = false};
  frame.points.push_back(ends);
  ends.colours = std::span(&core_colour, 1);
  ends.diameter_px = core_diameter_px;
  frame.points.push_back(ends);
}

bool ScenePicture::draw(unsigned framebuffer, const GarmentSight& sight, std::size_t level, bool anew) {
  SceneLook look = look_of(sight);
  const bool is_same = is_drawn(look, level);
  if (is_same && is_kept_ && !anew) {
    renderer_.show_kept(framebuffer, sight.area.width_px, sight.area.height_px, sight.left_px);
    return false;
  }
  drawn_look_.reset();
  draw_anew(framebuffer, sight, picture_qualities[level], anew || is_same || sight.left_px > 0);
  drawn_look_ = std::move(look);
  drawn_level_ = level;
  return true;
}

ScenePicture::PaintedAs ScenePicture::painted_as(const GarmentSight& sight) {
  const DrawnScene& scene = sight.state.scene;
  const PictureStyle& picture = scene.picture;
  return {sight.garment.loaded,       sight.garment.pins, picture.surface,   picture.stretch_of,
          shown_stretch_range(scene), scene.fabric,       picture.wireframe, picture.springs,
          sight.area.height_px};
}

GarmentPainter& ScenePicture::painter_for(const GarmentSight& sight) {
  const Snapshot& shown = sight.garment;
  PaintedAs wanted = painted_as(sight);
  if (!painter_ || wanted != painted_as_) {
    DrawnScene scene = sight.state.scene;
    scene.picture.settings.width_px = sight.area.width_px;
    scene.picture.settings.height_px = sight.area.height_px;
    painter_.emplace(renderer_, scene, *shown.loaded->garment, *shown.pins, shown.loaded->drawn_colours);
    painted_as_ = std::move(wanted);
  }
  return *painter_;
}

void ScenePicture::add_normals(const Snapshot& garment, renderer::FrameView& frame) {
  const renderer::SurfaceView surface = renderer::coarse_of(frame.surfaces.back());
  const sim::Vec3 size_m = sim::extent_of(garment.loaded->garment->mesh.positions).size();
  const float length_m = normal_length * static_cast<float>(glm::length(size_m));
  normal_points_.clear();
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    normal_points_.push_back(surface.positions[v]);
    normal_points_.push_back(surface.positions[v] + length_m * surface.normals[v]);
  }
  frame.lines.push_back(
      {.points = normal_points_, .colours = std::span(&normal_colour, 1), .width_px = 1.0F});
}

ScenePicture::SceneLook ScenePicture::look_of(const GarmentSight& sight) {
  const ViewerState& state = sight.state;
  return {painted_as(sight),   sight.garment.checkpoint,
          state.camera,        state.scene.picture.settings.shadows,
          state.show_normals,  hand_thread(state, sight.garment, sight.area),
          sight.area.width_px, sight.left_px};
}

// A scene that stands still is drawn once more to be kept; one that moves would be kept for nothing.
void ScenePicture::draw_anew(unsigned framebuffer, const GarmentSight& sight, const PictureQuality& quality,
                             bool keep) {
  const ViewerState& state = sight.state;
  const ViewArea& area = sight.area;
  GarmentPainter& painter = painter_for(sight);
  painter.look_from(state.camera.camera(), quality.shortest_edge_px);
  renderer::FrameView frame = painter.view(sight.garment.positions(), sight.garment.checkpoint->state.time_s);
  frame.backdrop.transparent = false;
  if (state.show_normals) add_normals(sight.garment, frame);
  thread_ = hand_thread(state, sight.garment, area);
  if (thread_) add_thread(*thread_, frame);
  renderer::PictureSettings settings = state.scene.picture.settings;
  settings.samples = quality.samples;
  settings.supersampling = 1;
  settings.shadow_map_px = quality.shadow_map_px;
  settings.shading_px = quality.shading_px;
  settings.shadow_taps = quality.shadow_taps;
  settings.sky_directions = quality.sky_directions;
  settings.width_px = area.width_px;
  settings.height_px = area.height_px;
  if (keep) {
    renderer_.draw_kept(frame, settings);
    renderer_.show_kept(framebuffer, area.width_px, area.height_px, sight.left_px);
    is_kept_ = true;
  } else {
    is_kept_ = renderer_.draw_to(framebuffer, frame, settings);
  }
}

}  // namespace taut::app
