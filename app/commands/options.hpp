#pragma once

#include "app/figures/figures.hpp"
#include "renderer/context/window.hpp"

namespace taut::app {

// Options of each command. Functions return the exit code of the program.

/// Options of `taut bench`.
struct BenchOptions {
  std::vector<std::string> scenes;  ///< rows of the table; empty: all
  bool contact = false;             ///< all scenes about contact, instead of the quick ones
  bool quick = false;               ///< those that decide about real time, whatever `contact` is
  std::optional<int> runs;          ///< of each scene, each from a start of its own; empty: one, from the scene's
  std::optional<int> frames;        ///< of each run; empty: as the scene has it
  int threads = 1;                  ///< that simulate
  bool csv = false;
  bool quiet = false;
};

/// Options of a run, of `taut render` and `taut simulate` alike.
struct RunOptions {
  std::string scene;   ///< a scene or a garment file
  std::string frames;  ///< as in output_pattern.hpp; empty: what the command usually takes
  std::string shapes;  ///< what to export to (app/caches/frame_sink.hpp); empty: nothing
  std::vector<Override> overrides;
  std::filesystem::path statistics;  ///< file for --stats; empty: none
  bool verify = false;               ///< hold every frame to its promises (frame_verifier.hpp)
};

/// Options of `taut render`. The scene may be a picture that is to be made again; the last frame is drawn, or
/// all frames for a video.
struct RenderOptions : RunOptions {
  std::string output;  ///< empty: SCENE_NAME.png
  bool is_trusted = false;  ///< the picture that is made again may name any file
  std::string backend = "auto";
  /// Arguments of the program. Every picture stores them.
  std::vector<std::string> arguments;
};

/// Options of `taut simulate`. All frames from 1 on are usual.
struct SimulateOptions : RunOptions {
  bool json = false;
  bool quiet = false;
  std::filesystem::path checkpoint;  ///< file the run is saved to; empty: that of `resume`
  int checkpoint_every = 60;         ///< frames from one saving to the next
  std::filesystem::path resume;      ///< file an earlier run was saved to; empty: start of the scene

  /// The file the run is saved to. Empty: it is not saved.
  const std::filesystem::path& saved_to() const { return checkpoint.empty() ? resume : checkpoint; }
};

/// Options of `taut view`.
struct ViewOptions {
  std::string scene;  ///< empty: the script's scene, or else a default
  std::vector<Override> overrides;
  std::optional<renderer::Resized> size;         ///< of the window
  std::optional<sim::SolverKind> compared_with;  ///< of a second garment; empty: that of the script, or none
  std::filesystem::path keep_folder = ".";       ///< for screenshots, videos and saved scenes
  std::filesystem::path record;                  ///< file the input is recorded to; empty: none
  bool headless = false;
  // Headless alone:
  std::filesystem::path script;      ///< session to play
  std::filesystem::path screenshot;  ///< picture of the window after the session; empty: none
  /// Text file that says where the parts of the panel are after the session. Empty: none.
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
  std::string scene;  ///< a garment file, or a scene in which a body is dressed
  std::vector<Override> overrides;
  std::filesystem::path output;  ///< PNG file; empty: SCENE_NAME-fit.png
  int frames = 120;              ///< the most after it was put on; fewer if it is at rest before
  bool json = false;
  std::string backend = "auto";
};

/// Options of `taut sew`.
struct SewOptions {
  std::filesystem::path pattern;
  std::vector<std::filesystem::path> over;  ///< patterns that are worn over it, inner ones first
  std::vector<std::string> over_fabrics;    ///< of these, one for each or none
  std::vector<Override> overrides;
  std::filesystem::path output;   ///< OBJ file; empty: PATTERN.obj
  std::filesystem::path picture;  ///< PNG file; empty: none, but for one of what cannot be sewn
  std::filesystem::path steps;    ///< PNG file; empty: none
  int triangles = 4000;           ///< about so many
  bool is_exact = false;          ///< exactly so many
  int frames = 600;               ///< at most, from when it is worn until it rests
  bool json = false;
  std::string backend = "auto";
};

/// Options of `taut import-model`, which the program runs as a child process (import_process.hpp).
struct ImportModelOptions {
  std::filesystem::path model;
  ImportLimits limits;
  int parts = 0;  ///< a ReadParts
};

/// Makes the folder of a picture. Throws UsageError unless its name ends in .png.
void prepare_png(const std::filesystem::path& file);

/// Each `run` does one command and returns the exit code of the program (errors.hpp). Throws InputError,
/// UsageError, Interrupted and what the parts it uses throw.
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
/// Prints this scene with all keys, as a scene file, or where it is empty a list of all.
int list_scenes(const std::string& scene);
/// Prints the file of this fabric, or where it is empty a table of all.
int list_fabrics(const std::string& fabric);

}  // namespace taut::app
