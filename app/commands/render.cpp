#include <unistd.h>

#include "app/base/words.hpp"
#include "app/commands/run.hpp"
#include "app/output/picture_record.hpp"
#include "app/output/video_writer.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::app {
namespace {

constexpr std::string_view standard_output = "-";

// A picture to draw, from a scene or from an earlier picture.
struct RenderJob {
  DrawnScene scene;
  std::vector<int> frames;
  std::string output;
  std::optional<PictureRecord> again;  ///< record of the earlier picture
  Descriptor pipe;                     ///< standard output, if the picture goes there
};

/// Takes standard output for the picture. What the program says goes to standard error from now on.
Descriptor take_standard_output() {
  if (::isatty(STDOUT_FILENO) != 0) {
    throw UsageError("--output -: standard output is a terminal; expected a file or a pipe");
  }
  Descriptor pipe(::dup(STDOUT_FILENO));
  if (pipe.number() < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    throw InputError("cannot write to standard output: " + std::generic_category().message(errno));
  }
  return pipe;
}

std::vector<int> frames_to_draw(const RenderOptions& options, const RenderJob& job) {
  const int last = job.again ? job.again->frame : job.scene.frames;
  const int first = is_video(job.output) && !job.again ? 0 : last;
  const bool is_played = is_video(job.output) || is_clip(options.shapes);
  const FrameRange range = options.frames.empty() ? FrameRange{first, last}
                                                  : frame_range(options.frames, job.scene.frames,
                                                                is_played ? NumberMeans::count : NumberMeans::frame);
  std::vector<int> frames(static_cast<std::size_t>(range.count()));
  std::iota(frames.begin(), frames.end(), range.first);
  return frames;
}

/// Prints the files that the scene of a picture opens.
void print_files(const std::string& picture, const DrawnScene& scene) {
  for (const std::filesystem::path& file : input_files(scene)) {
    std::error_code error;
    if (file == picture || !std::filesystem::exists(file, error)) continue;
    fmt::print("{}: its scene opens '{}'\n", picture, printable(file.string()));
  }
}

RenderJob make_render_job(const RenderOptions& options) {
  RenderJob job;
  if (options.output == standard_output) job.pipe = take_standard_output();
  if (is_picture(options.scene)) {
    job.again = read_picture_record(options.scene, options.overrides, options.is_trusted);
    job.scene = job.again->scene;
    print_files(options.scene, job.scene);
  } else {
    job.scene = find_scene(options.scene, options.overrides);
  }
  // The default name of a picture that is made again differs from the picture's own.
  const std::string name = job.scene.name + (job.again ? "-again.png" : ".png");
  job.output = options.output.empty() ? choose_name(name).string() : options.output;
  job.frames = frames_to_draw(options, job);
  return job;
}

// Writes one file for each picture, or one video.
class PictureOutput {
 public:
  explicit PictureOutput(const RenderJob& job) : name_(job.output), pipe_(job.pipe.number()) {
    const std::filesystem::path file = job.output;
    if (file == standard_output) {
      if (job.frames.size() == 1) return;
      throw UsageError("--output -: found {}, expected one picture for standard output",
                       count_text(job.frames.size(), "frame"));
    }
    if (is_video(file)) {
      if (job.scene.picture.background.kind == BackgroundKind::transparent) {
        throw UsageError("output '" + job.output + "': a video has no transparency; choose another picture.background");
      }
      const renderer::PictureSettings& size = job.scene.picture.settings;
      const VideoSettings settings{size.width_px, size.height_px, job.scene.simulation.frame_rate_hz};
      require_video_size(file, settings);
      prepare_parent_folder(file);
      video_ = std::make_unique<VideoWriter>(file, settings);
      return;
    }
    if (file.extension() != ".png") {
      throw UsageError("output '" + job.output + "': expected a file name that ends in .png, .mp4, .gif or .webp");
    }
    pattern_.emplace(job.output, ".png");
    pattern_->require_distinct_names(job.frames.size());
    prepare_parent_folder(pattern_->path_of(job.frames.front()));
  }

  /// Returns every file that will be written.
  std::vector<std::filesystem::path> files(std::span<const int> frames) const {
    std::vector<std::filesystem::path> files;
    if (video_) return {name_};
    if (!pattern_) return {};
    for (const int frame : frames) files.push_back(pattern_->path_of(frame));
    return files;
  }

  void write(const PictureOrigin& origin, const FrameRecord& record, const renderer::Image& picture) {
    if (video_) {
      video_->add(picture);
    } else if (const std::vector<std::uint8_t> png = renderer::encode_png(picture, picture_texts(origin, record));
               pattern_) {
      write_file(pattern_->path_of(record.frame), png);
    } else if (!write_bytes(pipe_, png)) {
      fail_to_write(name_, std::generic_category().message(errno));
    }
    written_.push_back(record.frame);
  }

  /// Keeps and reports the pictures of a run that ends early. Prints a warning if the video cannot be finished.
  void keep() {
    try {
      fmt::print("{}", written_.empty() ? "" : finish() + '\n');
    } catch (const InputError& reason) {
      fmt::print(stderr, "taut: warning: {}\n", reason.what());
    }
  }

  /// Completes the output and returns a message about it.
  std::string finish() {
    if (pattern_) return describe_written(*pattern_, written_);
    if (video_) video_->finish();
    return fmt::format("wrote {}, {}", name_, count_text(written_.size(), "frame"));
  }

 private:
  std::string name_;
  int pipe_ = -1;  ///< descriptor for the picture if it has no file
  std::optional<OutputPattern> pattern_;
  std::unique_ptr<VideoWriter> video_;
  std::vector<int> written_;
};

// Warns of differences: the program, the garment's file or OpenGL may have changed since the picture was made.
void compare_with_record(const PictureRecord& again, const std::vector<FrameRecord>& records,
                         const std::string& gl_renderer) {
  const auto same_frame = std::ranges::find(records, again.frame, &FrameRecord::frame);
  if (same_frame != records.end() && same_frame->state_hash != again.state_hash) {
    fmt::print(stderr,
               "taut: warning: the cloth is not where it was in the picture (state {:016x}, then {:016x}): "
               "made by {}, or from another garment file\n",
               same_frame->state_hash, again.state_hash, printable(again.program));
  }
  if (gl_renderer != again.gl_renderer) {
    fmt::print(stderr, "taut: warning: drawn by '{}', then by '{}': pixels may differ\n", gl_renderer,
               printable(again.gl_renderer));
  }
}

// Returns true if the positions of all frames fit into a gibibyte, so that they can be kept until the camera is fitted.
bool can_gather(std::size_t frames, std::size_t vertices) {
  constexpr std::size_t max_bytes = std::size_t{1} << 30U;
  return frames * vertices * sizeof(sim::Vec3) <= max_bytes;
}

/// Runs a scene and draws its pictures.
class Render {
 public:
  Render(const RenderOptions& options, const RenderJob& job, const std::string& why_not_model)
      : options_(options), run_(options, job.scene, stdout, why_not_model), job_(job), output_(job_) {}

  /// Returns the exit code.
  int go() {
    const ExportSettings exported = {.name = options_.shapes,
                                     .frames = {job_.frames.front(), job_.frames.back()},
                                     .frame_rate_hz = run_.scene.simulation.frame_rate_hz,
                                     .look = run_.scene.picture.cloth};
    std::vector<std::filesystem::path> claimed;
    if (job_.output != standard_output) claimed.emplace_back(job_.output);
    run_.require_outputs(exported, output_.files(job_.frames), std::move(claimed));
    // Starts OpenGL meanwhile: that and compiling shaders take as long as reading a model.
    run_.load([this] {
      offscreen_.emplace(options_.backend);
      const PictureStyle& style = run_.scene.picture;
      offscreen_->renderer().prepare(to_picture_settings(style), style.surface == SurfaceLook::stretch);
    });
    face_front(run_.loaded, run_.scene);
    colours_ = drawn_colours(run_.scene, run_.loaded);
    for (const std::string& remark : colours_.remarks) {
      fmt::print(stderr, "taut: warning: {}: {}\n", run_.scene.garment.file.filename().string(), printable(remark));
    }
    run_.open_statistics({run_.scene, run_.simulation->garment(), run_.simulation->pins().vertices.size(),
                          offscreen_->gl_renderer(), options_.verify},
                         std::nullopt);
    if (!options_.shapes.empty()) run_.shapes = open_sink(exported, run_.loaded, run_.simulation->state().current);
    run_.progress.begin("preparing the first frame");
    connect();
    const std::vector<FrameRecord> records = run_.go(job_.frames.back(), job_.output, &*offscreen_);
    run_.progress.hide();
    return finish(records);
  }

 private:
  void begin_drawing() {
    painter_.emplace(offscreen_->renderer(), run_.scene, run_.simulation->garment(), run_.bodies.all,
                     run_.simulation->pins().vertices, colours_);
    offscreen_->renderer().set_pass_report([this, since_first = Stopwatch()](int done, int all) mutable {
      if (done == 1) since_first = Stopwatch();
      run_.progress.show(
          fmt::format("drawing, pass {} of {}{}", done, all, time_left(1e-3 * since_first.elapsed_ms(), done, all)));
      throw_if_interrupted();
    });
    origin_ = {command_text(options_.arguments), scene_text(run_.scene), offscreen_->gl_renderer()};
  }

  // Adds a row of statistics and shows progress. If the camera is fitted, all frames are simulated before the first is
  // drawn; their rows are then added when they are simulated.
  void report(const std::string& done, const FrameRecord& record) {
    const int last = job_.frames.back();
    if (run_.statistics && done != "drawn") run_.statistics->add(record);
    run_.progress.show(fmt::format("frame {} of {}{}{}{}, stretch {:.2f} %, of the surface {:.2f} %", record.frame,
                                   last, done.empty() ? "" : " ", done,
                                   time_left(1e-3 * since_start_.elapsed_ms(), record.frame, last),
                                   100.0 * record.stretch.max, 100.0 * record.surface_stretch.max));
  }

  void fit_camera(std::span<const FrameInWork> gathered) {
    FittedView fitted(run_.scene, run_.simulation->garment(), run_.bodies.all);
    for (const FrameInWork& frame : gathered) {
      if (frame.positions.empty()) continue;
      fitted.add(frame.positions, frame.shown_m.empty() ? frame.positions : frame.shown_m, frame.record.time_s);
    }
    fitted.place_camera(run_.scene);
    begin_drawing();
  }

  // Moves the simulation to its start frame and connects the outputs.
  void connect() {
    FrameOutputs& outputs = run_.outputs;
    const bool is_gathered =
        is_fitted(run_.scene) && can_gather(job_.frames.size(), run_.loaded.shown_mesh().positions.size());
    if (is_gathered) {
      outputs.before_drawing = [this](std::span<const FrameInWork> gathered) { fit_camera(gathered); };
      outputs.simulated = [this](const FrameRecord& record) { report("simulated", record); };
    } else {
      begin_drawing();
    }
    outputs.report = [this, is_gathered](const FrameRecord& record) { report(is_gathered ? "drawn" : "", record); };
    outputs.pictures = job_.frames;
    outputs.draw = [this](const FrameInWork& frame) {
      return painter_->draw(frame.positions, frame.record.time_s, frame.shown_m);
    };
    outputs.write_frame = [this](const FrameRecord& record, const renderer::Image& picture) {
      output_.write(origin_, record, picture);
    };
    run_.on_early_end = [this] { output_.keep(); };
    outputs.start_frame = run_.begin();
    require_not_before_start(outputs.start_frame, job_.frames.front());
    outputs.with_start = run_.shapes && outputs.start_frame == job_.frames.front();
  }

  int finish(const std::vector<FrameRecord>& records) {
    RunSummary summary;
    for (const FrameRecord& record : records) summary.add(record);
    run_.progress.begin("finishing " + job_.output);
    const std::string written = output_.finish() + '\n' + run_.finish_shapes();
    run_.progress.hide();
    if (job_.again && options_.overrides.empty()) compare_with_record(*job_.again, records, offscreen_->gl_renderer());
    if (run_.statistics) {
      run_.statistics->finish(summary);
      fmt::print("wrote {}\n", options_.statistics.string());
    }
    fmt::print("{}{}", written, options_.verify ? run_.verifier.summary() + '\n' : "");
    for (const std::string& line : {describe_crossings(summary), run_.describe_shown()}) {
      fmt::print("{}", line.empty() ? "" : line + '\n');
    }
    return judge_bound(run_.scene, summary);
  }

  const RenderOptions& options_;
  SceneRun run_;
  const RenderJob& job_;
  PictureOutput output_;
  std::optional<OffscreenRenderer> offscreen_;
  DrawnColours colours_;
  std::optional<GarmentPainter> painter_;
  PictureOrigin origin_;
  Stopwatch since_start_;
};

}  // namespace

int run(const RenderOptions& options) {
  const RenderJob job = make_render_job(options);
  return run_showing_what_fits(
      [&](const std::string& why_not_model) { return Render(options, job, why_not_model).go(); });
}

}  // namespace taut::app
