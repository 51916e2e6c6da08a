#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/models/import_process.hpp"
#include "app/scene/scene_file.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::app {

// What each command was asked for. Functions return the exit code of the program.

struct FiguresOptions {
  std::vector<std::string> only;  ///< empty: all
  std::filesystem::path output = "figures";
  std::filesystem::path data;  ///< folder of an earlier run's tables to draw from; empty: simulate
  float scale = 1.0F;
  std::string backend = "auto";
};

struct BenchOptions {
  std::vector<int> sizes;  ///< triangles; empty, as everything here: as `full` says
  std::vector<std::string> scenes;
  std::vector<double> bounds = {0.05, 0.01, 0.001};
  std::vector<std::string> engines;
  std::optional<double> seconds;           ///< simulated
  std::optional<double> slowest_frame_ms;  ///< settings that need more are given up
  bool full = false;
  bool ablation = false;
  bool json = false;
  bool quiet = false;
  std::filesystem::path output;  ///< folder for the results; empty: none
  std::filesystem::path shapes;  ///< folder for the most stretched shape of every run; empty: none
};

struct RenderOptions {
  std::string scene;   ///< or a picture that is to be made again
  std::string output;  ///< empty: SCENE_NAME.png
  std::string frames;  ///< as in frame_range.hpp; empty: the last, of a video all
  std::vector<Override> overrides;
  std::filesystem::path statistics;
  std::string backend = "auto";
  bool resume = false;                 ///< only the frames that are not there yet
  std::vector<std::string> arguments;  ///< as given to the program but for --resume; every picture keeps them
};

struct SimulateOptions {
  std::string scene;
  std::string frames;  ///< as in frame_range.hpp; empty: all from 1 on
  std::string shapes;  ///< pattern of OBJ files, or one for the last frame; empty: none
  bool json = false;
  bool quiet = false;
  std::vector<Override> overrides;
  std::filesystem::path statistics;
  std::filesystem::path checkpoint;  ///< where the run is saved; empty: to `resume`, if that is given
  int checkpoint_every = 60;         ///< frames
  std::filesystem::path resume;      ///< what an earlier run saved; empty: from the scene's start

  /// Empty: the run is not saved.
  const std::filesystem::path& saved_to() const { return checkpoint.empty() ? resume : checkpoint; }
};

struct ViewOptions {
  std::string scene;  ///< empty: the script's, or the first there is
  std::vector<Override> overrides;
  std::optional<renderer::Resized> size;
  std::filesystem::path keep_folder = ".";
  std::filesystem::path record;  ///< where the input is written to; empty: nowhere
  bool headless = false;
  // Headless alone:
  std::filesystem::path script;
  std::filesystem::path screenshot;
  std::filesystem::path layout;
  std::string backend = "auto";
};

struct InspectOptions {
  std::filesystem::path garment;
  std::vector<Override> overrides;
  bool json = false;
  std::filesystem::path picture;  ///< empty: none
  std::string backend = "auto";
};

/// The program as its own importer (import_process.hpp).
struct ImportModelOptions {
  std::filesystem::path model;
  ImportLimits limits;
};

struct ScenesOptions {};

struct HelpOptions {
  std::string text;  ///< what there is to say
};

/// The command line was answered by itself, as --version is.
struct Answered {
  int exit_code = 0;
};

using Command = std::variant<Answered, BenchOptions, FiguresOptions, RenderOptions, SimulateOptions,
                             ViewOptions, InspectOptions, ImportModelOptions, ScenesOptions, HelpOptions>;

int run(const BenchOptions& options);
int run(const FiguresOptions& options);
int run(const RenderOptions& options);
int run(const SimulateOptions& options);
int run(const ViewOptions& options);
int run(const InspectOptions& options);
int run(const ImportModelOptions& options);
int run(const ScenesOptions& options);
int run(const HelpOptions& options);
inline int run(const Answered& answered) {
  return answered.exit_code;
}

}  // namespace taut::app
