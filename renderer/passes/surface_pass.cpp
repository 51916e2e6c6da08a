#include "renderer/passes/surface_pass.hpp"

#include <glm/common.hpp>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

namespace {

// Variants of the shading: the sum of these says which.
constexpr std::size_t several_samples = 1;
constexpr std::size_t data = 2;
constexpr std::size_t open_to_shadow = 4;
// Instead of several samples.
constexpr std::size_t halved = 8;
constexpr std::size_t variants = 16;

std::vector<std::string_view> defines(std::size_t variant) {
  std::vector<std::string_view> names;
  if ((variant & several_samples) != 0) names.emplace_back("MULTISAMPLED");
  if ((variant & data) != 0) names.emplace_back("DATA");
  if ((variant & open_to_shadow) != 0) names.emplace_back("OPEN");
  if ((variant & halved) != 0) names.emplace_back("HALVED");
  return names;
}

}  // namespace

SurfacePass::SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      seen(context, files, "seen.vert", "seen.frag"),
      placed_arrays(context),
      placed_positions(context),
      colour_maps(context),
      tables(context),
      square_arrays(context),
      square_corners(context),
      stretching(context, files, "squares.vert", "surface_halved.frag"),
      halved_colour(context),
      halved_framebuffer(context) {
  for (std::size_t variant = 0; variant < variants; ++variant) variant_defines.push_back(defines(variant));
  for (const auto& names : variant_defines) {
    shading.emplace_back(context, files, "squares.vert", "surface.frag", names);
  }
  gl->BindVertexArray(placed_arrays.name());
  set_attribute(*gl, 0, placed_positions, 3, 3, 0);
  gl->BindVertexArray(square_arrays.name());
  set_attribute(*gl, 0, square_corners, 2, 2, 0);
  gl->BindVertexArray(0);
}

// Every triangle has corners of its own, so that a vertex knows the number of its triangle.
void SurfacePass::place(std::span<const SurfaceView> surfaces) {
  placed.clear();
  for (const SurfaceView& surface : surfaces) {
    if (!surface.filled) continue;
    for (const std::uint32_t corner : surface.triangles) placed.push_back(surface.positions[corner]);
  }
  taut::renderer::upload(*gl, GL_ARRAY_BUFFER, placed_positions, std::span<const glm::vec3>(placed));
}

void SurfacePass::gather(std::span<const SurfaceView> surfaces, StudioLight& light) {
  tables.clear();
  any_data = false;
  for (const SurfaceView& surface : surfaces) {
    if (!surface.filled) continue;
    light.gather(surface, surface_light);
    tables.add(surface, surface_light, surface.scalars ? colour_maps.row_of(surface.scalars->map) : -1);
    any_data = any_data || surface.scalars;
  }
}

void SurfacePass::upload() {
  if (!tables.empty()) tables.upload();
}

void SurfacePass::draw_seen(bool under_marks) {
  if (placed.empty()) return;
  // Pushed back a little, more where slanted, so that wireframes lie on them. At a silhouette that lets the
  // far side show through the near one, which is steeper there.
  if (under_marks) gl->Enable(GL_POLYGON_OFFSET_FILL);
  gl->PolygonOffset(1.5F, 4.0F);
  seen.use();
  gl->BindVertexArray(placed_arrays.name());
  gl->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(placed.size()));
  gl->Disable(GL_POLYGON_OFFSET_FILL);
}

void SurfacePass::draw_squares(bool open) {
  const std::vector<glm::vec2>& covered = squares.corners(open);
  gl->BindVertexArray(square_arrays.name());
  taut::renderer::upload(*gl, GL_ARRAY_BUFFER, square_corners, std::span<const glm::vec2>(covered));
  gl->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(covered.size()));
}

void SurfacePass::shade_squares(std::size_t kind, const LayerTarget& layer, const glm::ivec2& corner_px) {
  for (const bool open : {false, true}) {
    if (squares.corners(open).empty()) continue;
    const Program& program = shading[kind + (any_data ? data : 0) + (open ? open_to_shadow : 0)].use();
    program.set("corner", glm::ivec4{corner_px, 0, 0});
    program.set("samples_x", layer.samples_x());
    program.set("samples_y", layer.samples_y());
    draw_squares(open);
  }
}

// Its size changes with every step of a garment: it only grows.
void SurfacePass::begin_halved(const glm::ivec2& size_px) {
  gl->BindFramebuffer(GL_FRAMEBUFFER, halved_framebuffer.name());
  const glm::ivec2 roomy_px = glm::max(size_px, halved_px);
  if (roomy_px != halved_px) {
    halved_px = roomy_px;
    bind_texture(*gl, halved_unit, GL_TEXTURE_2D, halved_colour);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, halved_px.x, halved_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   nullptr);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      gl->TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, halved_colour.name(), 0);
    check_framebuffer(*gl, "halved surfaces");
  }
  gl->Viewport(0, 0, size_px.x, size_px.y);
  gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl->Clear(GL_COLOR_BUFFER_BIT);
}

void SurfacePass::shade_halved(const LayerTarget& layer, GLuint framebuffer, const PixelRect& place) {
  begin_halved({place.width_px / 2, place.height_px / 2});
  shade_squares(halved, layer, {0, 0});
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  bind_texture(*gl, halved_unit, GL_TEXTURE_2D, halved_colour);
  const Program& program = stretching.use();
  program.set("corner", glm::ivec4{place.x_px, place.y_px, 0, 0});
  program.set("halved_part", glm::vec4{0.5F / glm::vec2{halved_px}, 0.0F, 0.0F});
  for (const bool open : {false, true}) draw_squares(open);
}

void SurfacePass::shade(const LayerTarget& layer, GLuint framebuffer, const FrameBlock& block,
                        const PixelRect& place, bool halve) {
  if (tables.empty()) return;
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  squares.find(tables, block.world_to_clip, {place.width_px, place.height_px});
  const bool several = layer.samples() > 1;
  tables.bind();
  // The map is made when it is first asked for, in the unit that happens to be active.
  if (any_data) bind_texture(*gl, scalar_maps_unit, GL_TEXTURE_2D, colour_maps.texture());
  layer.bind_seen();
  gl->Disable(GL_DEPTH_TEST);
  // A single sample covers its pixel or does not: it is encoded by the shader, which is cheaper.
  if (several) begin_laying_over(*gl);
  if (halve && !several && place.width_px % 2 == 0 && place.height_px % 2 == 0) {
    shade_halved(layer, framebuffer, place);
  } else {
    shade_squares(several ? several_samples : 0, layer, {place.x_px, place.y_px});
  }
  if (several) end_laying_over(*gl);
  gl->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
