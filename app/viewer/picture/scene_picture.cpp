#include "app/viewer/picture/scene_picture.hpp"

#include <glm/geometric.hpp>
#include <utility>

#include "app/scene/promise.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

constexpr renderer::Colour normal_colour = renderer::rgb(0x2E7D32);
// Length of lines that show normals, as a fraction of the diagonal of the garment at rest.
constexpr float normal_length = 0.012F;

}  // namespace

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

GarmentPainter& ScenePicture::painter_for(const GarmentSight& sight) {
  const ViewerState& state = sight.state;
  const ViewArea& area = sight.area;
  const Snapshot& shown = sight.garment;
  const PictureStyle& picture = state.scene.picture;
  PaintedAs wanted{shown.loaded,
                   shown.pins,
                   picture.surface,
                   picture.stretch_of,
                   shown_stretch_range(state.scene),
                   state.scene.fabric,
                   picture.wireframe,
                   picture.springs,
                   area.height_px};
  if (!painter_ || wanted != painted_as_) {
    DrawnScene scene = state.scene;
    scene.picture.settings.width_px = area.width_px;
    scene.picture.settings.height_px = area.height_px;
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
  const Snapshot& shown = sight.garment;
  const PictureStyle& picture = state.scene.picture;
  return {shown.loaded,
          shown.pins,
          shown.checkpoint,
          state.camera,
          picture.surface,
          picture.stretch_of,
          shown_stretch_range(state.scene),
          state.scene.fabric,
          picture.wireframe,
          picture.settings.shadows,
          picture.springs,
          state.show_normals,
          hand_thread(state, shown, sight.area),
          sight.area.width_px,
          sight.area.height_px,
          sight.left_px};
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
  if (state.show_normals) {
    add_normals(sight.garment, frame);
  }
  thread_ = hand_thread(state, sight.garment, area);
  if (thread_) {
    add_thread(*thread_, frame);
  }
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
