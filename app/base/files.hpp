#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace taut::app {

/// The whole file. Throws InputError naming the file and the reason: missing, a folder, unreadable, empty.
std::string read_text_file(const std::filesystem::path& path);

/// Throws InputError unless there is a file with something in it.
void require_file(const std::filesystem::path& path);

/// Makes the folder a file shall be written to, parents included, and tries that it can be written to, so
/// that a long run does not end in an error. Throws InputError naming the folder and the system's reason.
void prepare_folder_of(const std::filesystem::path& file);

/// Writes under a temporary name in the same folder and renames: `path` is absent, its old self or complete.
/// Throws InputError naming the path and the system's reason and leaves nothing behind.
void write_text_file(const std::filesystem::path& path, const std::string& text);
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace taut::app
