#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/commands/options.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/runs/shirt_choice.hpp"
#include "app/viewer/headless_viewer.hpp"

namespace taut::app {
namespace {

constexpr const char* first_scene = "tshirt-gusts";

/// Returns the scene's T-shirt for this machine. Takes a third of a second on two cores.
std::string find_shirt() {
  const DrawnScene scene = find_scene(first_scene, std::vector{parse_override("wind.speed=10")});
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  const int triangles = find_shirt_in_real_time(simulation, [&] { simulation.advance_frame(); });
  return fmt::format("garment.file=tshirt_{}", triangles);
}

std::string layout_text(const ViewerState& state) {
  std::string text;
  for (const auto& [name, place] : state.places) {
    text +=
        fmt::format("{} {} {} {} {}\n", name, place.lower_px.x, place.lower_px.y, place.upper_px.x, place.upper_px.y);
  }
  return text;
}

RecordedSession make_session(const ViewOptions& options) {
  RecordedSession session;
  if (!options.script.empty()) session = read_session(options.script);
  if (session.frames.empty()) {
    session.frames.resize(2);  // the panel needs a frame to know its size
  }
  if (!options.scene.empty()) {
    session.start.scene = options.scene;
    session.start.overrides.clear();
  } else if (session.start.scene.empty()) {
    session.start.scene = first_scene;
    if (!options.headless) {
      session.start.overrides.push_back(parse_override(find_shirt()));
    }
  }
  session.start.overrides.insert(session.start.overrides.end(), options.overrides.begin(), options.overrides.end());
  if (options.size) session.start.size = *options.size;
  if (options.compared_with) session.start.compared_with = options.compared_with;
  return session;
}

/// Also checks the garment shown now, which may have been dropped on the window.
void require_inputs_kept(const ViewOptions& options, const DrawnScene& scene, HeadlessViewer& viewer) {
  std::vector<std::filesystem::path> written = {options.record, options.screenshot, options.layout};
  std::erase(written, std::filesystem::path());
  require_inputs_kept(written, scene, {});
  const LoadedScene& shown = *viewer.viewer().state().shown->loaded;
  require_inputs_kept(written, shown.scene, shown.files_read);
}

void view_headless(const ViewOptions& options, const RecordedSession& session, const SceneWithBodies& loaded) {
  HeadlessViewer viewer(loaded, session.start, options.keep_folder, options.backend);
  require_inputs_kept(options, loaded.scene, viewer);
  std::optional<SessionRecorder> recorder;
  if (!options.record.empty()) recorder.emplace(options.record, session.start);
  try {
    for (const SessionFrame& frame : session.frames) {
      SessionFrame played = viewer.play(frame);
      if (&frame == &session.frames.back()) played.expected_state = viewer.state_hash();
      if (recorder) recorder->add(played);
    }
  } catch (const Interrupted&) {
    viewer.viewer().finish_recording();
    throw;
  }
  viewer.viewer().finish_recording();
  for (const Message& message : viewer.viewer().state().messages) {
    fmt::print("{}{}\n", message.is_error ? "error: " : "", printable(message.text));
  }
  require_inputs_kept(options, loaded.scene, viewer);
  if (!options.screenshot.empty()) {
    prepare_parent_folder(options.screenshot);
    write_file(options.screenshot, renderer::encode_png(viewer.draw()));
    fmt::print("wrote {}\n", options.screenshot.string());
  }
  if (!options.layout.empty()) write_text_file(options.layout, layout_text(viewer.viewer().state()));
  const FrameRecord& shown = viewer.viewer().state().newest->record;
  fmt::print("frame {} state {:016x} largest stretch {:.4f} %, of the surface {:.4f} %, drawn by {}\n", shown.frame,
             viewer.state_hash(), 100.0 * shown.stretch.max, 100.0 * shown.surface_stretch.max, viewer.gl_renderer());
}

}  // namespace

int run(const ViewOptions& options) {
  const bool needs_headless = !options.script.empty() || !options.screenshot.empty() || !options.layout.empty();
  if (needs_headless && !options.headless) {
    throw UsageError("--script, --screenshot and --layout are for --headless: a window has a person instead");
  }
  // A folder that was named is made, or refused before a picture is lost. The default one may be read-only.
  if (options.keep_folder != ".") prepare_parent_folder(options.keep_folder / "picture.png");
  const RecordedSession session = make_session(options);
  DrawnScene scene = find_scene(session.start.scene, session.start.overrides);
  LoadedBodies bodies = sew_and_load_bodies(scene, session.start.overrides);
  print_body_remarks(scene, bodies.remarks, stdout);
  if (!options.script.empty()) scene.files_read.push_back(options.script);
  const SceneWithBodies loaded = {std::move(scene), std::move(bodies)};
  if (options.headless) {
    view_headless(options, session, loaded);
  } else {
    view_in_window(loaded, session.start, options.keep_folder, options.record);
  }
  return 0;
}

}  // namespace taut::app
