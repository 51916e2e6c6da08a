#pragma once

#include <filesystem>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Index that stands for no map.
inline constexpr sim::Index no_map = std::numeric_limits<sim::Index>::max();

/// An image in memory. Copies share its pixels.
struct TextureImage {
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
  /// RGBA, 8 bits each: rows from top to bottom, sRGB, alpha not premultiplied. Never null.
  std::shared_ptr<const std::vector<std::uint8_t>> rgba;
};

/// The look of some of a model's faces.
struct SurfaceMaterial {
  std::string name = {};
  glm::vec3 base_colour = glm::vec3(1.0F);  ///< sRGB, 0 to 1
  sim::Index map = no_map;                  ///< index into SurfaceColours::maps; the image replaces the colour
  std::string map_file = {};                ///< image, as the model names it; empty if there is none
  // Members that are used until the images are read.
  glm::vec3 map_tint = glm::vec3(1.0F);  ///< sRGB; factor of the image
  bool map_is_opaque = false;            ///< true if its alpha means nothing
};

/// Texture coordinates and base colours of faces. Coordinates are as in OBJ: u to the right, v up, the image from 0 to
/// 1, repeated beyond.
struct SurfaceColours {
  std::vector<glm::vec2> corner_uv;          ///< one per corner of the faces, or none; (0, 0) where unknown
  std::vector<sim::Index> material_of_face;  ///< indices into `materials`, one per face, or none
  std::vector<SurfaceMaterial> materials;
  std::vector<TextureImage> maps;
  std::vector<std::string> libraries;  ///< files with more on the materials of an OBJ, as it names them
  std::vector<std::string> remarks;    ///< missing images, one line each
  std::vector<std::string> files;      ///< images and libraries that were read
};

/// Returns the colours of `triangles`, into which faces with these corners were cut: each face into two fewer than it
/// has corners, one face after the other.
SurfaceColours cut_colours(SurfaceColours colours, std::span<const std::uint32_t> corner_counts,
                           std::span<const sim::Index> corners, std::span<const sim::Triangle> triangles);

/// Returns the colours of the triangles `after` that were made of `before`. `kept` maps each vertex of `before` to a
/// vertex of `after` (sim/mesh/welding.hpp). Triangles are recognised by their vertices, so that they may have been
/// dropped, turned or moved. New ones have no coordinates and the first material.
SurfaceColours kept_colours(SurfaceColours colours, std::span<const sim::Triangle> before,
                            std::span<const sim::Index> kept, std::span<const sim::Triangle> after);

/// Returns the colours after sim::subdivide made four triangles of each.
SurfaceColours subdivided_colours(SurfaceColours colours);

/// Returns the metres of cloth per unit of texture coordinates: the median over the triangles that have an area in
/// both; 0 if none has.
double metres_per_uv(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv);

/// Returns a channel through the transfer function of sRGB (IEC 61966-2-1) and back; 0 to 1.
inline float srgb_to_linear(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}
inline float linear_to_srgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// Limit on the pixels of an image. Larger images would take longer to read than all else.
inline constexpr std::size_t max_pixels = std::size_t{1} << 26U;
/// Limit on the bytes of all images of a model. Images are halved in size until they keep to it.
inline constexpr std::size_t max_map_bytes = std::size_t{1} << 28U;

/// Limit on the width and height of an image that is laid on a garment by itself.
inline constexpr std::uint32_t max_print_side_px = 8192;

/// Returns the image, halved in size until neither side has more than `max_px` pixels.
TextureImage fitted_to(TextureImage image, std::uint32_t max_px);

/// Decodes an image: PNG, JPEG, BMP, TGA, GIF or PSD. Throws InputError with the reason.
TextureImage decode_image(std::string_view bytes);

/// Function that returns the bytes of an image which a model file itself holds under this name; empty if it holds none.
using EmbeddedImage = std::function<std::optional<std::string_view>(const std::string& name)>;

/// Returns whether a file or a folder, links resolved, is in a folder or below it.
bool is_inside(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Reads the images that the materials name, from the model or from files beside it. `folder` is the model's.
/// An image that is missing or cannot be read becomes a remark, and its material keeps its base colour.
void read_maps(const std::filesystem::path& folder, const EmbeddedImage& embedded, SurfaceColours& colours);

}  // namespace taut::app
