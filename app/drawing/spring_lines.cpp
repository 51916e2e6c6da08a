#include "app/drawing/spring_lines.hpp"

namespace taut::app {
namespace {

// Flexural springs lie under the structural ones they skip along: wider, they show on both sides.
constexpr float flexural_width = 2.5F;

bool is_within(const std::optional<SpringBall>& patch, const sim::Garment& garment, const sim::Edge& ends) {
  return !patch || std::ranges::all_of(ends, [&](sim::Index end) {
    return glm::distance(garment.mesh.positions[end], patch->middle_m) <= patch->radius_m;
  });
}

}  // namespace

bool shows(const ShownSprings& shown, sim::SpringKind kind) {
  return shown.which == WhichSprings::all || std::strcmp(name_of(shown.which), sim::name_of(kind)) == 0;
}

SpringLines::SpringLines(const sim::Garment& garment, const ShownSprings& shown, float width_px) {
  const sim::Springs& springs = garment.springs;
  const auto last = static_cast<float>(std::max<std::size_t>(springs.size(), 2) - 1);
  for (const sim::SpringKind kind :
       {sim::SpringKind::flexural, sim::SpringKind::shear, sim::SpringKind::structural}) {
    if (!shows(shown, kind)) continue;
    Lines& lines = lines_.emplace_back();
    const bool is_under = shown.which == WhichSprings::all && kind == sim::SpringKind::flexural;
    lines.width_px = is_under ? flexural_width * width_px : width_px;
    for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
      if (!is_within(shown.patch, garment, springs.ends[s])) continue;
      lines.springs.push_back(springs.ends[s]);
      if (shown.colours == SpringColours::order) {
        const renderer::Colour colour =
            renderer::colour_at(renderer::ColourMap::viridis, static_cast<float>(s) / last);
        lines.colours.insert(lines.colours.end(), 2, colour);
      }
    }
    if (shown.colours == SpringColours::kind) lines.colours = {spring_colour(kind)};
  }
}

void SpringLines::add(std::span<const glm::vec3> positions, renderer::FrameView& frame) {
  for (Lines& lines : lines_) {
    lines.points.clear();
    for (const sim::Edge& ends : lines.springs) {
      lines.points.push_back(positions[ends[0]]);
      lines.points.push_back(positions[ends[1]]);
    }
    if (!lines.points.empty()) {
      frame.lines.push_back({.points = lines.points, .colours = lines.colours, .width_px = lines.width_px});
    }
  }
}

}  // namespace taut::app
