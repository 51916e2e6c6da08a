#pragma once

#include <filesystem>
#include <span>

#include "renderer/page/image.hpp"

namespace taut::tests {

/// Any PNG as `channels` (3 or 4) bytes a pixel, by a reader that is none of ours. Throws std::runtime_error
/// with the path and the reason.
renderer::Image read_png(const std::filesystem::path& path, int channels = 3);
renderer::Image decode_png(std::span<const std::uint8_t> bytes, int channels = 3);

}  // namespace taut::tests
