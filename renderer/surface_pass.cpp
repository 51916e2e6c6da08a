#include "renderer/surface_pass.hpp"

#include <array>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

// Variants of the shading: the sum of these says which.
constexpr std::size_t several_samples = 1;
constexpr std::size_t data = 2;
constexpr std::size_t open_to_shadow = 4;
constexpr std::size_t variants = 8;

std::span<const std::string_view> defines(std::size_t variant) {
  static constexpr std::array<std::string_view, 5> names{"DATA", "MULTISAMPLED", "OPEN", "DATA",
                                                         "MULTISAMPLED"};
  // Where in the row of names each variant starts, and how many it takes.
  static constexpr std::array<std::array<std::size_t, 2>, variants> parts{
      {{0, 0}, {1, 1}, {0, 1}, {0, 2}, {2, 1}, {1, 2}, {2, 2}, {2, 3}}};
  return std::span(names).subspan(parts[variant][0], parts[variant][1]);
}

}  // namespace

SurfacePass::SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      seen(context, files, "seen.vert", "seen.frag"),
      colour_maps(context),
      tables(context),
      square_arrays(context),
      square_corners(context) {
  for (std::size_t variant = 0; variant < variants; ++variant) {
    shading.emplace_back(context, files, "squares.vert", "surface.frag", defines(variant));
  }
  gl->BindVertexArray(square_arrays.name());
  set_attribute(*gl, 0, square_corners, 2, 2, 0);
  gl->BindVertexArray(0);
}

void SurfacePass::fill(std::span<const SurfaceView> surfaces, StudioLight& light) {
  tables.clear();
  any_data = false;
  for (const SurfaceView& surface : surfaces) {
    if (!surface.filled) continue;
    light.gather(surface, surface_light);
    tables.add(surface, surface_light, surface.scalars ? colour_maps.row_of(surface.scalars->map) : -1);
    any_data = any_data || surface.scalars;
  }
  if (!tables.empty()) tables.upload();
}

void SurfacePass::draw_seen(bool under_marks) {
  if (tables.empty()) return;
  // Pushed back a little, more where slanted, so that wireframes lie on them. At a silhouette that lets the
  // far side show through the near one, which is steeper there.
  if (under_marks) gl->Enable(GL_POLYGON_OFFSET_FILL);
  gl->PolygonOffset(1.5F, 4.0F);
  seen.use();
  tables.bind();
  tables.draw();
  gl->Disable(GL_POLYGON_OFFSET_FILL);
}

void SurfacePass::shade_squares(bool open, const LayerTarget& layer, const PixelRect& place) {
  const std::vector<glm::vec2>& corners = squares.corners(open);
  if (corners.empty()) return;
  const std::size_t variant =
      (layer.samples() > 1 ? several_samples : 0) + (any_data ? data : 0) + (open ? open_to_shadow : 0);
  const Program& program = shading[variant].use();
  program.set("corner", glm::ivec4{place.x_px, place.y_px, 0, 0});
  program.set("samples_x", layer.samples_x());
  program.set("samples_y", layer.samples_y());
  gl->BindVertexArray(square_arrays.name());
  upload(*gl, GL_ARRAY_BUFFER, square_corners, std::span<const glm::vec2>(corners));
  gl->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void SurfacePass::shade(const LayerTarget& layer, const FrameBlock& block, const PixelRect& place) {
  if (tables.empty()) return;
  squares.find(tables, block.world_to_clip, {place.width_px, place.height_px});
  const bool several = layer.samples() > 1;
  tables.bind();
  layer.bind_seen();
  if (any_data) bind_texture(*gl, scalar_maps_unit, GL_TEXTURE_2D, colour_maps.texture());
  gl->Disable(GL_DEPTH_TEST);
  // A single sample covers its pixel or does not: it is encoded by the shader, which is cheaper.
  if (several) begin_laying_over(*gl);
  shade_squares(false, layer, place);
  shade_squares(true, layer, place);
  if (several) end_laying_over(*gl);
  gl->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
