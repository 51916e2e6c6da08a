#include "app/viewer/picture/viewer_picture.hpp"

namespace taut::app {
namespace {

// Distance up to which the cloth counts as in the hand; the hand's spring makes it follow late. A smaller value shows
// short threads whenever the hand moves.
constexpr float min_shift_m = 0.005F;
// Distance in the picture up to which the cloth counts as in the hand. A smaller value shows a dot on distant cloth.
constexpr float min_shift_px = 4.0F;

// A dark line with a light rim shows on cloth and floor of any colour.
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

/// Adds the thread in front of everything, faint where surfaces hide it. `thread` must outlive `frame`.
void add_thread(const HandThread& thread, renderer::FrameView& frame) {
  for (const bool hidden : {false, true}) {
    renderer::LineView line{.points = thread,
                            .colour = rim_colour,
                            .width_px = rim_width_px,
                            .opacity = hidden ? 1.0F : opacity_behind_surfaces,
                            .hidden_by_surfaces = hidden};
    frame.lines.push_back(line);
    line.colour = core_colour;
    line.width_px = core_width_px;
    frame.lines.push_back(line);
  }
  renderer::PointView ends{
      .centres = thread, .colour = rim_colour, .diameter_px = rim_diameter_px, .hidden_by_surfaces = false};
  frame.points.push_back(ends);
  ends.colour = core_colour;
  ends.diameter_px = core_diameter_px;
  frame.points.push_back(ends);
}

std::uint64_t hash_overlay(const renderer::OverlayView& overlay) {
  std::uint64_t hash = 0;
  const auto add = [&hash](const auto& values) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<std::string_view>{}(bytes);
  };
  add(overlay.vertices);
  add(overlay.indices);
  for (const renderer::OverlayPart& part : overlay.parts) add(std::array{part.clip_lower_px, part.clip_upper_px});
  return hash;
}

// Returns true if a part of the overlay is beside the scene. Lists that open over the panel are clipped only to the
// whole window, so the position of their vertices decides.
bool is_beside(const renderer::OverlayView& overlay, const renderer::OverlayPart& part, int scene_width_px) {
  if (part.clip_lower_px.x >= scene_width_px) return true;
  const auto indices = overlay.indices.subspan(part.first_index, part.index_count);
  return std::ranges::all_of(indices, [&](std::uint16_t index) {
    return overlay.vertices[part.first_vertex + index].position_px.x >= static_cast<float>(scene_width_px);
  });
}

// Returns the parts of the overlay that are beside the scene, or those over it.
renderer::OverlayView scale_overlay(const renderer::OverlayView& overlay, int scene_width_px, bool beside) {
  renderer::OverlayView part = overlay;
  std::erase_if(part.parts,
                [&](const renderer::OverlayPart& each) { return is_beside(overlay, each, scene_width_px) != beside; });
  return part;
}

// Minimum width and height to draw to. A smaller target is a window that is being closed.
constexpr int min_side_px = 8;

bool has_room(const ViewArea& area) { return area.width_px >= min_side_px && area.height_px >= min_side_px; }

GarmentSight first_sight(const WindowView& window) {
  return {window.state, *window.state.shown, garment_area(window.state, window.layout)};
}

// Returns the view of the second garment, in the right half.
std::optional<GarmentSight> second_sight(const WindowView& window) {
  const Snapshot* garment = compared_garment(window.state);
  if (garment == nullptr) return std::nullopt;
  const ViewArea whole = scene_area(window.layout);
  const int left_px = garment_area(window.state, window.layout).width_px;
  return GarmentSight{window.state, *garment, {whole.width_px - left_px, whole.height_px}, left_px};
}

}  // namespace

std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment, const ViewArea& area) {
  if (!state.held) return std::nullopt;
  const std::vector<glm::vec3> ends = to_float(std::array{garment.positions()[state.held->vertex], state.held->hand_m});
  const auto from_px = state.camera.project_to_pixel(ends[0], area);
  const auto to_px = state.camera.project_to_pixel(ends[1], area);
  const bool is_apart = glm::distance(ends[0], ends[1]) > min_shift_m &&
                        (!from_px || !to_px || glm::distance(*from_px, *to_px) > min_shift_px);
  return is_apart ? std::optional(HandThread{ends[0], ends[1]}) : std::nullopt;
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
  return {sight.garment.loaded, sight.garment.pins, picture.surface,     picture.stretch_of, shown_stretch_range(scene),
          scene.fabric,         picture.wireframe,  scene.camera.follow, picture.springs,    sight.area.height_px};
}

GarmentPainter& ScenePicture::painter_for(const GarmentSight& sight) {
  const Snapshot& shown = sight.garment;
  PaintedAs wanted = painted_as(sight);
  if (!painter_ || wanted != painted_as_) {
    DrawnScene scene = sight.state.scene;
    scene.picture.settings.width_px = sight.area.width_px;
    scene.picture.settings.height_px = sight.area.height_px;
    painter_.emplace(renderer_, scene, *shown.loaded->garment, shown.loaded->bodies.all, *shown.pins,
                     shown.loaded->drawn_colours);
    painted_as_ = std::move(wanted);
  }
  return *painter_;
}

void ScenePicture::add_normals(const Snapshot& garment, renderer::FrameView& frame) {
  const renderer::SurfaceView surface = renderer::coarse_surface(frame.surfaces.back());
  const sim::Vec3 size_m = sim::compute_extent(garment.loaded->garment->mesh.positions).size();
  const float length_m = normal_length * static_cast<float>(glm::length(size_m));
  normal_points_.clear();
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    normal_points_.push_back(surface.positions[v]);
    normal_points_.push_back(surface.positions[v] + length_m * surface.normals[v]);
  }
  frame.lines.push_back({.points = normal_points_, .colour = normal_colour, .width_px = 1.0F});
}

ScenePicture::SceneLook ScenePicture::look_of(const GarmentSight& sight) {
  const ViewerState& state = sight.state;
  return {painted_as(sight),   sight.garment.checkpoint,
          state.camera,        state.scene.picture.settings.shadows,
          state.show_normals,  hand_thread(state, sight.garment, sight.area),
          sight.area.width_px, sight.left_px};
}

// Draws the picture. It is kept only once the scene stands still, because a moving scene would not use it again.
void ScenePicture::draw_anew(unsigned framebuffer, const GarmentSight& sight, const PictureQuality& quality,
                             bool keep) {
  const ViewerState& state = sight.state;
  const ViewArea& area = sight.area;
  GarmentPainter& painter = painter_for(sight);
  // The painter follows its garment itself, as it does for a saved scene.
  painter.look_from(camera_at_rest(state, sight.garment), quality.min_edge_px);
  renderer::FrameView frame = painter.view(sight.garment.positions(), sight.garment.checkpoint->state.time_s);
  frame.backdrop.transparent = false;
  if (state.show_normals) add_normals(sight.garment, frame);
  thread_ = hand_thread(state, sight.garment, area);
  if (thread_) add_thread(*thread_, frame);
  renderer::PictureSettings settings = state.scene.picture.settings;
  quality.apply(settings);
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

InterfacePicture::InterfacePicture(renderer::Context& context)
    : context_(context), pass_(context), panel_target_(context) {}

bool InterfacePicture::is_drawn(const renderer::OverlayView& overlay) const { return hash_overlay(overlay) == drawn_; }

void InterfacePicture::draw_panel(const WindowLayout& layout, const renderer::OverlayView& panel) {
  const unsigned framebuffer = panel_target_.framebuffer(layout.width_px, layout.height_px);
  renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  pass_.draw(framebuffer, layout.width_px, layout.height_px, panel);
  panel_size_ = {layout.width_px, layout.height_px};
  since_panel_ = Stopwatch();
}

// Takes over the image of the letters. Returns false if it has not changed.
bool InterfacePicture::take_letters(const UserInterface::Letters& letters) {
  if (letters.number == letters_number_) return false;
  pass_.set_sheet(letters.width_px, letters.height_px, letters.rgba);
  letters_number_ = letters.number;
  return true;
}

void InterfacePicture::draw_legends(unsigned framebuffer, const WindowView& window) {
  if (take_letters(window.interface.letters())) {
    panel_size_ = {};  // the kept panel shows the old letters
  }
  pass_.draw(framebuffer, window.layout.width_px, window.layout.height_px, window.interface.picture_overlay());
}

void InterfacePicture::draw(unsigned framebuffer, const WindowView& window, bool is_urgent) {
  const WindowLayout& layout = window.layout;
  const renderer::OverlayView& overlay = window.interface.overlay();
  const bool has_new_letters = take_letters(window.interface.letters());
  const int scene_width_px = scene_area(layout).width_px;
  const std::uint64_t look = hash_overlay(overlay);
  if (scene_width_px < layout.width_px) {
    const bool fits = panel_size_ == renderer::Resized{layout.width_px, layout.height_px};
    const bool is_old = since_panel_.elapsed_ms() >= 1000.0 * max_interval_s;
    if (!fits || has_new_letters || (look != panel_look_ && (is_urgent || is_old))) {
      draw_panel(layout, scale_overlay(overlay, scene_width_px, true));
      panel_look_ = look;
    }
    panel_target_.copy_part_to(framebuffer, scene_width_px, 0, layout.width_px - scene_width_px, layout.height_px);
  } else {
    panel_look_ = look;
  }
  pass_.draw(framebuffer, layout.width_px, layout.height_px, scale_overlay(overlay, scene_width_px, false));
  drawn_ = panel_look_;
}

ViewerPicture::ViewerPicture(renderer::Context& context) : context_(context), first_(context), interface_(context) {}

bool ViewerPicture::is_drawn(const WindowView& window, std::size_t level) const {
  if (!interface_.is_drawn(window.interface.overlay())) return false;
  const std::optional<GarmentSight> second = second_sight(window);
  return !has_room(scene_area(window.layout)) ||
         (first_.is_drawn(first_sight(window), level) && (!second || (second_ && second_->is_drawn(*second, level))));
}

bool ViewerPicture::draw_scenes(unsigned framebuffer, const WindowView& window, std::size_t level, bool anew) {
  const bool drew_first = first_.draw(framebuffer, first_sight(window), level, anew);
  const std::optional<GarmentSight> second = second_sight(window);
  if (!second) {
    second_.reset();
    return drew_first;
  }
  if (!second_) second_.emplace(context_);
  return second_->draw(framebuffer, *second, level, anew) || drew_first;
}

// Draws the scene so that the renderer keeps it: `draw` then shows it again, without these legends.
renderer::Image ViewerPicture::picture(unsigned framebuffer, const WindowView& window, std::size_t level) {
  context_.make_current();
  const ViewArea area = scene_area(window.layout);
  if (has_room(area)) {
    draw_scenes(framebuffer, window, level, true);
    has_picture_ = true;
    interface_.draw_legends(framebuffer, window);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, window.layout.width_px, window.layout.height_px,
                                behind_panel_grey);
  }
  return renderer::read_framebuffer(context_, framebuffer, area.width_px, area.height_px);
}

void ViewerPicture::draw(unsigned framebuffer, const WindowView& window, std::size_t level, bool is_urgent) {
  context_.make_current();
  drew_scene_ = false;
  if (has_room(scene_area(window.layout))) {
    drew_scene_ = draw_scenes(framebuffer, window, level, false);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, window.layout.width_px, window.layout.height_px,
                                behind_panel_grey);
  }
  drew_scene_ = std::exchange(has_picture_, false) || drew_scene_;
  interface_.draw(framebuffer, window, is_urgent);
}

}  // namespace taut::app
