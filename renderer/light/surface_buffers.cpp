#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {
namespace {

// Unit of the trim number in a triangle's last number; the surface's number is below it.
constexpr std::uint32_t trim_unit = 1U << 14;
constexpr std::size_t max_surfaces = trim_unit;
// Largest number of drawn trims; only a very large picture has more.
constexpr std::size_t max_trims = 1U << 18;

// Returns the fraction of the scalar range; below 0 for NaN.
float share_of_range(const ScalarColours& scalars, std::size_t vertex) {
  const float value = scalars.values[vertex];
  if (std::isnan(value)) return -1.0F;
  return std::clamp((value - scalars.minimum) / (scalars.maximum - scalars.minimum), 0.0F, 1.0F);
}

glm::vec3 vertex_material(const SurfaceView& surface, std::size_t vertex) {
  if (surface.scalars) return {share_of_range(*surface.scalars, vertex), 0.0F, 0.0F};
  return surface.material_coordinates.empty() ? glm::vec3{0.0F} : surface.material_coordinates[vertex];
}

}  // namespace

SurfaceBuffers::SurfaceBuffers(const GladGLContext& context)
    : gl_(&context),
      vertex_data_(context),
      triangle_data_(context),
      material_data_(context),
      corner_data_(context),
      trim_data_(context) {
  GLint max_rows = 0;
  gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_rows);
  max_rows_ = static_cast<std::size_t>(std::max(max_rows, 0));
}

void SurfaceBuffers::clear() {
  vertices_.clear();
  triangles_.clear();
  materials_.clear();
  corners_.clear();
  trims_.assign(1, {});  // entry of triangles without trims
}

void SurfaceBuffers::add_materials(const SurfaceView& surface, float row, BaseColourMapTexture& maps) {
  const SurfaceStyle& style = surface.style;
  const float weave = surface.material_coordinates.empty() ? 0.0F : style.weave;
  const auto add_one = [&](const BaseColour& colour) {
    const float layer = surface.scalars || !colour.map.rgba ? -1.0F : static_cast<float>(maps.add_layer(colour.map));
    materials_.push_back(
        {{linear_light(colour.outside_colour), std::clamp(style.roughness, 0.05F, 1.0F)},
         {linear_light(colour.inside_colour), style.sheen},
         {style.translucency, weave, row, layer},
         {static_cast<float>(style.weave_kind), style.threads_per_m, weave > 0.0F ? style.unevenness : 0.0F,
          std::clamp(style.sheen_roughness, 0.4F, 1.0F)},
         {linear_light(style.stitch_colour.value_or(Colour{0.0F})), style.stitch_colour ? 1.0F : 0.0F}});
    return layer >= 0.0F;
  };
  bool has_map = false;
  for (const BaseColour& colour : surface.base_colours) has_map = add_one(colour) || has_map;
  if (surface.base_colours.empty()) {
    add_one({style.outside_colour, style.inside_colour.value_or(reverse_colour(style.outside_colour))});
  }
  if (has_map) add_corners(surface);
}

// Earlier triangles without a map get unused corners.
void SurfaceBuffers::add_corners(const SurfaceView& surface) {
  corners_.resize(3 * triangles_.size() - surface.corner_coordinates.size());
  corners_.insert(corners_.end(), surface.corner_coordinates.begin(), surface.corner_coordinates.end());
}

void SurfaceBuffers::add(const SurfaceView& surface, int colour_map_row, BaseColourMapTexture& maps) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  const auto point_area = static_cast<std::uint32_t>(materials_.size());
  if (point_area + surface.base_colours.size() >= max_surfaces) {
    throw ContextError("a frame has more than " + std::to_string(max_surfaces) + " surfaces");
  }
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    vertices_.push_back(
        {{surface.positions[i], 0.0F}, {surface.normals[i], 0.0F}, {vertex_material(surface, i), 0.0F}});
  }
  const std::size_t first_triangle = triangles_.size();
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    const std::uint32_t colour = surface.base_colour_of_triangle.empty() ? 0 : surface.base_colour_of_triangle[i / 3];
    triangles_.emplace_back(first + surface.triangles[i], first + surface.triangles[i + 1],
                            first + surface.triangles[i + 2], point_area + colour);
  }
  for (const TrimmedTriangle& trim : surface.trims) {
    if (trims_.size() >= max_trims) break;
    triangles_[first_triangle + trim.triangle].w += static_cast<std::uint32_t>(trims_.size()) * trim_unit;
    trims_.push_back({trim.corners, {trim.band_m, trim.ribbed ? 1.0F : 0.0F, trim.thickness_m, trim.stitch_m}});
  }
  add_materials(surface, surface.scalars ? static_cast<float>(colour_map_row) : -1.0F, maps);
}

// The rows of numbers are padded to whole rows of texels for the time of the upload.
template <typename Row>
void SurfaceBuffers::upload_rows(const Texture& target, GLint format, std::vector<Row>& rows, unsigned unit) const {
  constexpr std::size_t texels_per_item = std::max<std::size_t>(sizeof(Row) / sizeof(glm::vec4), 1);
  const std::size_t count = rows.size();
  const std::size_t height = count * texels_per_item / texels_per_row + 1;
  if (height > max_rows_) {
    throw ContextError("the surfaces of a frame are too large for this OpenGL: " + std::to_string(height) +
                       " rows of a texture, at most " + std::to_string(max_rows_));
  }
  rows.resize((height * texels_per_row + texels_per_item - 1) / texels_per_item);
  bind_texture(*gl_, unit, GL_TEXTURE_2D, target);
  const bool is_whole = format == GL_RGBA32UI;
  const GLenum channels = is_whole ? GL_RGBA_INTEGER : format == GL_RG32F ? GL_RG : GL_RGBA;
  gl_->TexImage2D(GL_TEXTURE_2D, 0, format, texels_per_row, static_cast<GLsizei>(height), 0, channels,
                  is_whole ? GL_UNSIGNED_INT : GL_FLOAT, rows.data());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_NEAREST);
  rows.resize(count);
}

void SurfaceBuffers::upload() {
  upload_rows(vertex_data_, GL_RGBA32F, vertices_, vertex_data_unit);
  upload_rows(triangle_data_, GL_RGBA32UI, triangles_, triangle_data_unit);
  upload_rows(material_data_, GL_RGBA32F, materials_, material_data_unit);
  if (has_maps()) upload_rows(corner_data_, GL_RG32F, corners_, corner_data_unit);
  upload_rows(trim_data_, GL_RGBA32F, trims_, trim_data_unit);
}

void SurfaceBuffers::bind() const {
  bind_texture(*gl_, vertex_data_unit, GL_TEXTURE_2D, vertex_data_);
  bind_texture(*gl_, triangle_data_unit, GL_TEXTURE_2D, triangle_data_);
  bind_texture(*gl_, material_data_unit, GL_TEXTURE_2D, material_data_);
  if (has_maps()) bind_texture(*gl_, corner_data_unit, GL_TEXTURE_2D, corner_data_);
  bind_texture(*gl_, trim_data_unit, GL_TEXTURE_2D, trim_data_);
}

}  // namespace taut::renderer
