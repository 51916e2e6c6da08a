#include "renderer/light/surface_buffers.hpp"

#include "renderer/gl/shader.hpp"
#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

namespace {

// The unit of a triangle's last number, besides the key light: surfaces and trims.
constexpr std::uint32_t surface_unit = 4;
constexpr std::uint32_t trim_unit = 1U << 14;
constexpr std::size_t most_surfaces = trim_unit / surface_unit;
// More are not drawn; they would be of a very large picture.
constexpr std::size_t most_trims = 1U << 18;

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

void spread(const SurfaceView& surface, SurfaceLight& light) {
  const Refinement& refinement = *surface.refinement;
  interpolate(refinement.parents, light.sky);
  for (std::size_t i = refinement.coarse_vertices; i < light.sky.size(); ++i) {
    const glm::vec3& parent = surface.normals[refinement.parents[i - refinement.coarse_vertices][0]];
    if (glm::dot(surface.normals[i], parent) < 0.0F) std::swap(light.sky[i].x, light.sky[i].y);
  }
  std::vector<KeyVisibility> key;
  key.reserve(refinement.parent_triangles.size());
  for (const std::uint32_t parent : refinement.parent_triangles) key.push_back(light.key[parent]);
  light.key = std::move(key);
}

SurfaceBuffers::SurfaceBuffers(const GladGLContext& context)
    : gl_(&context),
      vertex_data_(context),
      triangle_data_(context),
      material_data_(context),
      corner_data_(context),
      trim_data_(context) {
  GLint most = 0;
  gl_->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  most_texels_ = static_cast<std::size_t>(std::max(most, 0));
}

void SurfaceBuffers::clear() {
  vertices_.clear();
  triangles_.clear();
  materials_.clear();
  corners_.clear();
  trims_.assign(1, {});  // of those without
}

void SurfaceBuffers::add_materials(const SurfaceView& surface, float row, BaseColourMapTexture& maps) {
  const SurfaceStyle& style = surface.style;
  const float weave = surface.material_coordinates.empty() ? 0.0F : style.weave;
  const auto add_one = [&](const BaseColour& colour) {
    const float layer =
        surface.scalars || !colour.map.rgba ? -1.0F : static_cast<float>(maps.layer_of(colour.map));
    materials_.push_back({{linear_light(colour.outside_colour), std::clamp(style.roughness, 0.05F, 1.0F)},
                          {linear_light(colour.inside_colour), style.sheen},
                          {style.translucency, weave, row, layer},
                          {static_cast<float>(style.weave_kind), style.threads_per_m, 0.0F, 0.0F}});
    return layer >= 0.0F;
  };
  bool has_map = false;
  for (const BaseColour& colour : surface.base_colours) has_map = add_one(colour) || has_map;
  if (surface.base_colours.empty()) {
    add_one({style.outside_colour, style.inside_colour.value_or(reverse_of(style.outside_colour))});
  }
  if (has_map) add_corners(surface);
}

// Triangles before these, which have no map, have corners that nobody looks at.
void SurfaceBuffers::add_corners(const SurfaceView& surface) {
  corners_.resize(3 * triangles_.size() - surface.corner_coordinates.size());
  corners_.insert(corners_.end(), surface.corner_coordinates.begin(), surface.corner_coordinates.end());
}

void SurfaceBuffers::add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row,
                         BaseColourMapTexture& maps) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  const auto own = static_cast<std::uint32_t>(materials_.size());
  if (own + surface.base_colours.size() >= most_surfaces) {
    throw ContextError("a frame has more than " + std::to_string(most_surfaces) + " surfaces");
  }
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    vertices_.push_back({{surface.positions[i], 0.0F},
                         {surface.normals[i], light.sky[i].x},
                         {material_of(surface, i), light.sky[i].y}});
  }
  const std::size_t first_triangle = triangles_.size();
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    const std::uint32_t colour =
        surface.base_colour_of_triangle.empty() ? 0 : surface.base_colour_of_triangle[i / 3];
    triangles_.emplace_back(first + surface.triangles[i], first + surface.triangles[i + 1],
                            first + surface.triangles[i + 2],
                            (own + colour) * surface_unit + static_cast<std::uint32_t>(light.key[i / 3]));
  }
  for (const TrimmedTriangle& trim : surface.trims) {
    if (trims_.size() >= most_trims) break;
    triangles_[first_triangle + trim.triangle].w += static_cast<std::uint32_t>(trims_.size()) * trim_unit;
    trims_.push_back(
        {trim.corners, {trim.band_m, trim.ribbed ? 1.0F : 0.0F, trim.thickness_m, trim.stitch_m}});
  }
  add_materials(surface, surface.scalars ? static_cast<float>(colour_map_row) : -1.0F, maps);
}

template <typename Row>
void SurfaceBuffers::upload_rows(BufferTexture& target, GLenum format, const std::vector<Row>& rows,
                                 unsigned unit) const {
  const std::size_t texels = rows.size() * std::max<std::size_t>(sizeof(Row) / sizeof(glm::vec4), 1);
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
  if (has_maps()) upload_rows(corner_data_, GL_RG32F, corners_, corner_data_unit);
  upload_rows(trim_data_, GL_RGBA32F, trims_, trim_data_unit);
}

void SurfaceBuffers::bind() const {
  bind_texture(*gl_, vertex_data_unit, GL_TEXTURE_BUFFER, vertex_data_.texture);
  bind_texture(*gl_, triangle_data_unit, GL_TEXTURE_BUFFER, triangle_data_.texture);
  bind_texture(*gl_, material_data_unit, GL_TEXTURE_BUFFER, material_data_.texture);
  if (has_maps()) bind_texture(*gl_, corner_data_unit, GL_TEXTURE_BUFFER, corner_data_.texture);
  bind_texture(*gl_, trim_data_unit, GL_TEXTURE_BUFFER, trim_data_.texture);
}

}  // namespace taut::renderer
