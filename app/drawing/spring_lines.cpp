#include "app/drawing/spring_lines.hpp"

namespace taut::app {
namespace {

// Flexural springs lie under the structural springs that they run along. Their lines are wider, to show on both sides.
constexpr float flexural_width_factor = 2.5F;

}  // namespace

bool shows(WhichSprings shown, sim::SpringKind kind) {
  return shown == WhichSprings::all || std::strcmp(to_name(shown), sim::to_name(kind)) == 0;
}

SpringLines::SpringLines(const sim::Garment& garment, WhichSprings shown, float width_px) {
  const sim::Springs& springs = garment.springs;
  for (const sim::SpringKind kind : {sim::SpringKind::flexural, sim::SpringKind::shear, sim::SpringKind::structural}) {
    if (!shows(shown, kind)) continue;
    const bool is_under = shown == WhichSprings::all && kind == sim::SpringKind::flexural;
    lines_.push_back({{springs.ends.begin() + static_cast<std::ptrdiff_t>(springs.begin_index(kind)),
                       springs.ends.begin() + static_cast<std::ptrdiff_t>(springs.end_index(kind))},
                      spring_colour(kind),
                      is_under ? flexural_width_factor * width_px : width_px,
                      {}});
  }
}

void SpringLines::add(std::span<const glm::vec3> positions, renderer::FrameView& frame) {
  for (SewingLines& lines : lines_) {
    lines.points.clear();
    for (const sim::Edge& ends : lines.springs) {
      lines.points.push_back(positions[ends[0]]);
      lines.points.push_back(positions[ends[1]]);
    }
    if (!lines.points.empty()) {
      frame.lines.push_back({.points = lines.points, .colour = lines.colour, .width_px = lines.width_px});
    }
  }
}

}  // namespace taut::app
