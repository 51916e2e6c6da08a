#include "app/viewer/picture/viewer_picture.hpp"

#include <utility>

#include "renderer/gl/colour_target.hpp"

namespace taut::app {
namespace {

// A smaller target is a window being closed, and nothing is drawn.
constexpr int smallest_side_px = 8;

bool has_room(const ViewArea& area) {
  return area.width_px >= smallest_side_px && area.height_px >= smallest_side_px;
}

GarmentSight first_sight(const ViewerState& state, const WindowLayout& layout) {
  return {state, *state.shown, garment_area(state, layout)};
}

// Of the right half.
std::optional<GarmentSight> second_sight(const ViewerState& state, const WindowLayout& layout) {
  const Snapshot* garment = compared(state);
  if (garment == nullptr) {
    return std::nullopt;
  }
  const ViewArea whole = scene_area(layout);
  const int left_px = garment_area(state, layout).width_px;
  return GarmentSight{state, *garment, {whole.width_px - left_px, whole.height_px}, left_px};
}

}  // namespace

ViewerPicture::ViewerPicture(renderer::Context& context)
    : context_(context), first_(context), interface_(context) {}

bool ViewerPicture::is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                             const renderer::OverlayView& overlay) const {
  if (!interface_.is_drawn(overlay)) {
    return false;
  }
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
  if (!second_) {
    second_.emplace(context_);
  }
  return second_->draw(framebuffer, *second, level, anew) || drew_first;
}

// Kept, so that `draw` can show it without the legends, which it lays over itself.
renderer::Image ViewerPicture::picture(unsigned framebuffer, const ViewerState& state,
                                       const WindowLayout& layout, std::size_t level,
                                       const UserInterface::Letters& letters,
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

void ViewerPicture::draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                         std::size_t level, const UserInterface::Letters& letters,
                         const renderer::OverlayView& overlay, bool is_urgent) {
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

}  // namespace taut::app
