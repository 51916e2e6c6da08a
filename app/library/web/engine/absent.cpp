#include "app/bodies/body_loading.hpp"
#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/sewing/sewing.hpp"

// Replaces parts of libtaut whose libraries do not exist for a page. Calling them throws an error; a sewing pattern is
// a model that cannot be read.
namespace taut::app {

extern const char* const key_texts;
const char* const key_texts = "";  // used by help texts, which a page does not show

std::filesystem::path own_file() { return {}; }

sim::Mesh remesh(const sim::Mesh& /*surface*/, double /*edge_m*/, std::size_t /*max_looks*/) {
  throw InputError("garment.mesh: no mesh of its own is made in a page; expected 'model'");
}

sim::Mesh simplify(const sim::Mesh& surface, std::size_t /*max_triangles*/) { return remesh(surface, 0.0, 0); }

LoadedBodies sew_and_load_bodies(Scene& scene, std::span<const Override> overrides,
                                 const std::function<void(const std::string&)>& /*stage*/) {
  return choose_dressing(overrides, scene);
}

}  // namespace taut::app
