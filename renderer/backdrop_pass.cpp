#include "renderer/backdrop_pass.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

// Drawn pixels for a texel of the map: larger blurs the floor's light where it is seen at a slant, smaller
// costs time. A small picture needs finer ones.
int texel_px(int tile_height_px) {
  return std::clamp(tile_height_px / 180, 1, 4);
}

}  // namespace

PixelRect shaded_floor(const FrameBlock& block) {
  const glm::vec2 size{block.viewport};
  const PixelRect all{0, 0, static_cast<int>(size.x), static_cast<int>(size.y)};
  if (block.shadow.w <= 0.0F) return {};
  const glm::vec3 ray = -glm::vec3{block.towards_key};
  if (ray.y > -1e-3F) return all;
  const glm::mat4 map_to_world = glm::inverse(block.world_to_shadow);
  const glm::vec2 soft{widest_penumbra_texels * block.shadow.y};
  const glm::vec2 corners[] = {glm::vec2{block.shadow_bounds} - soft,
                               glm::vec2{block.shadow_bounds.z, block.shadow_bounds.w} + soft};
  glm::vec2 lower{size};
  glm::vec2 upper{0.0F};
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 from{map_to_world * glm::vec4{corners[i % 2].x, corners[i / 2].y, 0.0F, 1.0F}};
    const glm::vec3 on_floor = from + ray * ((block.ground.y - from.y) / ray.y);
    const glm::vec4 clip = block.world_to_clip * glm::vec4{on_floor, 1.0F};
    if (clip.w < 1e-3F) return all;  // behind the eye: no rectangle of the picture holds it
    const glm::vec2 pixel = (0.5F + 0.5F * glm::vec2{clip} / clip.w) * size;
    lower = glm::min(lower, pixel);
    upper = glm::max(upper, pixel);
  }
  // A few pixels more: the floor's shader lifts its points before it looks them up.
  lower = glm::clamp(glm::floor(lower - 4.0F), glm::vec2{0.0F}, size);
  upper = glm::clamp(glm::ceil(upper + 4.0F), lower, size);
  return {static_cast<int>(lower.x), static_cast<int>(lower.y), static_cast<int>(upper.x - lower.x),
          static_cast<int>(upper.y - lower.y)};
}

BackdropPass::BackdropPass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      coarse(context, files, "fullscreen.vert", "backdrop_map.frag"),
      stretched(context, files, "fullscreen.vert", "backdrop.frag"),
      shaded_part(context, files, "ground.vert", "ground.frag"),
      floor_depth(context, files, "ground.vert", "depth.frag"),
      map(context),
      map_framebuffer(context),
      no_arrays(context) {}

void BackdropPass::draw_map(const FrameBlock& block, const glm::mat4& clip_to_direction, bool floor) {
  const int texel = texel_px(static_cast<int>(block.viewport.y));
  const glm::ivec2 size_px = (glm::ivec2{block.viewport} + texel - 1) / texel;
  if (size_px != map_px) {
    bind_texture(*gl, backdrop_map_unit, GL_TEXTURE_2D, map);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_px.x, size_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      gl->TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->BindFramebuffer(GL_FRAMEBUFFER, map_framebuffer.name());
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map.name(), 0);
    check_framebuffer(*gl, "backdrop");
    map_px = size_px;
  }
  gl->BindFramebuffer(GL_FRAMEBUFFER, map_framebuffer.name());
  gl->Viewport(0, 0, map_px.x, map_px.y);
  const Program& program = coarse.use();
  program.set("clip_to_direction", clip_to_direction);
  program.set("coarse", glm::vec4{static_cast<float>(texel), floor ? 1.0F : 0.0F, 0.0F, 0.0F});
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

void BackdropPass::draw_shaded_floor(const FrameBlock& block) {
  const PixelRect part = shaded_floor(block);
  if (part.width_px <= 0 || part.height_px <= 0) return;
  gl->Enable(GL_SCISSOR_TEST);
  gl->Scissor(part.x_px, part.y_px, part.width_px, part.height_px);
  shaded_part.use();
  gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl->Disable(GL_SCISSOR_TEST);
}

void BackdropPass::draw_floor_depth() {
  // Behind cloth that lies on it.
  gl->Enable(GL_POLYGON_OFFSET_FILL);
  gl->PolygonOffset(2.0F, 8.0F);
  gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  floor_depth.use();
  gl->BindVertexArray(no_arrays.name());
  gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->Disable(GL_POLYGON_OFFSET_FILL);
}

void BackdropPass::draw(GLuint framebuffer, const FrameBlock& block, const glm::mat4& clip_to_direction,
                        bool floor) {
  gl->Disable(GL_DEPTH_TEST);
  gl->BindVertexArray(no_arrays.name());
  draw_map(block, clip_to_direction, floor);
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const glm::ivec2 size_px{block.viewport};
  gl->Viewport(0, 0, size_px.x, size_px.y);
  bind_texture(*gl, backdrop_map_unit, GL_TEXTURE_2D, map);
  const Program& program = stretched.use();
  const glm::vec2 to_texture = 1.0F / glm::vec2{map_px * texel_px(size_px.y)};
  program.set("coarse", glm::vec4{0.0F, 0.0F, to_texture});
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
  if (floor) draw_shaded_floor(block);
  gl->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
