#include "app/sewing/sewn_scene.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/version.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/models/landmarks.hpp"
#include "app/sewing/sewing.hpp"

namespace taut::app {
namespace {

/// The body to sew on: the last one of a file. The others are left out.
Scene scene_to_sew(const Scene& scene) {
  const auto of_file = [](const BodySource& source) { return !source.file.empty(); };
  const auto found = std::find_if(scene.body_sources.rbegin(), scene.body_sources.rend(), of_file);
  if (found == scene.body_sources.rend()) {
    throw InputError("'{}' is a sewing pattern: found no body to sew it on, expected one (--body FILE, body.file)",
                     scene.garment.file.string());
  }
  const auto number = static_cast<std::size_t>(scene.body_sources.rend() - found) - 1;
  Scene sewn = scene;
  sewn.body_sources = {*found};
  sewn.body_sources[0].motion.clear();
  sewn.body_sources[0].clip = "none";
  sewn.body_sources[0].dress = usual_dressing_frames;
  sewn.surroundings = {};
  sewn.surroundings.bodies = {{.name = scene.surroundings.bodies[number].name, .shape = sim::BodyMesh{}}};
  return sewn;
}

/// Different for whatever makes another garment.
std::uint64_t fingerprint_of(const Scene& scene) {
  const BodySource& body = scene.body_sources[0];
  const sim::Material& m = scene.material;
  sim::ByteWriter bytes;
  bytes.put_text(program_version());
  bytes.put_text(read_text_file(scene.garment.file));
  bytes.put_text(read_text_file(body.file));
  bytes.put(body.scale.value_or(0.0));
  bytes.put(body.up ? static_cast<std::uint8_t>(*body.up) : std::uint8_t{255});
  for (const double value : {m.areal_density_kg_per_m2, m.bending_rigidity_n_m, m.compression_stiffness_n_per_m,
                             m.tensile_warp_n_per_m, m.tensile_weft_n_per_m, m.shear_n_per_m, m.thickness_m, m.friction,
                             scene.simulation.solver.bounded.max_stretch}) {
    bytes.put(value);
  }
  return sim::fnv1a(sim::fnv1a_of_nothing, bytes.bytes());
}

/// A folder that only this user can write to, where garments stay that were sewn: nobody else can lay a file
/// there that is taken for one.
std::filesystem::path own_folder() {
  const std::filesystem::path temporary = std::filesystem::temp_directory_path();
  const std::filesystem::path usual = temporary / fmt::format("taut-{}", ::getuid());
  struct stat found = {};
  const bool is_made = ::mkdir(usual.c_str(), S_IRWXU) == 0;
  if (is_made || (::lstat(usual.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::getuid() &&
                  (found.st_mode & (S_IRWXG | S_IRWXO)) == 0)) {
    return usual;
  }
  std::string other = (temporary / "taut-XXXXXX").string();
  if (::mkdtemp(other.data()) == nullptr) {
    throw InputError("cannot make a folder in '{}' for what is sewn: {}", temporary.string(), std::strerror(errno));
  }
  return other;
}

}  // namespace

std::vector<std::string> sew_garment(Scene& scene, const std::function<void(const std::string&)>& stage) {
  if (!is_sewing_pattern(scene.garment.file)) return {};
  Scene to_sew = scene_to_sew(scene);
  scene.garment.sewn =
      own_folder() / fmt::format("{}-{:016x}.obj", scene.garment.file.stem().string(), fingerprint_of(to_sew));
  scene.garment.scale = 1.0;
  scene.garment.up = ModelAxis::y;
  if (std::filesystem::exists(scene.garment.sewn)) {
    return {fmt::format("its pattern was sewn before, to '{}'", scene.garment.sewn.string())};
  }
  std::vector<std::string> said = load_bodies(to_sew);
  const SewnGarment garment = sew(
      to_sew, {}, stage ? stage : [](const std::string&) {});
  said.insert(said.end(), garment.remarks.begin(), garment.remarks.end());
  said.push_back(fmt::format("its pattern was sewn to '{}'", scene.garment.sewn.string()));
  // Whoever finds the one file finds the other.
  write_text_file(landmarks_path(scene.garment.sewn), landmarks_of(garment));
  write_text_file(scene.garment.sewn, obj_of(garment));
  return said;
}

std::vector<std::string> sew_and_load_bodies(Scene& scene, std::span<const Override> overrides,
                                             const std::function<void(const std::string&)>& stage) {
  std::vector<std::string> said = sew_garment(scene, stage);
  if (stage) stage("reading its bodies");
  const std::vector<std::string> of_bodies = load_bodies(scene, overrides);
  said.insert(said.end(), of_bodies.begin(), of_bodies.end());
  return said;
}

}  // namespace taut::app
