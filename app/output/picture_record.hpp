#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/output/frame_record.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// Words as one line that Bash splits into the same words. ASCII only.
std::string shell_line(std::span<const std::string> words);

/// The program's name and its arguments, as shell_line() writes them.
std::string command_text(std::span<const std::string> arguments);

/// The sources of a picture. They are stored in the picture.
struct PictureOrigin {
  std::string command;  ///< from command_text()
  std::string scene;    ///< from scene_text()
  std::string gl_renderer;
};
/// The PNG texts that store the origin of a picture and what was measured of its frame.
std::vector<renderer::PngText> picture_texts(const PictureOrigin& origin, const FrameRecord& record);

/// The texts of a picture.
struct PictureRecord {
  DrawnScene scene;
  int frame = 0;
  std::uint64_t state_hash = 0;
  std::string program;  ///< name and version of the program that made it
  std::string gl_renderer;
};

/// Whether the file name is that of a picture. Otherwise it means a scene or a garment.
bool is_picture(const std::filesystem::path& file);

/// Reads the record of a picture that `taut render` made, and applies `overrides` to its scene. Throws
/// InputError if the file is not a PNG, is damaged or holds no scene.
PictureRecord read_picture_record(const std::filesystem::path& file, std::span<const Override> overrides);

}  // namespace taut::app
