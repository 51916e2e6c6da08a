#include "renderer/passes/backdrop_pass.hpp"

#include "renderer/page/canvas.hpp"

namespace taut::renderer {

namespace {

// Margin of the shaded part of the floor, drawn px: the floor's shader moves its points along the normal before it
// samples the shadow map. Lower values cut the shadow off.
constexpr float shadow_margin_px = 4.0F;
// Offset of the floor's depth, in units of glPolygonOffset. With lower values the floor shows through cloth that lies
// on it.
constexpr float floor_offset_factor = 2.0F;
constexpr float floor_offset_units = 8.0F;

// Returns the drawn pixels per cell of the grid: higher values blur the floor's light at grazing angles, lower ones
// cost time.
int cell_px(int tile_height_px, BackdropGrid fineness) {
  if (fineness == BackdropGrid::coarsest) return std::clamp(tile_height_px / 11 / 16 * 16, 16, 64);
  return fineness == BackdropGrid::fine ? std::clamp(tile_height_px / 60, 4, 12)
                                        : std::clamp(tile_height_px / 20, 4, 36);
}

// Returns the drawn pixels per texel of the floor's shadow. Higher values are faster and blur the shadow's edge.
int shadow_texel_px(int tile_height_px) { return std::clamp(tile_height_px / 360, 1, 2); }

}  // namespace

PixelRect shaded_floor(const FrameBlock& block) {
  const glm::vec2 size{block.viewport};
  const PixelRect all{0, 0, static_cast<int>(size.x), static_cast<int>(size.y)};
  if (block.shadow.w <= 0.0F) return {};
  const glm::vec3 ray = -glm::vec3{block.towards_key};
  if (ray.y > -1e-3F) return all;
  const glm::mat4 map_to_world = glm::inverse(block.world_to_shadow);
  const glm::vec2 soft{block.shadow_blur.x * block.shadow.y};
  const glm::vec2 corners[] = {glm::vec2{block.shadow_bounds} - soft,
                               glm::vec2{block.shadow_bounds.z, block.shadow_bounds.w} + soft};
  glm::vec2 lower{size};
  glm::vec2 upper{0.0F};
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 from{map_to_world * glm::vec4{corners[i % 2].x, corners[i / 2].y, 0.0F, 1.0F}};
    const glm::vec3 on_floor = from + ray * ((block.ground.y - from.y) / ray.y);
    const glm::vec4 clip = block.world_to_clip * glm::vec4{on_floor, 1.0F};
    if (clip.w < 1e-3F) return all;  // behind the eye: it has no bounding rectangle in the picture
    const glm::vec2 pixel = (0.5F + 0.5F * glm::vec2{clip} / clip.w) * size;
    lower = glm::min(lower, pixel);
    upper = glm::max(upper, pixel);
  }
  const int left = whole_within(std::floor(lower.x - shadow_margin_px), 0, all.width_px);
  const int bottom = whole_within(std::floor(lower.y - shadow_margin_px), 0, all.height_px);
  const int right = whole_within(std::ceil(upper.x + shadow_margin_px), left, all.width_px);
  const int top = whole_within(std::ceil(upper.y + shadow_margin_px), bottom, all.height_px);
  return {left, bottom, right - left, top - bottom};
}

BackdropPass::BackdropPass(const GladGLContext& context)
    : gl_(&context),
      lit_(context, "backdrop_grid.vert", "backdrop.frag"),
      floor_shadow_(context, "fullscreen.vert", "floor_shadow.frag", {"FLOOR"}),
      shaded_(context, "backdrop_grid.vert", "backdrop.frag", {"SHADED"}),
      floor_depth_(context, "ground.vert", "depth.frag"),
      floor_shadow_map_(context, GL_R8, floor_shadow_unit),
      no_arrays_(context) {}

void BackdropPass::draw_grid(const Program& program, const FrameBlock& block, bool floor, BackdropGrid fineness) const {
  const glm::ivec2 size_px{block.viewport};
  const int cell = cell_px(size_px.y, fineness);
  const glm::ivec2 cells = (size_px + cell - 1) / cell;
  // The coarsest grid matches a software rasteriser's squares, which it fills faster as a whole.
  const glm::vec2 across =
      fineness == BackdropGrid::coarsest ? glm::vec2{size_px} / static_cast<float>(cell) : glm::vec2{cells};
  program.set("grid", glm::vec4{across, floor ? 1.0F : 0.0F, 0.0F});
  gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (cells.x + 1), cells.y);
}

void BackdropPass::draw_floor_shadow(const FrameBlock& block, const PixelRect& part) {
  const int texel = shadow_texel_px(static_cast<int>(block.viewport.y));
  // One texel more, as the last pixels blend with the next texels.
  const glm::ivec2 size_px = (glm::ivec2{part.width_px, part.height_px} + texel - 1) / texel + 1;
  floor_shadow_map_.begin(size_px);
  floor_shadow_.use().set("coarse", glm::vec4{static_cast<float>(part.x_px), static_cast<float>(part.y_px),
                                              static_cast<float>(texel), 0.0F});
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void BackdropPass::draw_shaded(const FrameBlock& block, const PixelRect& part, BackdropGrid fineness) {
  const auto texel = static_cast<float>(shadow_texel_px(static_cast<int>(block.viewport.y)));
  const glm::vec2 scale = 1.0F / (texel * glm::vec2{floor_shadow_map_.size_px()});
  floor_shadow_map_.bind();
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(part.x_px, part.y_px, part.width_px, part.height_px);
  const Program& program = shaded_.use();
  program.set("shaded_part", glm::vec4{scale, -scale * glm::vec2{part.x_px, part.y_px}});
  draw_grid(program, block, true, fineness);
  gl_->Disable(GL_SCISSOR_TEST);
}

void BackdropPass::draw_floor_depth() {
  gl_->Enable(GL_POLYGON_OFFSET_FILL);
  gl_->PolygonOffset(floor_offset_factor, floor_offset_units);
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  floor_depth_.use();
  gl_->BindVertexArray(no_arrays_.name());
  gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
}

void BackdropPass::draw(GLuint framebuffer, const FrameBlock& block, bool floor, BackdropGrid fineness) {
  gl_->Disable(GL_DEPTH_TEST);
  gl_->BindVertexArray(no_arrays_.name());
  const PixelRect part = floor ? shaded_floor(block) : PixelRect{};
  const bool any_shadow = part.width_px > 0 && part.height_px > 0;
  if (any_shadow) draw_floor_shadow(block, part);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const glm::ivec2 size_px{block.viewport};
  gl_->Viewport(0, 0, size_px.x, size_px.y);
  draw_grid(lit_.use(), block, floor, fineness);
  if (any_shadow) draw_shaded(block, part, fineness);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
