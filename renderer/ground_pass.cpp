#include "renderer/ground_pass.hpp"

#include <array>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> shaded{"SHADED"};

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

GroundPass::GroundPass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      open_floor(context, files, "ground.vert", "ground.frag"),
      shaded_part(context, files, "ground.vert", "ground.frag", shaded),
      no_arrays(context) {
  bind_shared_inputs(open_floor);
  bind_shared_inputs(shaded_part);
}

void GroundPass::draw_part(const Program& program, const PixelRect& part) const {
  if (part.width_px <= 0 || part.height_px <= 0) return;
  gl->Scissor(part.x_px, part.y_px, part.width_px, part.height_px);
  program.use();
  gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GroundPass::draw(const FrameBlock& block) const {
  // Behind cloth that lies on it.
  gl->PolygonOffset(2.0F, 8.0F);
  gl->BindVertexArray(no_arrays.name());
  gl->Enable(GL_SCISSOR_TEST);
  const auto width_px = static_cast<int>(block.viewport.x);
  const auto height_px = static_cast<int>(block.viewport.y);
  const PixelRect in = shaded_floor(block);
  const int right_px = in.x_px + in.width_px;
  const int top_px = in.y_px + in.height_px;
  draw_part(shaded_part, in);
  draw_part(open_floor, {0, 0, width_px, in.y_px});
  draw_part(open_floor, {0, top_px, width_px, height_px - top_px});
  draw_part(open_floor, {0, in.y_px, in.x_px, in.height_px});
  draw_part(open_floor, {right_px, in.y_px, width_px - right_px, in.height_px});
  gl->Disable(GL_SCISSOR_TEST);
}

}  // namespace taut::renderer
