#include "app/figures/fabric_pictures.hpp"

#include <fmt/core.h>

namespace taut::app {
Drawing sheet_of_last(std::span<const Recording> recordings, std::span<const Caption> captions,
                      const PictureSize& size, const SheetStyle& style, bool has_floor,
                      LazyOffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const Recording& recording : recordings) {
    moments.push_back({&recording, &recording.last(), false, has_floor});
  }
  Prints prints = print_moments(offscreen, moments, size);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    panels.push_back({std::move(prints.pictures[i]), captions[i]});
  }
  return sheet_of(std::move(panels), prints.size, style, {0.1F * prints.metre_px, "10 cm"});
}

DrawnScene made_of(DrawnScene scene, const std::string& fabric) {
  apply_overrides(std::vector<Override>{{"cloth.fabric", fabric, "--fabric " + fabric}}, scene);
  scene.title = find_fabric(fabric).name;
  return scene;
}

Drawing draw_fabrics(std::span<const Recording> recordings, LazyOffscreenRenderer& offscreen) {
  std::vector<Caption> captions;
  for (const Recording& recording : recordings) {
    const sim::Material& cloth = recording.scene.material;
    captions.push_back({'\0', recording.scene.title,
                        fmt::format("{:.0f} g/m², {:.3g} µN m", 1e3 * cloth.areal_density_kg_per_m2,
                                    1e6 * cloth.bending_rigidity_n_m)});
  }
  const SheetStyle style{.columns = 3, .gap_px = 16.0F, .caption = {.text_px = 30.0F, .measured_px = 24.0F}};
  return sheet_of_last(recordings, captions, {620, 560}, style, true, offscreen);
}

}  // namespace taut::app
