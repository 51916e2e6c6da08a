#include "app/viewer/keeping.hpp"

#include "app/base/words.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

// H.264 wants even sides.
int even(int side_px) { return std::max(side_px / 2 * 2, 2); }

renderer::Image cropped(const renderer::Image& image, int width_px, int height_px) {
  if (image.width_px == width_px && image.height_px == height_px) return image;
  renderer::Image part = renderer::make_image(width_px, height_px);
  for (int y = 0; y < height_px; ++y) {
    std::copy_n(image.at(0, y), static_cast<std::size_t>(width_px) * 3U, part.at(0, y));
  }
  return part;
}

std::vector<PinSelector> numbered_in_file(const std::vector<sim::Index>& pins, const FileVertices& vertices) {
  std::vector<PinSelector> numbers;
  for (const sim::Index pin : pins) {
    const std::optional<sim::Index> number = vertices.number_of(pin);
    if (!number) {
      throw InputError(
          "cannot save a pin between the vertices of the garment's file, where garment.subdivisions put one; "
          "take it off, or pin a vertex of the file");
    }
    numbers.emplace_back(*number);
  }
  return numbers;
}

sim::Surroundings surroundings_of(const ViewerState& state) {
  return settled(state.scene.surroundings, *state.shown->loaded);
}

}  // namespace

DrawnScene kept_scene(const ViewerState& state, const ViewArea& area) {
  constexpr int smallest_side_px = 16;
  DrawnScene scene = state.scene;
  const Snapshot& shown = *state.shown;
  const std::vector<sim::Index>& pins = *shown.pins;
  if (pins != shown.loaded->pins) scene.pins = numbered_in_file(pins, shown.loaded->file_vertices);
  const renderer::Camera camera = state.camera.camera();
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  scene.camera.framing.vertical_fov_rad = camera.vertical_fov_rad;
  scene.frames = std::max(1, shown.record.frame);
  if (!scene.checkpoint.empty()) scene.checkpoint = fs::absolute(scene.checkpoint);
  scene.picture.settings.width_px = std::max(area.width_px, smallest_side_px);
  scene.picture.settings.height_px = std::max(area.height_px, smallest_side_px);
  return scene;
}

bool is_pristine(const ViewerState& state) {
  const Snapshot& shown = *state.shown;
  return shown.pristine && shown.settings == simulation_settings(state.scene.simulation) &&
         shown.garment->material == state.scene.material && shown.surroundings == surroundings_of(state);
}

RunCheckpoint kept_moment(const ViewerState& state, const DrawnScene& kept) {
  const sim::Simulation simulation = gone_on_from(*state.shown, simulation_settings(state.scene.simulation),
                                                  state.scene.material, surroundings_of(state));
  return {
      kept.name, scene_text(kept), state.shown->record.frame, {}, sim::encode(simulation.save(), simulation.garment())};
}

WindowRecorder::WindowRecorder(const fs::path& folder, const std::string& stem, int width_px, int height_px)
    : file_(free_name(folder, stem, ".mp4")), width_px_(even(width_px)), height_px_(even(height_px)) {
  prepare_folder_of(file_);
  video_ = std::make_unique<VideoWriter>(file_, VideoSettings{width_px_, height_px_, rate_hz, true});
}

void WindowRecorder::add(const renderer::Image& picture, double elapsed_s) {
  if (picture.width_px < width_px_ || picture.height_px < height_px_) {
    throw std::invalid_argument("the picture has become smaller than the recording");
  }
  const renderer::Image part = cropped(picture, width_px_, height_px_);
  owed_s_ += frames_ == 0 ? 1.0 / rate_hz : std::min(elapsed_s, 1.0);
  for (; owed_s_ >= 1.0 / rate_hz; owed_s_ -= 1.0 / rate_hz, ++frames_) video_->add(part);
}

std::string WindowRecorder::finish() {
  video_->finish();
  return fmt::format("wrote {}, {}", file_.string(), counted(frames_, "frame"));
}

}  // namespace taut::app
