#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace taut::renderer {

/// Writes all bytes under a temporary name in the same folder, then renames: readers see the old file or the
/// complete new one. Throws std::runtime_error with the path and the system's reason, and leaves nothing
/// behind.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace taut::renderer
