#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/runs/frame_record.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// Returns the words as one line that Bash splits into the same words, in ASCII.
std::string shell_line(std::span<const std::string> words);

/// Returns the program's name and its arguments in the form of shell_line().
std::string command_text(std::span<const std::string> arguments);

/// Origin of a picture, stored in the picture.
struct PictureOrigin {
  std::string command;  ///< result of command_text()
  std::string scene;    ///< result of scene_text()
  std::string gl_renderer;
};
/// Returns the PNG texts that store a picture's origin and the measurements of its frame.
std::vector<renderer::PngText> picture_texts(const PictureOrigin& origin, const FrameRecord& record);

/// Texts of a picture.
struct PictureRecord {
  DrawnScene scene;
  int frame = 0;
  std::uint64_t state_hash = 0;
  std::string program;  ///< name and version of the program that made the picture
  std::string gl_renderer;
};

/// Returns the PNG text that marks a picture as made by this program.
renderer::PngText program_text();

/// Returns true if the file is a picture that this program made.
bool is_own_picture(const std::filesystem::path& file);

/// Returns a default name for a picture: `name`, or the next free name if another program wrote that file, with a
/// warning on standard error.
std::filesystem::path choose_name(const std::filesystem::path& name);

/// Returns true if this is the file name of a picture. Other names are scenes or garments.
bool is_picture(const std::filesystem::path& file);

/// Reads the record of a picture that `taut render` made, and applies `overrides` to its scene. The scene may name
/// files of the program's assets and of the picture's folder, or any file if the picture is trusted. Throws InputError
/// if the file is not a PNG, is damaged, has no scene, or if its scene names other files.
PictureRecord read_picture_record(const std::filesystem::path& file, std::span<const Override> overrides,
                                  bool is_trusted = false);

}  // namespace taut::app
