#pragma once

#include <filesystem>
#include <span>

#include "renderer/page/png.hpp"

namespace taut::tests {

/// Reads a PNG file with `channels` (3 or 4) bytes per pixel, with another library than the program's. Throws
/// std::runtime_error with the path and the reason.
renderer::Image read_png(const std::filesystem::path& path, int channels = 3);
/// Reads a PNG from memory, as read_png does.
renderer::Image decode_png(std::span<const std::uint8_t> bytes, int channels = 3);

}  // namespace taut::tests
