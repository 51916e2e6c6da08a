#include "app/bodies/body_loading.hpp"
#include "app/fitting/fitted_mesh.hpp"
#include "app/sewing/sewing.hpp"

// The parts of libtaut that a page does without, as the libraries behind them are not there. Those that are asked for
// say so; a sewing pattern is a model that is not read.
namespace taut::app {

extern const char* const key_texts;
const char* const key_texts = "";  // of the help, which nobody can ask for

std::filesystem::path own_file() { return {}; }

sim::Mesh remesh(const sim::Mesh& /*surface*/, double /*edge_m*/, std::size_t /*max_looks*/) {
  throw InputError("garment.mesh: no mesh of its own is made in a page; expected 'model'");
}

std::vector<std::string> sew_and_load_bodies(Scene& scene, std::span<const Override> overrides,
                                             const std::function<void(const std::string&)>& /*stage*/) {
  return load_bodies(scene, overrides);
}

}  // namespace taut::app
