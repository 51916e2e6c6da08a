#pragma once

#include <filesystem>
#include <string>

namespace taut::app {

/// Returns why no reader takes the file, and how to save it otherwise, where that can be told from the file:
/// another format of its family, a compression that is not known, or a file that it needs and that is not
/// there. Empty: it cannot be told. Throws nothing if the file cannot be read.
std::string why_unreadable(const std::filesystem::path& path);

}  // namespace taut::app
