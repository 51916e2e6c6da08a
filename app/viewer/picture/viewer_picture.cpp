#include "app/viewer/picture/viewer_picture.hpp"

namespace taut::app {
namespace {

std::uint64_t hash_of(const renderer::OverlayView& overlay) {
  std::uint64_t hash = 0;
  const auto add = [&hash](const auto& values) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<std::string_view>{}(bytes);
  };
  add(overlay.vertices);
  add(overlay.indices);
  for (const renderer::OverlayPart& part : overlay.parts) {
    add(std::array{part.clip_lower_px, part.clip_upper_px});
  }
  return hash;
}

// The frames of lists that open over the panel are clipped to the whole window only: where they are is where
// their vertices are.
bool is_beside(const renderer::OverlayView& overlay, const renderer::OverlayPart& part, int scene_width_px) {
  if (part.clip_lower_px.x >= scene_width_px) return true;
  const auto indices = overlay.indices.subspan(part.first_index, part.index_count);
  return std::ranges::all_of(indices, [&](std::uint16_t index) {
    return overlay.vertices[part.first_vertex + index].position_px.x >= static_cast<float>(scene_width_px);
  });
}

// Panels beside the scene, or over it.
renderer::OverlayView parts_of(const renderer::OverlayView& overlay, int scene_width_px, bool beside) {
  renderer::OverlayView part = overlay;
  std::erase_if(part.parts,
                [&](const renderer::OverlayPart& each) { return is_beside(overlay, each, scene_width_px) != beside; });
  return part;
}

// A smaller target is a window being closed, and nothing is drawn.
constexpr int smallest_side_px = 8;

bool has_room(const ViewArea& area) { return area.width_px >= smallest_side_px && area.height_px >= smallest_side_px; }

GarmentSight first_sight(const ViewerState& state, const WindowLayout& layout) {
  return {state, *state.shown, garment_area(state, layout)};
}

// The view of the compared garment, in the right half.
std::optional<GarmentSight> second_sight(const ViewerState& state, const WindowLayout& layout) {
  const Snapshot* garment = compared(state);
  if (garment == nullptr) return std::nullopt;
  const ViewArea whole = scene_area(layout);
  const int left_px = garment_area(state, layout).width_px;
  return GarmentSight{state, *garment, {whole.width_px - left_px, whole.height_px}, left_px};
}

}  // namespace

InterfacePicture::InterfacePicture(renderer::Context& context)
    : context_(context), pass_(context), panel_target_(context) {}

bool InterfacePicture::is_drawn(const renderer::OverlayView& overlay) const { return hash_of(overlay) == drawn_; }

void InterfacePicture::draw_panel(const WindowLayout& layout, const renderer::OverlayView& panel) {
  const unsigned framebuffer = panel_target_.framebuffer(layout.width_px, layout.height_px);
  renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  pass_.draw(framebuffer, layout.width_px, layout.height_px, panel);
  panel_size_ = {layout.width_px, layout.height_px};
  since_panel_ = Stopwatch();
}

// Whether they are others than before.
bool InterfacePicture::take_letters(const UserInterface::Letters& letters) {
  if (letters.number == letters_number_) return false;
  pass_.set_coverage(letters.width_px, letters.height_px, letters.coverage);
  letters_number_ = letters.number;
  return true;
}

void InterfacePicture::draw_over(unsigned framebuffer, const WindowLayout& layout,
                                 const UserInterface::Letters& letters, const renderer::OverlayView& overlay) {
  if (take_letters(letters)) {
    panel_size_ = {};  // the panel has the old ones
  }
  pass_.draw(framebuffer, layout.width_px, layout.height_px, overlay);
}

void InterfacePicture::draw(unsigned framebuffer, const WindowLayout& layout, const UserInterface::Letters& letters,
                            const renderer::OverlayView& overlay, bool is_urgent) {
  const bool has_new_letters = take_letters(letters);
  const int scene_width_px = scene_area(layout).width_px;
  const std::uint64_t look = hash_of(overlay);
  if (scene_width_px < layout.width_px) {
    const bool fits = panel_size_ == renderer::Resized{layout.width_px, layout.height_px};
    const bool is_old = since_panel_.elapsed_ms() >= 1000.0 * longest_s;
    if (!fits || has_new_letters || (look != panel_look_ && (is_urgent || is_old))) {
      draw_panel(layout, parts_of(overlay, scene_width_px, true));
      panel_look_ = look;
    }
    panel_target_.copy_part_to(framebuffer, scene_width_px, 0, layout.width_px - scene_width_px, layout.height_px);
  } else {
    panel_look_ = look;
  }
  pass_.draw(framebuffer, layout.width_px, layout.height_px, parts_of(overlay, scene_width_px, false));
  drawn_ = panel_look_;
}

ViewerPicture::ViewerPicture(renderer::Context& context) : context_(context), first_(context), interface_(context) {}

bool ViewerPicture::is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                             const renderer::OverlayView& overlay) const {
  if (!interface_.is_drawn(overlay)) return false;
  const std::optional<GarmentSight> second = second_sight(state, layout);
  return !has_room(scene_area(layout)) || (first_.is_drawn(first_sight(state, layout), level) &&
                                           (!second || (second_ && second_->is_drawn(*second, level))));
}

bool ViewerPicture::draw_scenes(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                                std::size_t level, bool anew) {
  const bool drew_first = first_.draw(framebuffer, first_sight(state, layout), level, anew);
  const std::optional<GarmentSight> second = second_sight(state, layout);
  if (!second) {
    second_.reset();
    return drew_first;
  }
  if (!second_) second_.emplace(context_);
  return second_->draw(framebuffer, *second, level, anew) || drew_first;
}

// Kept, so that `draw` can show it without the legends, which it lays over itself.
renderer::Image ViewerPicture::picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                                       std::size_t level, const UserInterface::Letters& letters,
                                       const renderer::OverlayView& legends) {
  context_.make_current();
  const ViewArea area = scene_area(layout);
  if (has_room(area)) {
    draw_scenes(framebuffer, state, layout, level, true);
    has_picture_ = true;
    interface_.draw_over(framebuffer, layout, letters, legends);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  }
  return renderer::read_framebuffer(context_, framebuffer, area.width_px, area.height_px);
}

void ViewerPicture::draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
                         const UserInterface::Letters& letters, const renderer::OverlayView& overlay, bool is_urgent) {
  context_.make_current();
  const ViewArea area = scene_area(layout);
  drew_scene_ = false;
  if (has_room(area)) {
    drew_scene_ = draw_scenes(framebuffer, state, layout, level, false);
  } else {
    renderer::clear_framebuffer(context_, framebuffer, layout.width_px, layout.height_px, behind_panel_grey);
  }
  drew_scene_ = std::exchange(has_picture_, false) || drew_scene_;
  interface_.draw(framebuffer, layout, letters, overlay, is_urgent);
}

ViewerContext::ViewerContext(MakeContext make_context) : make_context_(std::move(make_context)) { renew(); }

ViewerContext::~ViewerContext() = default;

void ViewerContext::renew() {
  picture_.reset();
  // One at a time: a window system may have no second one to give.
  context_.reset();
  context_ = make_context_();
  picture_ = std::make_unique<ViewerPicture>(*context_);
}

}  // namespace taut::app
