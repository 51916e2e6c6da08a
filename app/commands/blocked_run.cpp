#include "app/commands/blocked_run.hpp"

#include <fmt/core.h>

#include <exception>
#include <functional>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/blocked_picture.hpp"
#include "app/output/output_pattern.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

std::filesystem::path folder_beside(const std::string& pattern, int frame) {
  const std::filesystem::path name = pattern;
  const bool is_sequence = pattern.find('{') != std::string::npos;
  return is_sequence ? OutputPattern(pattern, name.extension().string()).path_of(frame).parent_path() : "";
}

[[noreturn]] void end_with(const FrameBlocked& error, const std::string& pattern,
                           const std::function<renderer::Image()>& draw) {
  std::string shown;
  try {
    const std::filesystem::path file = free_name(folder_beside(pattern, error.frame), "blocked", ".png");
    prepare_folder_of(file);
    write_file(file, renderer::encode_png(draw()));
    shown = fmt::format("'{}' shows where, in the frame before", file.string());
  } catch (const std::exception& reason) {
    shown = fmt::format("there is no picture of it: {}", reason.what());
  }
  throw PromiseBroken(
      fmt::format("{}; {}; solver.allow_exceeding = \"contact\" goes on all the same", error.what(), shown));
}

}  // namespace

void end_blocked(const FrameBlocked& error, const DrawnScene& scene, const sim::Simulation& simulation,
                 const std::string& pattern, OffscreenRenderer& offscreen) {
  end_with(error, pattern, [&] {
    return draw_blocked(offscreen.renderer(), scene, simulation, error.blocked, error.what());
  });
}

void end_blocked(const FrameBlocked& error, const DrawnScene& scene, const sim::Simulation& simulation,
                 const std::string& pattern) {
  end_with(error, pattern, [&] {
    OffscreenRenderer offscreen("auto");
    return draw_blocked(offscreen.renderer(), scene, simulation, error.blocked, error.what());
  });
}

}  // namespace taut::app
