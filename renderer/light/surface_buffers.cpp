#include "renderer/light/surface_buffers.hpp"

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

SurfaceBuffers::SurfaceBuffers(const GladGLContext& context)
    : gl_(&context), vertex_data_(context), triangle_data_(context), material_data_(context) {
  GLint most = 0;
  gl_->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  most_texels_ = static_cast<std::size_t>(std::max(most, 0));
}

void SurfaceBuffers::clear() {
  vertices_.clear();
  triangles_.clear();
  materials_.clear();
}

void SurfaceBuffers::add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  const auto own = static_cast<std::uint32_t>(materials_.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    vertices_.push_back({{surface.positions[i], 0.0F},
                         {surface.normals[i], light.sky[i].x},
                         {material_of(surface, i), light.sky[i].y}});
  }
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    triangles_.emplace_back(first + surface.triangles[i], first + surface.triangles[i + 1],
                            first + surface.triangles[i + 2],
                            4 * own + static_cast<std::uint32_t>(light.key[i / 3]));
  }
  const SurfaceStyle& style = surface.style;
  const float weave = surface.material_coordinates.empty() ? 0.0F : style.weave;
  const float row = surface.scalars ? static_cast<float>(colour_map_row) : -1.0F;
  materials_.push_back({{linear_light(style.outside_colour), std::clamp(style.roughness, 0.05F, 1.0F)},
                        {linear_light(style.inside_colour), style.sheen},
                        {style.translucency, weave, row, 0.0F},
                        {static_cast<float>(style.weave_kind), style.threads_per_m, 0.0F, 0.0F}});
}

template <typename Row>
void SurfaceBuffers::upload_rows(BufferTexture& target, GLenum format, const std::vector<Row>& rows,
                                 unsigned unit) const {
  const std::size_t texels = rows.size() * sizeof(Row) / sizeof(glm::vec4);
  if (texels > most_texels_) {
    throw ContextError("the surfaces of a frame are too large for this OpenGL: " + std::to_string(texels) +
                       " texels in a buffer, at most " + std::to_string(most_texels_));
  }
  taut::renderer::upload(*gl_, GL_TEXTURE_BUFFER, target.buffer, std::span<const Row>(rows));
  bind_texture(*gl_, unit, GL_TEXTURE_BUFFER, target.texture);
  gl_->TexBuffer(GL_TEXTURE_BUFFER, format, target.buffer.name());
}

void SurfaceBuffers::upload() {
  upload_rows(vertex_data_, GL_RGBA32F, vertices_, vertex_data_unit);
  upload_rows(triangle_data_, GL_RGBA32UI, triangles_, triangle_data_unit);
  upload_rows(material_data_, GL_RGBA32F, materials_, material_data_unit);
}

void SurfaceBuffers::bind() const {
  bind_texture(*gl_, vertex_data_unit, GL_TEXTURE_BUFFER, vertex_data_.texture);
  bind_texture(*gl_, triangle_data_unit, GL_TEXTURE_BUFFER, triangle_data_.texture);
  bind_texture(*gl_, material_data_unit, GL_TEXTURE_BUFFER, material_data_.texture);
}

}  // namespace taut::renderer
