#include "renderer/sky_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "renderer/bindings.hpp"
#include "renderer/frame_block.hpp"

namespace taut::renderer {

namespace {

constexpr int max_directions = 64;  // as max_sky_directions in shaders/sky.glsl
constexpr int columns = 8;
constexpr int rows = max_directions / columns;
// Side of one direction's map. Larger keeps finer folds dark, and costs time to fill.
constexpr int map_px = 128;
// Side of the floor's light texture; its contents are smooth.
constexpr int ground_px = 56;
// Brightness of the studio's floor against its ceiling, as seen by the underside of things.
constexpr float floor_brightness = 0.5F;

// Equal areas of the sphere along a spiral (Fibonacci lattice).
glm::vec3 direction(int i, int count) {
  const float y = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / static_cast<float>(count);
  const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / std::numbers::phi_v<float>;
  const float flat = std::sqrt(1.0F - y * y);
  return {flat * std::cos(turn), y, flat * std::sin(turn)};
}

// Of the cone that is a direction's share of the whole sphere.
float cone_tangent(int count) {
  const float cosine = std::max(1.0F - 2.0F / static_cast<float>(count), 0.3F);
  return std::sqrt(1.0F - cosine * cosine) / cosine;
}

}  // namespace

// Mirrors the std140 block `Sky` of shaders/sky.glsl.
struct SkyPass::Block {
  glm::vec4 info;
  glm::vec4 blur;
  std::array<glm::vec4, max_directions> directions;
  std::array<glm::mat4, max_directions> world_to_sky;
};

SkyPass::SkyPass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      ground(context, files, "fullscreen.vert", "ground_light.frag"),
      maps(columns, rows, map_px),
      atlas_map(context),
      ground_texture(context),
      ground_framebuffer(context),
      block_buffer(context),
      no_arrays(context) {
  allocate_depth(*gl, atlas_map, columns * map_px, rows * map_px);
  gl->BindTexture(GL_TEXTURE_2D, ground_texture.name());
  gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, ground_px, ground_px, 0, GL_RED, GL_FLOAT, nullptr);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    gl->TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  }
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl->BindFramebuffer(GL_FRAMEBUFFER, ground_framebuffer.name());
  gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, ground_texture.name(), 0);
  check_framebuffer(*gl, "floor's light");
  bind_shared_inputs(ground);
}

void SkyPass::draw_atlas(std::span<const SurfaceView* const> casters, const std::optional<Box>& box,
                         int directions) {
  Block block{};
  directions_drawn = box ? directions : 0;
  if (directions_drawn > 0) {
    const float side_m = glm::length(box->upper - box->lower);
    block.info = {static_cast<float>(directions_drawn), static_cast<float>(columns), static_cast<float>(rows),
                  1.5F * side_m / static_cast<float>(map_px)};
    block.blur = {cone_tangent(directions_drawn), 1.0F / static_cast<float>(map_px), 0.0F, 0.0F};
    for (int i = 0; i < directions_drawn; ++i) {
      const glm::vec3 towards = direction(i, directions_drawn);
      const auto k = static_cast<std::size_t>(i);
      block.directions[k] = glm::vec4{towards, towards.y > 0.0F ? 1.0F : floor_brightness};
      block.world_to_sky[k] = world_to_unit_cube(*box, towards);
    }
    draw_maps(casters, block, directions_drawn);
  }
  gl->BindBuffer(GL_UNIFORM_BUFFER, block_buffer.name());
  gl->BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
  gl->BindBufferBase(GL_UNIFORM_BUFFER, sky_block_binding, block_buffer.name());
}

void SkyPass::draw_maps(std::span<const SurfaceView* const> casters, const Block& block, int directions) {
  maps.clear();
  for (int i = 0; i < directions; ++i) {
    const glm::mat4& world_to_map = block.world_to_sky[static_cast<std::size_t>(i)];
    for (const SurfaceView* caster : casters) {
      maps.draw(i, world_to_map, caster->positions, caster->triangles);
    }
  }
  gl->BindTexture(GL_TEXTURE_2D, atlas_map.name());
  gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, maps.width_px(), maps.height_px(), GL_DEPTH_COMPONENT, GL_FLOAT,
                    maps.depths().data());
}

void SkyPass::clear_ground() {
  constexpr std::array open{1.0F, 1.0F, 1.0F, 1.0F};
  gl->ClearBufferfv(GL_COLOR, 0, open.data());
}

void SkyPass::draw_ground_light() {
  gl->BindFramebuffer(GL_FRAMEBUFFER, ground_framebuffer.name());
  gl->Viewport(0, 0, ground_px, ground_px);
  if (directions_drawn < 2) {
    clear_ground();
    return;
  }
  gl->BindVertexArray(no_arrays.name());
  ground.use();
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taut::renderer
