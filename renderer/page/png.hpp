#pragma once

#include "renderer/page/image.hpp"

namespace taut::renderer {

/// One PNG tEXt entry, e.g. {"Software", "taut 0.1.0"}. Keyword: 1 to 79 Latin-1 characters.
struct PngText {
  std::string keyword;
  std::string text;
};

/// Returns a PNG file. The same image gives the same bytes. Throws std::invalid_argument for an empty image,
/// a wrong number of pixels or a bad keyword.
std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts = {});

/// Returns the tEXt entries of a PNG file. `name` stands in messages. Throws std::runtime_error when it is no
/// PNG or a broken one.
std::vector<PngText> read_png_texts(std::span<const std::uint8_t> png, const std::string& name);

}  // namespace taut::renderer
