#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <memory>
#include <numeric>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/base/stopwatch.hpp"
#include "app/base/version.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/commands/blocked_run.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/drawing/fitted_view.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/drawing/offscreen_renderer.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/models/model_fitting.hpp"
#include "app/output/frame_record.hpp"
#include "app/output/output_pattern.hpp"
#include "app/output/frame_verifier.hpp"
#include "app/output/picture_record.hpp"
#include "app/output/run_start.hpp"
#include "app/output/run_report.hpp"
#include "app/output/video_writer.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

// The subject of the picture, whether a scene was given or a picture.
struct RenderJob {
  DrawnScene scene;
  std::vector<int> frames;
  std::string output;
  std::optional<PictureRecord> again;  ///< the picture that is made again
};

std::vector<int> frames_to_draw(const RenderOptions& options, const RenderJob& job) {
  const int last = job.again ? job.again->frame : job.scene.frames;
  const int first = is_video(job.output) && !job.again ? 0 : last;
  const bool is_played = is_video(job.output) || is_clip(options.shapes);
  const FrameRange range = options.frames.empty()
                               ? FrameRange{first, last}
                               : frame_range(options.frames, job.scene.frames,
                                             is_played ? NumberMeans::count : NumberMeans::frame);
  std::vector<int> frames(static_cast<std::size_t>(range.count()));
  std::iota(frames.begin(), frames.end(), range.first);
  return frames;
}

RenderJob render_job_of(const RenderOptions& options) {
  RenderJob job;
  if (is_picture(options.scene)) {
    job.again = read_picture_record(options.scene, options.overrides);
    job.scene = job.again->scene;
  } else {
    job.scene = find_scene(options.scene, options.overrides);
  }
  print_body_remarks(job.scene, load_bodies(job.scene), stdout);
  // Made again, a picture never takes the place of the one it is made from unasked.
  const std::string name = job.scene.name + (job.again ? "-again.png" : ".png");
  job.output = options.output.empty() ? name : options.output;
  job.frames = frames_to_draw(options, job);
  return job;
}

// Where pictures go: a file each, or one video.
class PictureOutput {
 public:
  explicit PictureOutput(const RenderJob& job) : job_(job) {
    const std::filesystem::path file = job.output;
    if (is_video(file)) {
      if (job.scene.picture.background.kind == BackgroundKind::transparent) {
        throw UsageError("output '" + job.output +
                         "': a video has no transparency; choose another picture.background");
      }
      const renderer::PictureSettings& size = job.scene.picture.settings;
      const VideoSettings settings{size.width_px, size.height_px, job.scene.simulation.frame_rate_hz};
      require_video_size(file, settings);
      prepare_folder_of(file);
      video_ = std::make_unique<VideoWriter>(file, settings);
      return;
    }
    if (file.extension() != ".png") {
      throw UsageError("output '" + job.output + "': expected a file name that ends in .png, .mp4 or .gif");
    }
    pattern_.emplace(job.output, ".png");
    pattern_->require_distinct_names(job.frames.size());
    prepare_folder_of(pattern_->path_of(job.frames.front()));
  }

  void write(const PictureOrigin& origin, const FrameRecord& record, const renderer::Image& picture) {
    if (video_) {
      video_->add(picture);
    } else {
      write_file(pattern_->path_of(record.frame),
                 renderer::encode_png(picture, picture_texts(origin, record)));
    }
    written_.push_back(record.frame);
  }

  /// Throws UsageError where there is one file for all frames.
  std::filesystem::path path_of(int frame) const {
    if (video_) {
      throw UsageError("--resume continues a sequence of pictures, and '" + job_.output + "' is a video");
    }
    return pattern_->path_of(frame);
  }

  /// Of a run that ends early: keeps and says what was drawn. Why there is no video is said beside what ended
  /// the run.
  void keep() {
    try {
      fmt::print("{}", written_.empty() ? "" : finish() + '\n');
    } catch (const InputError& reason) {
      fmt::print(stderr, "taut: warning: {}\n", reason.what());
    }
  }

  /// Says what was written.
  std::string finish() {
    if (!video_) {
      return describe_written(*pattern_, written_);
    }
    video_->finish();
    const int left_out = static_cast<int>(written_.size()) - video_->frames();
    return fmt::format(
        "wrote {}, {}{}", job_.output, counted(video_->frames(), "frame"),
        left_out == 0 ? "" : fmt::format(" of {}: a GIF shows at most 50 in a second", written_.size()));
  }

 private:
  const RenderJob& job_;
  std::optional<OutputPattern> pattern_;
  std::unique_ptr<VideoWriter> video_;
  std::vector<int> written_;
};

// A picture made again may differ where the program, the garment's file or OpenGL has changed since.
void compare_with_record(const RenderJob& job, const std::vector<FrameRecord>& records,
                         const std::string& gl_renderer) {
  const auto same_frame = std::find_if(records.begin(), records.end(),
                                       [&](const auto& record) { return record.frame == job.again->frame; });
  if (same_frame != records.end() && same_frame->state_hash != job.again->state_hash) {
    fmt::print(stderr,
               "taut: warning: the cloth is not where it was in the picture (state {:016x}, then {:016x}): "
               "made by {}, or from another garment file\n",
               same_frame->state_hash, job.again->state_hash, job.again->program);
  }
  if (gl_renderer != job.again->gl_renderer) {
    fmt::print(stderr, "taut: warning: drawn by '{}', then by '{}': pixels may differ\n", gl_renderer,
               job.again->gl_renderer);
  }
}

PictureOrigin origin_of(const RenderOptions& options, const RenderJob& job, OffscreenRenderer& offscreen) {
  return {command_text(options.arguments), scene_text(job.scene), offscreen.gl_renderer()};
}

void show_frame(Progress& progress, const std::string& done, const FrameRecord& record, const RenderJob& job,
                const Stopwatch& since_start) {
  const int last = job.frames.back();
  progress.show(fmt::format("frame {} of {}{}{}{}, stretch {:.2f} %, of the surface {:.2f} %", record.frame,
                            last, done.empty() ? "" : " ", done,
                            time_left(1e-3 * since_start.elapsed_ms(), record.frame, last),
                            100.0 * record.stretch.max, 100.0 * record.surface_stretch.max));
}

[[noreturn]] void fail_to_resume(const std::string& obstacle) {
  throw InputError("cannot resume: " + obstacle + "; remove it, or run without --resume");
}

// Why the picture cannot be this frame of the scene; empty: it can.
std::string obstacle_to_resuming(const std::filesystem::path& file, int frame, const PictureOrigin& origin) {
  try {
    const PictureRecord record = read_picture_record(file, {});
    const bool is_ours = record.frame == frame && record.gl_renderer == origin.gl_renderer &&
                         record.program == "taut " + program_version() &&
                         scene_text(record.scene) == origin.scene;
    return is_ours ? "" : '\'' + file.string() + "' was made from another scene or by another program";
  } catch (const InputError& error) {
    return error.what();
  }
}

// The frames a run that was cut short left to be drawn. Files are renamed into place when they are complete,
// so those that exist are; but they have to show this very scene.
std::vector<int> frames_left(const RenderJob& job, const PictureOutput& output, const PictureOrigin& origin) {
  std::vector<int> left;
  for (const int frame : job.frames) {
    const std::filesystem::path file = output.path_of(frame);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      left.push_back(frame);
      continue;
    }
    const std::string obstacle = obstacle_to_resuming(file, frame, origin);
    if (!obstacle.empty()) {
      fail_to_resume(obstacle);
    }
  }
  return left;
}

// A run that goes on keeps the camera of the pictures that are there.
void take_camera_of_existing(RenderJob& job, const PictureOutput& output) {
  std::error_code error;
  const auto there = std::find_if(job.frames.begin(), job.frames.end(), [&](int frame) {
    return std::filesystem::exists(output.path_of(frame), error);
  });
  if (there == job.frames.end() || !is_fitted(job.scene)) {
    return;
  }
  try {
    const DrawnScene made = read_picture_record(output.path_of(*there), {}).scene;
    job.scene.camera = made.camera;
    job.scene.picture.ground = made.picture.ground;
  } catch (const InputError& unreadable) {
    fail_to_resume(unreadable.what());
  }
}

// Whether the shapes of all frames fit into a gibibyte, to be seen before the first is drawn.
bool can_gather(std::size_t frames, std::size_t vertices) {
  constexpr std::size_t most_bytes = std::size_t{1} << 30U;
  return frames * vertices * sizeof(sim::Vec3) <= most_bytes;
}

// Counts frames of which most of the garment is outside the picture.
class LostGarment {
 public:
  explicit LostGarment(std::span<const int> frames) : frames_(frames) {}

  void look(const renderer::Camera& camera, float aspect, std::span<const sim::Vec3> positions) {
    constexpr float most_of_it = 0.5F;
    if (share_in_picture(camera, aspect, positions) < most_of_it) {
      first_ = lost_++ == 0 ? frames_[drawn_] : first_;
    }
    ++drawn_;
  }
  void tell(const std::string& scene) const {
    if (lost_ > 0) {
      fmt::print(stderr,
                 "taut: warning: {}: most of the garment is outside the picture in {} of {}, first in frame "
                 "{}; camera.follow=true keeps it there, or camera.box\n",
                 scene, lost_, counted(drawn_, "frame"), first_);
    }
  }

 private:
  std::span<const int> frames_;
  std::size_t drawn_ = 0;
  std::size_t lost_ = 0;
  int first_ = 0;
};

ExportSettings exported(const RenderOptions& options, const RenderJob& job) {
  return {options.shapes, {job.frames.front(), job.frames.back()}, job.scene.simulation.frame_rate_hz};
}

std::vector<FrameRecord> draw(const RenderOptions& options, RenderJob& job, sim::Simulation& simulation,
                              OffscreenRenderer& offscreen, const DrawnColours& colours,
                              PictureOutput& output, FrameSink* shapes, std::span<const int> frames,
                              std::optional<StatisticsFile>& statistics, FrameVerifier* verifier,
                              Progress& progress) {
  progress.begin("preparing the first frame");
  const Stopwatch since_start;
  std::optional<GarmentPainter> painter;
  PictureOrigin origin;
  LostGarment lost(frames);
  const auto begin_drawing = [&] {
    painter.emplace(offscreen.renderer(), job.scene, simulation.garment(), simulation.pins().vertices,
                    colours);
    origin = origin_of(options, job, offscreen);
  };
  FrameOutputs outputs;
  if (is_fitted(job.scene) && can_gather(frames.size(), simulation.garment().mesh.positions.size())) {
    outputs.before_drawing = [&](std::span<const FrameInWork> gathered) {
      FittedView fitted(job.scene, simulation.garment());
      for (const FrameInWork& frame : gathered) {
        if (!frame.positions.empty()) {
          fitted.add(frame.positions, frame.record.time_s);
        }
      }
      fitted.place_camera(job.scene);
      begin_drawing();
    };
    // Rows come with the frames, which all are simulated before the first is drawn.
    outputs.simulated = [&](const FrameRecord& record) {
      if (statistics) {
        statistics->add(record);
      }
      show_frame(progress, "simulated", record, job, since_start);
    };
  } else {
    begin_drawing();
  }
  outputs.pictures = frames;
  outputs.start_frame = go_to_start(job.scene, simulation);
  require_begun(outputs.start_frame, job.frames.front());
  if (shapes != nullptr) {
    outputs.with_start = outputs.start_frame == job.frames.front();
    outputs.write_shape = [&](int frame, const auto& moment) { shapes->write(frame, moment); };
  }
  outputs.draw_positions = [&](const std::vector<sim::Vec3>& positions, double time_s) {
    renderer::Image picture = painter->draw(positions, time_s);
    lost.look(painter->camera(), aspect_of(job.scene.picture.settings), positions);
    return picture;
  };
  outputs.write_frame = [&](const FrameRecord& record, const renderer::Image& picture) {
    output.write(origin, record, picture);
  };
  outputs.report = [&](const FrameRecord& record) {
    if (statistics && !outputs.before_drawing) {
      statistics->add(record);
    }
    show_frame(progress, outputs.before_drawing ? "drawn" : "", record, job, since_start);
  };
  if (verifier != nullptr) {
    const std::string crossings = verifier->begin(simulation);
    if (!job.scene.checkpoint.empty() && !crossings.empty()) {
      fmt::print("{}: at the start {}\n", job.scene.name, crossings);
    }
    outputs.verify = [&](const auto& moment, FrameRecord& record) { return verifier->check(moment, record); };
  }
  const auto keep = [&] {
    progress.hide();
    output.keep();
    fmt::print("{}", shapes != nullptr ? shapes->finish() + '\n' : "");
  };
  try {
    std::vector<FrameRecord> records = run_frames(simulation, job.frames.back(), outputs);
    progress.hide();
    lost.tell(job.scene.name);
    return records;
  } catch (const FrameBlocked& error) {
    keep();
    end_blocked(error, job.scene, simulation, job.output, offscreen);
  } catch (const PromiseBroken&) {
    keep();
    throw;
  } catch (const sim::Diverged&) {
    keep();
    throw;
  }
}

}  // namespace

int run(const RenderOptions& options) {
  RenderJob job = render_job_of(options);
  PictureOutput output(job);
  if (!options.shapes.empty()) {
    require_export(exported(options, job), job.scene.garment.file);
  }
  if (!options.statistics.empty()) {
    statistics_format(options.statistics);
    prepare_folder_of(options.statistics);
  }

  Progress progress(job.scene.name);
  // Starting OpenGL and compiling shaders takes as long as reading a model.
  std::future<LoadedGarment> garment = std::async(std::launch::async, [&] {
    return load_garment(job.scene, [&](const std::string& stage) { progress.begin(stage); });
  });
  OffscreenRenderer offscreen(options.backend);
  const PictureStyle& style = job.scene.picture;
  offscreen.renderer().prepare(settings_of(style), style.surface == SurfaceLook::stretch);
  LoadedGarment loaded = garment.get();
  progress.hide();
  print_body_remarks(job.scene, put_where_it_begins(loaded, job.scene), stdout);
  print_remarks(job.scene, loaded);
  face_front(loaded, job.scene);
  const DrawnColours colours = drawn_colours(job.scene, loaded);
  for (const std::string& remark : colours.remarks) {
    fmt::print(stderr, "taut: warning: {}: {}\n", job.scene.garment.file.filename().string(), remark);
  }
  sim::Simulation simulation = make_simulation(job.scene, loaded);
  if (options.resume) {
    take_camera_of_existing(job, output);
  }
  const std::vector<int> frames =
      options.resume ? frames_left(job, output, origin_of(options, job, offscreen)) : job.frames;
  if (frames.size() < job.frames.size()) {
    fmt::print("there already: {} of {}\n", job.frames.size() - frames.size(),
               counted(job.frames.size(), "frame"));
  }
  std::optional<StatisticsFile> statistics;
  if (!options.statistics.empty()) {
    const RunDescription description = {job.scene, simulation.garment(), simulation.pins().vertices.size(),
                                        offscreen.gl_renderer(), options.verify};
    statistics.emplace(options.statistics, description, std::nullopt);
  }
  FrameVerifier verifier;
  const std::unique_ptr<FrameSink> shapes =
      options.shapes.empty() ? nullptr : open_sink(exported(options, job), loaded, simulation);
  const std::vector<FrameRecord> records =
      draw(options, job, simulation, offscreen, colours, output, shapes.get(), frames, statistics,
           options.verify ? &verifier : nullptr, progress);
  RunSummary summary;
  for (const FrameRecord& record : records) {
    summary.add(record);
  }
  progress.begin("finishing " + job.output);
  const std::string written = output.finish() + (shapes ? '\n' + shapes->finish() : "");
  progress.hide();

  if (job.again && options.overrides.empty()) {
    compare_with_record(job, records, offscreen.gl_renderer());
  }
  if (statistics) {
    statistics->finish(summary);
    fmt::print("wrote {}\n", options.statistics.string());
  }
  fmt::print("{}\n{}", written, options.verify ? verifier.summary() + '\n' : "");
  for (const std::string& line :
       {describe_crossings(summary), describe_following(loaded, simulation.state().current)}) {
    fmt::print("{}", line.empty() ? "" : line + '\n');
  }
  return judge_bound(job.scene, summary);
}

}  // namespace taut::app
