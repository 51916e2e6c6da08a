#include "app/models/garment_start.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

/// Smallest height of a triangle of a mesh that is cut anew, as a fraction of its height before. Flatter ones are too
/// stiff.
constexpr double min_cut_height = 0.1;

/// Returns the smallest ratio of a triangle's height now to its height before.
double min_height_left(const sim::Garment& now, const sim::Garment& before) {
  double min_ratio = 1.0;
  for (std::size_t t = 0; t < now.triangles_at_rest.size(); ++t) {
    const sim::TriangleAtRest &flat = now.triangles_at_rest[t], &earlier = before.triangles_at_rest[t];
    min_ratio = std::min(min_ratio, flat.has_surface() && earlier.has_surface()
                                        ? sim::min_height_m(flat) / sim::min_height_m(earlier)
                                        : 0.0);
  }
  return min_ratio;
}

/// Takes the untangled shape as the rest shape of a fitted mesh, because contact may not let a mesh that is stretched
/// up to its bound return. Returns false and changes nothing if this makes triangles too flat.
bool cut_as_parted(const Scene& scene, const std::vector<sim::Vec3>& untangled_m, LoadedGarment& loaded) {
  const sim::Garment& fitted = *loaded.garment;
  sim::Garment cut = sim::make_garment({untangled_m, fitted.mesh.triangles, {}}, scene.mapping, fitted.material);
  if (min_height_left(cut, fitted) < min_cut_height) return false;
  cut.warps = fitted.warps;
  loaded.garment = sim::share(std::move(cut));
  return true;
}

}  // namespace

std::vector<sim::Vec3> positions_in_file(const ImportedModel& model) {
  if (model.position_of_vertex.empty()) return model.positions;
  return collect<sim::Vec3>(model.position_of_vertex, [&](sim::Index p) { return model.positions[p]; });
}

std::vector<sim::Vec3> read_start(const GarmentSource& source, LoadedGarment& loaded) {
  const std::filesystem::path& file = source.start;
  std::vector<sim::Vec3> found_m;
  if (source.given_start_m) {
    found_m = *source.given_start_m;
  } else {
    const ImportedModel start = import_garment(file, {.program = source.importer});
    loaded.files_read.insert(loaded.files_read.end(), start.files.begin(), start.files.end());
    found_m = positions_in_file(start);
  }
  const std::size_t count = loaded.garment->mesh.positions.size();
  const std::vector<sim::Index>& mesh_vertex = loaded.file_vertices.mesh_vertex;
  const bool has_file_order = !loaded.file_faces.empty() && (!source.given_start_m || source.given);
  if (!has_file_order || found_m.size() != mesh_vertex.size()) {
    if (found_m.size() == count && !source.given) return found_m;
    const std::string found = "found " + count_text(found_m.size(), "vertex", "vertices");
    const std::size_t expected = has_file_order ? mesh_vertex.size() : count;
    if (source.given_start_m) {
      throw std::invalid_argument(fmt::format("start: {}, expected {}", found, expected));
    }
    throw InputError(
        "garment.start: {} in '{}', expected the garment's {}, in their order, as taut simulate --export "
        "writes them",
        found, file.string(), expected);
  }
  if (loaded.following) return simulated_m(*loaded.following, loaded.garment->mesh, found_m);
  std::vector<sim::Vec3> start_m(count);
  for (std::size_t v = mesh_vertex.size(); v-- > 0;) {
    if (mesh_vertex[v] != sim::no_vertex) start_m[mesh_vertex[v]] = found_m[v];
  }
  return start_m;
}

bool can_be_untangled(const LoadedGarment& loaded) {
  constexpr std::size_t max_percent = 6;  ///< crossing pairs for a hundred triangles
  const sim::Mesh& mesh = loaded.garment->mesh;
  return (loaded.following || !loaded.fitting_refusal.empty()) &&
         100 * sim::find_crossing_pairs({mesh.positions, mesh.triangles}).size() <= max_percent * mesh.triangles.size();
}

void untangle(const Scene& scene, LoadedGarment& loaded, const StageReport& begin) {
  const bool may_cut = loaded.following && !loaded.start_m;
  const sim::Mesh& rest_mesh = loaded.garment->mesh;
  std::vector<sim::Vec3> start_m;
  // A mesh that is untangled without its bound can become too flat to be cut anew, but hardly within it.
  for (const bool is_cut_anew : {may_cut, false}) {
    start_m = loaded.start_m.value_or(rest_mesh.positions);
    loaded.untangling = untangle_start(scene, *loaded.garment, is_cut_anew, start_m, begin);
    if (!loaded.untangling || (may_cut && cut_as_parted(scene, start_m, loaded))) return;
    if (!is_cut_anew) break;
  }
  if (!loaded.start_m || !sim::find_crossing_pairs({rest_mesh.positions, rest_mesh.triangles}).empty()) {
    sim::Garment garment = *loaded.garment;
    garment.untangled_m = start_m;
    loaded.garment = sim::share(std::move(garment));
  }
  loaded.start_m = std::move(start_m);
}

}  // namespace taut::app
