#pragma once

#include "app/figures/figures.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "renderer/context/window.hpp"

namespace taut::app {

// Options of each command.

/// Options of `taut bench`.
struct BenchOptions {
  std::vector<std::string> scenes;  ///< names of cases; empty: all
  bool contact = false;             ///< all cases with contact instead of the quick ones
  bool quick = false;               ///< only the cases that decide about real time, even if `contact` is set
  std::optional<int> runs;          ///< runs of each scene, each from another random start; empty: one, from the
                                    ///< scene's start
  std::optional<int> frames;        ///< frames of each run; empty: as many as the scene has
  int threads = 1;                  ///< threads of the solver
  bool csv = false;
  bool quiet = false;
};

/// Options that `taut render` and `taut simulate` share.
struct RunOptions {
  std::string scene;   ///< name of a scene, or a garment file
  std::string frames;  ///< written as in output_pattern.hpp; empty: the command's default
  std::string shapes;  ///< file to export shapes to (app/caches/frame_sink.hpp); empty: none
  std::vector<Override> overrides;
  std::filesystem::path statistics;  ///< file for --stats; empty: none
  bool verify = false;               ///< verifies the promises of every frame (frame_verifier.hpp)
};

/// Options of `taut render`. The scene may also be a picture to make again. The default is to draw the last frame, or
/// for a video all frames.
struct RenderOptions : RunOptions {
  std::string output;       ///< empty: SCENE_NAME.png
  bool is_trusted = false;  ///< lets the scene of a picture that is made again open any file
  std::string backend = "auto";
  /// Arguments of the program, which every picture stores.
  std::vector<std::string> arguments;
};

/// Options of `taut simulate`. The default is all frames from 1.
struct SimulateOptions : RunOptions {
  bool json = false;
  bool quiet = false;
  std::filesystem::path checkpoint;  ///< file to save the run to; empty: the file `resume`
  int checkpoint_every = 60;         ///< frames between two checkpoints
  std::filesystem::path resume;      ///< file that an earlier run was saved to; empty: the scene's start

  /// Returns the file to save the run to; empty: the run is not saved.
  const std::filesystem::path& checkpoint_file() const { return checkpoint.empty() ? resume : checkpoint; }
};

/// Options of `taut view`.
struct ViewOptions {
  std::string scene;  ///< empty: the script's scene, or else the default scene
  std::vector<Override> overrides;
  std::optional<renderer::Resized> size;         ///< window size
  std::optional<sim::SolverKind> compared_with;  ///< solver of a second garment; empty: the script's, or none
  std::filesystem::path keep_folder = ".";       ///< folder for screenshots, videos and saved scenes
  std::filesystem::path record;                  ///< file to record the input to; empty: none
  bool headless = false;
  // The members below are for `headless` only.
  std::filesystem::path script;      ///< recorded session to play
  std::filesystem::path screenshot;  ///< picture of the window after the session; empty: none
  /// Text file for the positions of the panel's controls after the session; empty: none.
  std::filesystem::path layout;
  std::string backend = "auto";
};

/// Options of `taut inspect`.
struct InspectOptions {
  std::filesystem::path garment;
  std::vector<Override> overrides;
  bool json = false;
  std::filesystem::path picture;  ///< empty: none
  std::string backend = "auto";
};

/// Options of `taut fit`.
struct FitOptions {
  std::string scene;  ///< garment file, or a scene with a dressed body
  std::vector<Override> overrides;
  std::filesystem::path output;  ///< PNG file; empty: SCENE_NAME-fit.png
  int frames = 120;              ///< most frames after dressing; the run ends earlier if the cloth is at rest
  bool json = false;
  std::string backend = "auto";
};

/// Options of `taut sew`.
struct SewOptions {
  std::filesystem::path pattern;
  std::vector<std::filesystem::path>
      outer_patterns;                      ///< patterns of the garments over this one, from inside to outside
  std::vector<std::string> outer_fabrics;  ///< fabrics of `over`, one for each pattern, or none
  std::vector<Override> overrides;
  std::filesystem::path output;                ///< OBJ file; empty: PATTERN.obj
  std::filesystem::path picture;               ///< PNG file; empty: none, except for a picture of what cannot be sewn
  std::filesystem::path steps;                 ///< PNG file; empty: none
  int triangles = SewingSettings().triangles;  ///< approximate number of triangles
  bool is_exact = false;                       ///< makes exactly `triangles` triangles
  int frames = SewingSettings().frames;        ///< largest count, from the start of wearing until rest
  bool json = false;
  std::string backend = "auto";
};

/// Options of `taut import-model`, which the program runs as a child process (import_process.hpp).
struct ImportModelOptions {
  std::filesystem::path model;
  ImportLimits limits;
  int parts = 0;  ///< value of ReadParts
};

/// Makes the folder of a picture. Throws UsageError unless its name ends in .png.
void prepare_png(const std::filesystem::path& file);

/// Runs a command and returns the exit code of the program (errors.hpp). Throws InputError, UsageError, Interrupted and
/// the exceptions of the parts that it uses.
int run(const BenchOptions& options);
int run(const FiguresOptions& options);
int run(const RenderOptions& options);
int run(const SimulateOptions& options);
int run(const ViewOptions& options);
int run(const InspectOptions& options);
int run(const FitOptions& options);
int run(const SewOptions& options);
inline int run(const ImportModelOptions& options) {
  serve_import(options.model, options.limits, static_cast<ReadParts>(options.parts));
}
/// Prints a scene with all its keys as a scene file. Without a name, lists all scenes.
int list_scenes(const std::string& scene);
/// Prints the file of a fabric. Without a name, prints a table of all fabrics.
int list_fabrics(const std::string& fabric);

}  // namespace taut::app
