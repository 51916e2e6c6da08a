#include "renderer/light/surface_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/context/context.hpp"
#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

namespace {

// Below 0 for not a number.
float share_of_range(const ScalarColours& scalars, std::size_t vertex) {
  const float value = scalars.values[vertex];
  if (std::isnan(value)) return -1.0F;
  return std::clamp((value - scalars.minimum) / (scalars.maximum - scalars.minimum), 0.0F, 1.0F);
}

glm::vec3 material_of(const SurfaceView& surface, std::size_t vertex) {
  if (surface.scalars) return {share_of_range(*surface.scalars, vertex), 0.0F, 0.0F};
  return surface.material_coordinates.empty() ? glm::vec3{0.0F} : surface.material_coordinates[vertex];
}

}  // namespace

SurfaceTables::SurfaceTables(const GladGLContext& context)
    : gl(&context), vertex_table(context), triangle_table(context), look_table(context) {
  GLint most = 0;
  gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  most_texels = static_cast<std::size_t>(std::max(most, 0));
}

void SurfaceTables::clear() {
  vertices.clear();
  triangles.clear();
  looks.clear();
}

void SurfaceTables::add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  const auto own = static_cast<std::uint32_t>(looks.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    vertices.push_back({{surface.positions[i], 0.0F},
                        {surface.normals[i], light.sky[i].x},
                        {material_of(surface, i), light.sky[i].y}});
  }
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    triangles.emplace_back(first + surface.triangles[i], first + surface.triangles[i + 1],
                           first + surface.triangles[i + 2],
                           4 * own + static_cast<std::uint32_t>(light.key[i / 3]));
  }
  const SurfaceStyle& style = surface.style;
  const float weave = surface.material_coordinates.empty() ? 0.0F : style.weave;
  const float row = surface.scalars ? static_cast<float>(colour_map_row) : -1.0F;
  looks.push_back({{linear_light(style.outside_colour), std::clamp(style.roughness, 0.05F, 1.0F)},
                   {linear_light(style.inside_colour), style.sheen},
                   {style.translucency, weave, row, 0.0F}});
}

template <typename Row>
void SurfaceTables::upload_table(Table& table, GLenum format, const std::vector<Row>& rows,
                                 unsigned unit) const {
  const std::size_t texels = rows.size() * sizeof(Row) / sizeof(glm::vec4);
  if (texels > most_texels) {
    throw ContextError("the surfaces of a frame are too large for this OpenGL: " + std::to_string(texels) +
                       " texels in a table, at most " + std::to_string(most_texels));
  }
  taut::renderer::upload(*gl, GL_TEXTURE_BUFFER, table.buffer, std::span<const Row>(rows));
  bind_texture(*gl, unit, GL_TEXTURE_BUFFER, table.texture);
  gl->TexBuffer(GL_TEXTURE_BUFFER, format, table.buffer.name());
}

void SurfaceTables::upload() {
  upload_table(vertex_table, GL_RGBA32F, vertices, vertex_table_unit);
  upload_table(triangle_table, GL_RGBA32UI, triangles, triangle_table_unit);
  upload_table(look_table, GL_RGBA32F, looks, look_table_unit);
}

void SurfaceTables::bind() const {
  bind_texture(*gl, vertex_table_unit, GL_TEXTURE_BUFFER, vertex_table.texture);
  bind_texture(*gl, triangle_table_unit, GL_TEXTURE_BUFFER, triangle_table.texture);
  bind_texture(*gl, look_table_unit, GL_TEXTURE_BUFFER, look_table.texture);
}

}  // namespace taut::renderer
