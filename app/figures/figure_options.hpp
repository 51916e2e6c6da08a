#pragma once

#include <filesystem>

#include "prelude.hpp"

namespace taut::app {

/// Which figures are drawn, from what and to where: the options of `taut figures`.
struct FiguresOptions {
  std::vector<std::string> only;  ///< names of figures; empty: all
  std::filesystem::path output = "figures";
  /// Folder with the tables of an earlier run, to draw from without simulating. Empty: simulate.
  std::filesystem::path data;
  float scale = 1.0F;            ///< times as many pixels each way
  std::string backend = "auto";  ///< as in renderer::create_context
};

}  // namespace taut::app
