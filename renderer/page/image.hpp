#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace taut::renderer {

/// Pixels in memory: rows from top to bottom, without padding, `channels` bytes each. Colour is sRGB-encoded,
/// alpha (if there is one) is straight, not premultiplied.
struct Image {
  int width_px = 0;
  int height_px = 0;
  int channels = 3;  ///< 3 = RGB, 4 = RGBA
  std::vector<std::uint8_t> pixels;

  std::uint8_t* at(int x_px, int y_px) { return pixels.data() + offset(x_px, y_px); }
  const std::uint8_t* at(int x_px, int y_px) const { return pixels.data() + offset(x_px, y_px); }

 private:
  std::size_t offset(int x_px, int y_px) const {
    return (static_cast<std::size_t>(y_px) * static_cast<std::size_t>(width_px) +
            static_cast<std::size_t>(x_px)) *
           static_cast<std::size_t>(channels);
  }
};

/// A black (and, with four channels, transparent) image. Throws std::invalid_argument unless both sizes are
/// positive and there are 3 or 4 channels.
Image make_image(int width_px, int height_px, int channels = 3);

/// One PNG tEXt entry, e.g. {"Software", "taut 0.1.0"}. Keyword: 1 to 79 Latin-1 characters.
struct PngText {
  std::string keyword;
  std::string text;
};

/// What trades time against size. The defaults suit a sequence of frames; both give the same pixels.
struct PngEffort {
  int deflate_level = 1;  ///< 0 to 12 (libdeflate)
  int filter = 1;         ///< 0 none, 1 sub, 2 up, 3 average, 4 paeth, -1 the best for each row (slow)
};

/// The same image gives the same bytes. Throws std::invalid_argument for an empty image, a wrong number of
/// pixels or a bad keyword.
std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts = {},
                                     PngEffort effort = {});

/// Writes under a temporary name in the same folder and renames, so that `path` is either absent, its old
/// self or complete. Throws std::runtime_error naming the path and the system's reason, and leaves nothing
/// behind.
void write_png(const std::filesystem::path& path, const Image& image, std::span<const PngText> texts = {},
               PngEffort effort = {});

/// Reads any PNG as `channels` (3 or 4) bytes a pixel. Throws std::runtime_error naming the path and the
/// reason.
Image read_png(const std::filesystem::path& path, int channels = 3);

/// As read_png, from memory.
Image decode_png(std::span<const std::uint8_t> bytes, int channels = 3);

}  // namespace taut::renderer
