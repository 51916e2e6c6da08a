#pragma once

#include <filesystem>

#include "app/models/surface_colours.hpp"

namespace taut::app {

/// Limit on the pixels of an image. Larger ones would take longer to read than all else.
inline constexpr std::size_t most_pixels = std::size_t{1} << 26U;
/// Limit on the bytes of all images of a model; they are halved in size until they keep to it.
inline constexpr std::size_t most_map_bytes = std::size_t{1} << 28U;

/// Limit on the width and height of an image that is laid on a garment by itself.
inline constexpr std::uint32_t most_print_side_px = 8192;

/// Returns the image, halved in size until neither side has more pixels.
TextureImage fitted_to(TextureImage image, std::uint32_t most_px);

/// Decodes an image: PNG, JPEG, BMP, TGA, GIF or PSD. Throws InputError with the reason.
TextureImage decode_image(std::string_view bytes);

/// The bytes of an image that a model file itself holds under this name; empty if it holds none.
using EmbeddedImage = std::function<std::optional<std::string_view>(const std::string& name)>;

/// Reads the images that the materials name, from the model or from files beside it. `folder` is the model's.
/// An image that is missing or cannot be read becomes a remark, and its material keeps its base colour.
void read_maps(const std::filesystem::path& folder, const EmbeddedImage& embedded, SurfaceColours& colours);

}  // namespace taut::app
