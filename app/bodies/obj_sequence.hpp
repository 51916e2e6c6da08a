#pragma once

#include <filesystem>
#include <memory>

#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// Returns whether the name means a sequence of OBJ files: a folder, or a pattern such as body-%04d.obj.
bool names_obj_sequence(const std::filesystem::path& name);

/// Opens a sequence of OBJ files, a frame each, in the order of the numbers at the ends of their names. They
/// must have the same number of vertices, in the same order. Files are read as frames are asked for. Throws
/// InputError that names the folder or the file: without numbered files, or where a number is missing.
std::unique_ptr<const FrameSource> open_obj_sequence(const std::filesystem::path& name);

}  // namespace taut::app
