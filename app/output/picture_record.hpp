#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/drawing/drawn_scene_file.hpp"
#include "app/output/frame_record.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// A command line that a shell understands. ASCII only.
std::string command_text(std::span<const std::string> arguments);

/// Where a picture comes from, as PNG texts.
struct PictureOrigin {
  std::string command;
  std::string scene;  ///< scene_text (scene_text.hpp)
  std::string gl_renderer;
};
std::vector<renderer::PngText> picture_texts(const PictureOrigin& origin, const FrameRecord& record);

/// What a picture says about itself.
struct PictureRecord {
  DrawnScene scene;
  int frame = 0;
  std::uint64_t state_hash = 0;
  std::string program;
  std::string gl_renderer;
};

/// Whether the file of this name would be a picture and not a scene or a garment.
bool is_picture(const std::filesystem::path& file);

/// The record in a picture that `taut render` made, with `overrides` applied to its scene. Throws InputError
/// where the file is no PNG, is broken or carries no scene.
PictureRecord read_picture_record(const std::filesystem::path& file, std::span<const Override> overrides);

}  // namespace taut::app
