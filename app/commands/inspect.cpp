#include "app/base/progress.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/inspection_picture.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "app/output/picture_record.hpp"

namespace taut::app {

namespace {

/// Inspects the bodies of --body.
int inspect_bodies(const InspectOptions& options, const Scene& scene) {
  if (scene.bodies.empty()) {
    throw UsageError("GARMENT is required, or --body FILE; taut inspect --help says what there is");
  }
  if (!options.picture.empty()) {
    throw UsageError("--output " + options.picture.string() + ": expected a GARMENT to draw");
  }
  Json bodies = Json::array();
  for (const auto& [body, source] : scene.bodies) {
    bodies.push_back(inspect_body(source));
    fmt::print("{}", options.json ? "" : describe(bodies.back()));
  }
  fmt::print("{}", options.json ? Json({{"bodies", bodies}}).dump(2) + '\n' : "");
  return 0;
}

/// Makes the scene of a model file. A name without an extension that is no file is a built-in scene or garment.
DrawnScene make_scene(const InspectOptions& options) {
  std::error_code error;
  if (!options.garment.empty() && !options.garment.has_extension() &&
      !std::filesystem::exists(options.garment, error)) {
    DrawnScene scene = find_scene(options.garment.string(), options.overrides);
    if (scene.garment.is_grid()) {
      throw UsageError(options.garment.string() + ": expected a garment, found a grid of cloth");
    }
    scene.picture.show_pins = true;
    return scene;
  }
  DrawnScene scene;
  scene.name = options.garment.filename().string();
  scene.garment.file = options.garment;
  apply_overrides(options.overrides, scene);
  return scene;
}

}  // namespace

int run(const InspectOptions& options) {
  DrawnScene scene = make_scene(options);
  if (options.garment.empty()) return inspect_bodies(options, scene);
  LoadedBodies bodies = sew_and_load_bodies(scene);
  print_body_remarks(scene, bodies.remarks, options.json ? stderr : stdout);
  if (!options.picture.empty()) prepare_png(options.picture);
  scene.garment.is_drawn_finer = false;  // crossings are reported for the file's triangles
  Progress progress(options.garment.filename().string());
  LoadedGarment loaded = load_garment(scene, [&](const std::string& stage) { progress.begin(stage); });
  if (!options.picture.empty()) {
    require_inputs_kept({options.picture}, scene, bodies.files_read);
    require_inputs_kept({options.picture}, scene, loaded.files_read);
  }
  print_body_remarks(scene, put_where_it_begins(loaded, scene, bodies), options.json ? stderr : stdout);
  progress.begin("measuring it");
  const Inspection inspection = inspect_garment(scene, loaded);
  progress.hide();
  fmt::print("{}", options.json ? inspection.facts.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'
                                : describe(inspection.facts));
  if (!options.picture.empty()) {
    progress.begin("drawing it");
    write_file(options.picture,
               renderer::encode_png(draw_inspection(inspection, loaded, scene, bodies.all, options.backend),
                                    std::array{program_text()}));
    progress.hide();
    // Standard output has only the report when programs read it.
    fmt::print(options.json ? stderr : stdout, "wrote {}\n", options.picture.string());
  }
  return 0;
}

}  // namespace taut::app
