#pragma once

#include <filesystem>

#include "prelude.hpp"

namespace taut::app {

/// The file that this code is in: the program, or libtaut in a program of someone else. Empty if the system
/// does not say.
std::filesystem::path own_file();

/// The two folders above that of a file, the nearer first: what is installed has its bin, its lib or its
/// lib/ARCH in one of them. None of an empty path.
std::vector<std::filesystem::path> folders_above(const std::filesystem::path& file);

}  // namespace taut::app
