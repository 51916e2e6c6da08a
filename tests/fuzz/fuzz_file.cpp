// Any bytes as a file of some kind. They pass its reader and the code that uses the result.
// Only errors that people are shown may come of them.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "app/base/errors.hpp"
#include "app/bodies/frame_source.hpp"
#include "app/garments/sewing/cutting.hpp"
#include "app/models/garment_loading.hpp"
#include "app/output/picture_record.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "app/scene/scene_format.hpp"
#include "app/viewer/session/session.hpp"
#include "fuzz.hpp"

namespace {

using namespace taut;
using namespace taut::app;
namespace fs = std::filesystem;

constexpr int panel_triangles = 300;

std::string text_in(const fs::path& file) { return read_text_file(file, max_model_bytes); }

void use_pattern(const fs::path& file) { cut_pieces(read_sewing_pattern(file), panel_triangles); }

void use_fabric(const fs::path& file) { find_fabric_material(file.string(), "--fabric"); }

void use_session(const fs::path& file) { parse_session(text_in(file), "fuzzed.session"); }

void use_scene_in_picture(const fs::path& file) {
  try {
    read_picture_record(file, {});
  } catch (const InputError&) {
  }
  decode_image(text_in(file));
}

/// A body of three joints, each with one vertex.
std::shared_ptr<const Rig> make_rig() {
  Rig rig;
  glm::dmat4 up(1.0);
  up[3] = {0.0, 0.5, 0.0, 1.0};
  rig.nodes = {{"Hips", no_node, up}, {"Spine", 0, up}, {"LeftFoot", 0, glm::inverse(up)}};
  rig.parts = {{0, "body", 0, 3, true}};
  rig.in_part = {{0.0, 0.5, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.1}};
  rig.bones = {{0, glm::inverse(up)}, {1, glm::inverse(up * up)}, {2, glm::dmat4(1.0)}};
  rig.influences = {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 1.0}};
  return std::make_shared<const Rig>(std::move(rig));
}

void use_frames(const FrameSource& frames) {
  std::vector<sim::Vec3> positions(frames.vertices());
  for (const std::size_t frame : {std::size_t{0}, frames.frames() / 2, frames.frames() - 1}) {
    frames.read(frame, positions);
    frames.pose(frame);
  }
}

void use_bvh(const fs::path& file) {
  BodySource source;
  source.file = "body.glb";
  source.motion = file;
  const OpenedMotion motion = open_bvh(source, make_rig(), ModelAxis::y);
  if (motion.frames) use_frames(*motion.frames);
}

void use_pc2(const fs::path& file) { use_frames(*open_pc2(file)); }

/// The bytes get a valid seal, so that the reader accepts them; everything behind the seal may be wrong.
void use_checkpoint(const fs::path& file) {
  static const LoadedGarment garment = [] {
    Scene scene;
    scene.garment.grid.columns = scene.garment.grid.rows = 4;
    return load_garment(scene);
  }();
  sim::ByteWriter sealed;
  for (const char byte : text_in(file)) sealed.put(byte);
  sealed.seal();
  const RunCheckpoint checkpoint = parse_run_checkpoint(sealed.bytes(), file);
  Scene scene;
  scene.garment.grid.columns = scene.garment.grid.rows = 4;
  sim::Simulation simulation = make_simulation(scene, garment);
  restore(file, checkpoint, simulation);
  simulation.advance_frame();
  simulation.advance_frame();
}

void pass(const char* ending, void (*use)(const fs::path&), const std::uint8_t* data, std::size_t size) {
  const fs::path file = fs::temp_directory_path() / ("taut-fuzz-" + std::to_string(::getpid()) + ending);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    use(file);
  } catch (const InputError&) {
  } catch (const UsageError&) {
  } catch (const std::invalid_argument&) {
  } catch (const sim::Diverged&) {
  } catch (const sim::ContactBlocked&) {
  }
}

}  // namespace

namespace taut::test {

void fuzz_bvh(const std::uint8_t* data, std::size_t size) { pass(".bvh", use_bvh, data, size); }
void fuzz_checkpoint(const std::uint8_t* data, std::size_t size) { pass(".checkpoint", use_checkpoint, data, size); }
void fuzz_fabric(const std::uint8_t* data, std::size_t size) { pass(".toml", use_fabric, data, size); }
void fuzz_pattern(const std::uint8_t* data, std::size_t size) { pass(".json", use_pattern, data, size); }
void fuzz_pc2(const std::uint8_t* data, std::size_t size) { pass(".pc2", use_pc2, data, size); }
void fuzz_picture(const std::uint8_t* data, std::size_t size) { pass(".png", use_scene_in_picture, data, size); }
void fuzz_session(const std::uint8_t* data, std::size_t size) { pass(".txt", use_session, data, size); }

}  // namespace taut::test
