#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/viewer/picture/viewer_picture.hpp"
#include "app/viewer/viewer.hpp"

namespace taut::app {
namespace {

constexpr double frame_time_s = 1.0 / 60.0;
// Pause between frames while nothing moves. It limits how late a signal is noticed or a message disappears.
constexpr double rest_time_s = 0.1;
// Time that the scene must be still before it is drawn at best quality. Drawing takes time, and a hand that only pauses
// should not wait for it.
constexpr double until_best_s = 0.3;

class WindowViewer {
 public:
  WindowViewer(const SceneWithBodies& scene, const SessionStart& start, const std::filesystem::path& keep_folder,
               const std::filesystem::path& record_to)
      : simulation_(scene, SimulationHost::Runs::by_itself),
        title_(title_of(scene.scene)),
        context_(open(title_, start.size)),
        picture_(*context_),
        viewer_(simulation_,
                {window_->framebuffer_size(), window_->content_scale(), keep_folder, start.compared_with, true}) {
    if (!record_to.empty()) {
      require_inputs_kept({record_to}, scene.scene, viewer_.state().shown->loaded->files_read);
      SessionStart actual = start;
      actual.size = window_->framebuffer_size();
      actual.scale = window_->content_scale();
      recorder_.emplace(record_to, actual);
    }
  }

  void run() {
    try {
      run_until_closed();
    } catch (...) {
      finish();
      throw;
    }
    finish();
  }

 private:
  // Prints the result, because the window can no longer show messages.
  void finish() {
    if (const auto outcome = viewer_.finish_recording()) fmt::print("{}\n", *outcome);
    finish_record();
  }

  void run_until_closed() {
    while (!window_->is_asked_to_close() && !viewer_.is_ended()) {
      throw_if_interrupted();
      gather_input();
      const Stopwatch laying_out;
      SessionFrame frame = viewer_.update({queue_.take_frame(), next_elapsed_s(), std::nullopt, std::nullopt});
      panel_ms_ = laying_out.elapsed_ms();
      if (recorder_) recorder_->add(frame);
      name_window();
      show();
    }
  }

  std::unique_ptr<renderer::Context> open(const std::string& title, const renderer::Resized& size) {
    auto window = renderer::open_window({title, size.width_px, size.height_px});
    window_ = window.get();
    return window;
  }

  static std::string title_of(const DrawnScene& scene) { return "Taut - " + scene.name; }

  void name_window() {
    std::string title = title_of(viewer_.state().newest->loaded->scene);
    if (title != title_) {
      title_ = std::move(title);
      window_->set_title(title_);
    }
  }

  // Collects events until the next frame is due or, while nothing moves, until something happens.
  void gather_input() {
    const double until_due_s = std::max(frame_time_s - since_frame_.elapsed_ms() / 1000.0, quality_.rest_ms() / 1000.0);
    const bool rests = viewer_.is_still();
    double left_s = rests ? rest_time_s : until_due_s;
    const Stopwatch waiting;
    do {
      for (renderer::WindowEvent& event : window_->wait_events(std::max(left_s, 0.0))) queue_.add(std::move(event));
      const bool is_woken = rests && (!queue_.empty() || simulation_moved());
      left_s = (is_woken ? until_due_s : rests ? rest_time_s : until_due_s) - waiting.elapsed_ms() / 1000.0;
    } while (left_s > 0.0 && !window_->is_asked_to_close());
  }

  bool simulation_moved() { return simulation_.begin_frame(0.0, std::nullopt) != viewer_.state().newest; }

  double next_elapsed_s() {
    const double elapsed_s = since_frame_.elapsed_ms() / 1000.0;
    since_frame_ = Stopwatch();
    return elapsed_s;
  }

  // Returns this program's CPU time since the last call, divided by the number of processors.
  double next_busy_s() {
    const double used_ms = std::exchange(used_, Stopwatch(CLOCK_PROCESS_CPUTIME_ID)).elapsed_ms();
    return 1e-3 * used_ms / std::max(std::thread::hardware_concurrency(), 1U);
  }

  WindowView window() const { return {viewer_.state(), viewer_.interface(), viewer_.layout()}; }

  void show() {
    if (!viewer_.is_still()) since_change_ = Stopwatch();
    const renderer::Resized size = window_->framebuffer_size();
    const bool is_minimised = size.width_px < 1 || size.height_px < 1;
    const bool is_best_wanted = viewer_.wants_screenshot() || since_change_.elapsed_ms() > 1000.0 * until_best_s;
    const std::size_t level = is_best_wanted ? 0 : quality_.level();
    const bool is_shown = picture_.is_drawn(window(), level);
    if (is_minimised || (!window_->take_damage() && is_shown && !viewer_.wants_picture())) return;
    draw(level);
  }

  void draw(std::size_t level) {
    const Stopwatch drawing;
    const bool is_urgent = viewer_.has_input() || viewer_.is_still() || viewer_.wants_screenshot();
    if (viewer_.wants_picture()) {
      viewer_.take_picture(picture_.picture(0, window(), level));
    }
    picture_.draw(0, window(), level, is_urgent);
    renderer::finish_drawing(*window_);
    const double draw_ms = drawing.elapsed_ms();
    viewer_.note_times(draw_ms, panel_ms_, simulation_.worked_ms(), next_busy_s());
    window_->present();
    if (picture_.drew_scene() && level == quality_.level()) {
      quality_.note(panel_ms_ + drawing.elapsed_ms(), simulation_.take_given_up_ms());
    }
  }

  // Records a last line with the final state that a replay must reach.
  void finish_record() {
    if (recorder_) {
      SessionFrame last = viewer_.update({{}, 0.0, std::nullopt, std::nullopt});
      simulation_.end();
      last.pace->advances = simulation_.advances();
      if (!simulation_.gave_up_frame()) last.expected_state = simulation_.state_hash();
      recorder_->add(last);
    }
  }

  SimulationHost simulation_;
  std::string title_;
  renderer::Window* window_ = nullptr;  ///< owned by `context_`
  std::unique_ptr<renderer::Context> context_;
  ViewerPicture picture_;
  Viewer viewer_;
  InputQueue queue_;
  std::optional<SessionRecorder> recorder_;
  QualityControl quality_;
  Stopwatch since_frame_;
  Stopwatch used_{CLOCK_PROCESS_CPUTIME_ID};
  Stopwatch since_change_;  ///< time since anything drawn has changed
  double panel_ms_ = 0.0;
};

}  // namespace

void view_in_window(const SceneWithBodies& scene, const SessionStart& start, const std::filesystem::path& keep_folder,
                    const std::filesystem::path& record_to) {
  WindowViewer session(scene, start, keep_folder, record_to);
  session.run();
}

}  // namespace taut::app
