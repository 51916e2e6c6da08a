#include "app/viewer/picture/viewer_picture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/scene/promise.hpp"
#include "renderer/gl/colour_target.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

// A smaller target is a window being closed, and nothing is drawn.
constexpr int smallest_side_px = 8;
constexpr renderer::Colour normal_colour = renderer::rgb(0x2E7D32);
// Length of lines that show normals, as a fraction of the diagonal of the garment at rest.
constexpr float normal_length = 0.012F;

bool has_room(const ViewArea& area) {
  return area.width_px >= smallest_side_px && area.height_px >= smallest_side_px;
}

}  // namespace

ViewerPicture::ViewerPicture(renderer::Context& context)
    : context_(context), scene_renderer_(context), interface_(context) {}

GarmentPainter& ViewerPicture::painter_for(const ViewerState& state, const ViewArea& area) {
  const Snapshot& shown = *state.shown;
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
    painter_.emplace(scene_renderer_, scene, *shown.loaded->garment, *shown.pins,
                     shown.loaded->drawn_colours);
    painted_as_ = std::move(wanted);
  }
  return *painter_;
}

void ViewerPicture::add_normals(const ViewerState& state, renderer::FrameView& frame) {
  const renderer::SurfaceView surface = renderer::coarse_of(frame.surfaces.back());
  const sim::Vec3 size_m = sim::extent_of(state.shown->loaded->garment->mesh.positions).size();
  const float length_m = normal_length * static_cast<float>(glm::length(size_m));
  normal_points_.clear();
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    normal_points_.push_back(surface.positions[v]);
    normal_points_.push_back(surface.positions[v] + length_m * surface.normals[v]);
  }
  frame.lines.push_back(
      {.points = normal_points_, .colours = std::span(&normal_colour, 1), .width_px = 1.0F});
}

ViewerPicture::SceneLook ViewerPicture::look_of(const ViewerState& state, const ViewArea& area) const {
  const Snapshot& shown = *state.shown;
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
          hand_thread(state, area),
          area.width_px,
          area.height_px};
}

bool ViewerPicture::is_scene_drawn(const SceneLook& look, std::size_t level) const {
  return drawn_level_ <= level && look == drawn_look_;
}

bool ViewerPicture::is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                             const renderer::OverlayView& overlay) const {
  const ViewArea area = scene_area(layout);
  return (!has_room(area) || is_scene_drawn(look_of(state, area), level)) && interface_.is_drawn(overlay);
}

// A scene that stands still is drawn once more to be kept; one that moves would be kept for nothing.
void ViewerPicture::draw_scene(unsigned framebuffer, const ViewerState& state, const ViewArea& area,
                               const PictureQuality& quality, bool keep) {
  GarmentPainter& painter = painter_for(state, area);
  painter.look_from(state.camera.camera(), quality.shortest_edge_px);
  renderer::FrameView frame = painter.view(state.shown->positions(), state.shown->checkpoint->state.time_s);
  frame.backdrop.transparent = false;
  if (state.show_normals) {
    add_normals(state, frame);
  }
  thread_ = hand_thread(state, area);
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
    scene_renderer_.draw_kept(frame, settings);
    scene_renderer_.show_kept(framebuffer, area.width_px, area.height_px);
    is_kept_ = true;
  } else {
    is_kept_ = scene_renderer_.draw_to(framebuffer, frame, settings);
  }
}

// Kept, so that `draw` can show it without the legends, which it lays over itself.
renderer::Image ViewerPicture::picture(unsigned framebuffer, const ViewerState& state,
                                       const WindowLayout& layout, std::size_t level,
                                       const UserInterface::Letters& letters,
                                       const renderer::OverlayView& legends) {
  context_.make_current();
  const ViewArea area = scene_area(layout);
  if (has_room(area)) {
    drawn_look_.reset();
    draw_scene(framebuffer, state, area, picture_qualities[level], true);
    drawn_look_ = look_of(state, area);
    drawn_level_ = level;
    has_picture_ = true;
    interface_.draw_over(framebuffer, layout, letters, legends);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  }
  return renderer::read_framebuffer(context_, framebuffer, area.width_px, area.height_px);
}

void ViewerPicture::draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                         std::size_t level, const UserInterface::Letters& letters,
                         const renderer::OverlayView& overlay, bool is_urgent) {
  context_.make_current();
  const ViewArea area = scene_area(layout);
  SceneLook look = look_of(state, area);
  const bool is_same = is_scene_drawn(look, level);
  drew_scene_ = has_room(area) && !(is_same && is_kept_);
  if (drew_scene_) {
    drawn_look_.reset();
    draw_scene(framebuffer, state, area, picture_qualities[level], is_same);
    drawn_look_ = std::move(look);
    drawn_level_ = level;
  } else if (has_room(area)) {
    scene_renderer_.show_kept(framebuffer, area.width_px, area.height_px);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  }
  drew_scene_ = std::exchange(has_picture_, false) || drew_scene_;
  interface_.draw(framebuffer, layout, letters, overlay, is_urgent);
}

}  // namespace taut::app
