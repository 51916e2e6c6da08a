#include "renderer/surface_pass.hpp"

#include <algorithm>
#include <array>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> shaded{"SHADED"};

}  // namespace

SurfacePass::SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      decided_surface(context, files, "surface.vert", "surface.frag"),
      open_surface(context, files, "surface.vert", "surface.frag", shaded),
      colour_maps(context) {
  bind_shared_inputs(decided_surface);
  bind_shared_inputs(open_surface);
}

void SurfacePass::fill(std::span<const SurfaceView> surfaces, StudioLight& light, const glm::vec3& eye) {
  while (buffers.size() < surfaces.size()) buffers.emplace_back(*gl);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].filled) continue;
    light.gather(surfaces[i], vertex_light);
    buffers[i].fill(surfaces[i], vertex_light, eye);
  }
}

void SurfacePass::use(const Program& program, const SurfaceView& view) const {
  program.use();
  program.set("outside_colour", linear_light(view.style.outside_colour));
  program.set("inside_colour", linear_light(view.style.inside_colour));
  program.set("finish", glm::vec4{std::clamp(view.style.roughness, 0.05F, 1.0F), view.style.sheen,
                                  view.style.translucency, view.scalars ? 1.0F : 0.0F});
  const bool woven = !view.material_coordinates.empty() && !view.scalars;
  program.set("weave", glm::vec4{woven ? view.style.weave : 0.0F, 0.0F, 0.0F, 0.0F});
}

void SurfacePass::draw(std::span<const SurfaceView> surfaces) {
  // Pushed back a little, more where slanted: wireframes lie on them.
  gl->Enable(GL_POLYGON_OFFSET_FILL);
  gl->PolygonOffset(1.5F, 4.0F);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SurfaceView& view = surfaces[i];
    if (!view.filled) continue;
    bind_texture(*gl, scalar_map_unit, GL_TEXTURE_2D,
                 colour_maps.get(view.scalars ? view.scalars->map : ColourMap::viridis));
    use(decided_surface, view);
    buffers[i].draw_decided();
    use(open_surface, view);
    buffers[i].draw_open();
  }
  gl->Disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace taut::renderer
