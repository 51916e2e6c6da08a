// Any text as an OBJ file and as its materials. Only InputError may be thrown, and faces name vertices that exist.
#include <cstdlib>
#include <numeric>
#include <string_view>

#include "app/base/errors.hpp"
#include "app/models/reading/garment_import.hpp"
#include "app/models/reading/model_arrays.hpp"
#include "fuzz.hpp"

using namespace taut::app;

void taut::test::fuzz_obj(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  SurfaceColours named{.materials = {{.name = "m"}}};
  read_mtl(text, named);
  try {
    const std::optional<ModelArrays> model = read_obj(text);
    if (!model) {
      return;
    }
    for (const taut::sim::Index corner : model->faces.corners) {
      if (corner >= model->positions.size()) {
        std::abort();
      }
    }
    const SurfaceColours& colours = model->colours;
    if ((!colours.corner_uv.empty() && colours.corner_uv.size() != model->faces.corners.size()) ||
        (!colours.material_of_face.empty() && colours.material_of_face.size() != model->faces.corner_counts.size())) {
      std::abort();
    }
    if (std::accumulate(model->faces.corner_counts.begin(), model->faces.corner_counts.end(), std::size_t{0}) !=
        model->faces.corners.size()) {
      std::abort();
    }
  } catch (const InputError&) {
  }
}
