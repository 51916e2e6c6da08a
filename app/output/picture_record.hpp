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

/// The PNG text that says that this program made a picture.
renderer::PngText program_text();

/// Returns whether the file is a picture that this program made.
bool is_own_picture(const std::filesystem::path& file);

/// The file of a picture that nobody named: `name`, or the next free one where another program wrote that file, which is
/// then said on the standard error.
std::filesystem::path choose_name(const std::filesystem::path& name);

/// Whether the file name is that of a picture. Otherwise it means a scene or a garment.
bool is_picture(const std::filesystem::path& file);

/// Reads the record of a picture that `taut render` made, and applies `overrides` to its scene, which names files of the
/// program's assets and of the picture's folder, or of the whole machine where it is trusted. Throws InputError if the
/// file is not a PNG, is damaged, holds no scene or one that names other files.
PictureRecord read_picture_record(const std::filesystem::path& file, std::span<const Override> overrides,
                                  bool is_trusted = false);

}  // namespace taut::app
