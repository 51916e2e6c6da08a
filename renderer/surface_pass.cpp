#include "renderer/surface_pass.hpp"

#include <algorithm>
#include <array>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> open{"OPEN"};
constexpr std::array<std::string_view, 1> data{"DATA"};
constexpr std::array<std::string_view, 2> data_open{"DATA", "OPEN"};

}  // namespace

SurfacePass::SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      decided_cloth(context, files, "surface.vert", "surface.frag"),
      open_cloth(context, files, "surface.vert", "surface.frag", open),
      decided_data(context, files, "surface.vert", "surface.frag", data),
      open_data(context, files, "surface.vert", "surface.frag", data_open),
      colour_maps(context) {}

void SurfacePass::fill(std::span<const SurfaceView> surfaces, StudioLight& light) {
  while (buffers.size() < surfaces.size()) buffers.emplace_back(*gl);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].filled) continue;
    light.gather(surfaces[i], vertex_light);
    buffers[i].fill(surfaces[i], vertex_light);
  }
}

void SurfacePass::draw_cloth(std::size_t surface, const SurfaceView& view) {
  const auto set_looks = [&](const Program& program) {
    program.set("outside_colour", linear_light(view.style.outside_colour));
    program.set("inside_colour", linear_light(view.style.inside_colour));
    const float weave = view.material_coordinates.empty() ? 0.0F : view.style.weave;
    program.set("finish", glm::vec4{std::clamp(view.style.roughness, 0.05F, 1.0F), view.style.sheen,
                                    view.style.translucency, weave});
  };
  set_looks(decided_cloth.use());
  buffers[surface].draw_decided();
  set_looks(open_cloth.use());
  buffers[surface].draw_open();
}

void SurfacePass::draw_data(std::size_t surface, const SurfaceView& view) {
  bind_texture(*gl, scalar_map_unit, GL_TEXTURE_2D, colour_maps.get(view.scalars->map));
  const glm::vec4 finish{1.0F, view.style.sheen, view.style.translucency, 0.0F};
  decided_data.use().set("finish", finish);
  buffers[surface].draw_decided();
  open_data.use().set("finish", finish);
  buffers[surface].draw_open();
}

void SurfacePass::draw(std::span<const SurfaceView> surfaces) {
  // Pushed back a little, more where slanted: wireframes lie on them.
  gl->Enable(GL_POLYGON_OFFSET_FILL);
  gl->PolygonOffset(1.5F, 4.0F);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].filled) continue;
    if (surfaces[i].scalars) {
      draw_data(i, surfaces[i]);
    } else {
      draw_cloth(i, surfaces[i]);
    }
  }
  gl->Disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace taut::renderer
