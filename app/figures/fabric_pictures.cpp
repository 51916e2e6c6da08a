#include "app/figures/fabric_pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "app/drawing/drawn_scene.hpp"

namespace taut::app {
namespace {

constexpr float from_above_rad = 1.55F;
constexpr float narrow_view_rad = 0.2F;

/// From and to, and once if they are the same.
std::string range_text(int from, int to) {
  return from == to ? fmt::format("{}", from) : fmt::format("{}-{}", from, to);
}

Recording seen_from_above(const DrapedFabric& draped) {
  Recording recording;
  recording.scene = draped.scene;
  recording.scene.camera.framing = {
      .azimuth_rad = 0.0F, .elevation_rad = from_above_rad, .vertical_fov_rad = narrow_view_rad};
  recording.scene.picture.show_pins = false;
  const DrapeRun& run = draped.runs.back();
  recording.garment = run.garment;
  recording.pins = run.pins;
  recording.moments.push_back({{}, run.positions_m});
  return recording;
}

std::string measured_text(const DrapedFabric& draped) {
  const std::string published = draped.fabric.published_drape_text();
  return fmt::format("{:.0f} ± {:.0f} %{}; {} folds", draped.mean_percent(), draped.spread_percent(),
                     published.empty() ? "" : ", published " + published + " %", draped.folds());
}

/// Pictures of all last moments with the captions below.
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

}  // namespace

double DrapedFabric::mean_percent() const {
  const double sum = std::accumulate(runs.begin(), runs.end(), 0.0, [](double before, const DrapeRun& run) {
    return before + run.shadow.coefficient;
  });
  return 100.0 * sum / static_cast<double>(runs.size());
}

double DrapedFabric::spread_percent() const {
  const auto [least, most] = std::minmax_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.shadow.coefficient < b.shadow.coefficient;
  });
  return 50.0 * (most->shadow.coefficient - least->shadow.coefficient);
}

std::string DrapedFabric::folds() const {
  const auto [fewest, most] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.shadow.folds < b.shadow.folds; });
  return range_text(fewest->shadow.folds, most->shadow.folds);
}

Drawing draw_drapes(std::span<const DrapedFabric> fabrics, LazyOffscreenRenderer& offscreen) {
  std::vector<Recording> recordings;
  std::vector<Caption> captions;
  for (const DrapedFabric& draped : fabrics) {
    recordings.push_back(seen_from_above(draped));
    captions.push_back({'\0', draped.fabric.name, measured_text(draped)});
  }
  const SheetStyle style{.columns = 4, .gap_px = 16.0F, .caption = {.text_px = 30.0F, .measured_px = 22.0F}};
  return sheet_of_last(recordings, captions, {460, 460}, style, false, offscreen);
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
