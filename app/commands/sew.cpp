#include <ctime>

#include "app/base/progress.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/inspection_picture.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/output/picture_record.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

constexpr double usual_bound = 0.01;

DrawnScene make_scene(const SewOptions& options) {
  std::vector<Override> overrides = options.overrides;
  const auto add = [&](const char* key, const std::string& value) {
    if (!sets(overrides, key)) overrides.push_back({key, value, std::string("--set ") + key + '=' + value});
  };
  const bool is_worn = sets(overrides, "body.file");
  if (is_worn) add("body.dress", std::to_string(usual_dressing_frames));
  add("solver.max_stretch", std::to_string(usual_bound));
  DrawnScene scene = find_scene(options.pattern.string(), overrides);
  // A worn garment may stretch up to the limits of its fabrics, as in `taut fit`.
  if (is_worn && sim::has_law(scene.material) && !sets(options.overrides, "solver.max_stretch")) {
    double& bound = scene.simulation.solver.bounded.max_stretch;
    bound = std::max({usual_bound, scene.material.warp_limit, scene.material.weft_limit});
    for (const std::string& fabric : options.outer_fabrics) {
      const sim::Material over = find_fabric_material(fabric, "--over-fabric");
      bound = std::max({bound, over.warp_limit, over.weft_limit});
    }
  }
  return scene;
}

/// Returns the default name of the garment. It never names an existing model that was not sewn.
std::filesystem::path choose_garment_name(const std::string& stem) {
  const bool is_sewn = read_landmarks_file(stem + ".obj")["is_cut"].value_or(false);
  return choose_free_stem(stem, is_sewn, {".obj", ".landmarks.toml"}) += ".obj";
}

void write_picture(const std::filesystem::path& file, const DrawnScene& scene, const LoadedBodies& bodies,
                   const SewnGarment& sewn, const std::string& measured, const std::string& backend) {
  const sim::Garment& garment = sewn.sewn.garment;
  const std::vector<sim::Vec3>& worn_m = garment.mesh.positions;
  const std::vector<FitRow> fit = compute_fit(bodies, garment, worn_m);
  const std::string title =
      scene.name + (bodies.all.empty() ? "" : " on " + bodies.all[dressed_body(bodies).body].name);
  write_file(file, renderer::encode_png(draw_fit({scene, bodies, garment, worn_m, sewn.time_s, fit, title, measured,
                                                  describe_tightness(bodies, garment, worn_m, fit)},
                                                 backend),
                                        std::array{program_text()}));
}

void write_steps(const std::filesystem::path& file, const DrawnScene& scene, const LoadedBodies& bodies,
                 const SewnGarment& sewn, const char* last, const std::string& backend) {
  std::vector<GarmentMoment> moments;
  for (const SewingStep& step : sewn.steps) {
    const bool is_flat = moments.empty();
    moments.push_back(
        {step.name, step.garment, step.positions_m, is_flat ? std::nullopt : std::optional<double>(step.time_s)});
  }
  moments.push_back({last, sewn.sewn.garment, sewn.sewn.garment.mesh.positions, sewn.time_s});
  write_file(file, renderer::encode_png(draw_moments(scene, bodies, moments, backend), std::array{program_text()}));
}

[[noreturn]] void end_failed(const SewOptions& options, const DrawnScene& scene, const LoadedBodies& bodies,
                             const SewingFailed& error) {
  const std::filesystem::path file =
      options.picture.empty() ? free_name("", scene.name + "-open", ".png") : options.picture;
  std::string shown = fmt::format("'{}' shows it", file.string());
  try {
    if (!options.steps.empty()) write_steps(options.steps, scene, bodies, error.garment, "as it is", options.backend);
    write_picture(file, scene, bodies, error.garment, error.what(), options.backend);
  } catch (const std::exception& reason) {
    shown = std::string("there is no picture of it: ") + reason.what();
  }
  throw PromiseBroken("{}; {}", error.what(), shown);
}

}  // namespace

int run(const SewOptions& asked) {
  SewOptions options = asked;
  DrawnScene scene = make_scene(options);
  if (options.output.empty()) options.output = choose_garment_name(scene.name);
  if (options.output.extension() != ".obj") {
    throw UsageError("--output " + options.output.string() + ": expected a name that ends in .obj");
  }
  prepare_parent_folder(options.output);
  if (!options.picture.empty()) prepare_png(options.picture);
  if (!options.steps.empty()) prepare_png(options.steps);
  if (!options.outer_fabrics.empty() && options.outer_fabrics.size() != options.outer_patterns.size()) {
    throw UsageError(fmt::format("--over-fabric: found {} of them for {} --over, expected one for each or none",
                                 options.outer_fabrics.size(), options.outer_patterns.size()));
  }
  scene.files_read.insert(scene.files_read.end(), options.outer_patterns.begin(), options.outer_patterns.end());
  // Errors in patterns are reported before bodies are loaded, which takes longer.
  NamedPattern pattern = read_named_pattern(options.pattern);
  SewingSettings settings = {options.triangles, options.frames, {}, options.outer_fabrics, options.is_exact};
  for (const std::filesystem::path& outer : options.outer_patterns) settings.over.push_back(read_named_pattern(outer));
  std::FILE* const remarks = options.json ? stderr : stdout;
  LoadedBodies bodies = load_bodies(scene, static_cast<int>(options.outer_patterns.size()) + 1);
  print_body_remarks(scene, bodies.remarks, remarks);
  std::vector<std::filesystem::path> written = {options.output, landmarks_path(options.output), options.picture,
                                                options.steps};
  std::erase(written, std::filesystem::path());
  require_inputs_kept(written, scene, bodies.files_read);
  Progress progress(scene.name);
  const std::clock_t began = std::clock();
  try {
    const SewnGarment sewn =
        sew(std::move(pattern), scene, bodies, settings, [&](const std::string& stage) { progress.begin(stage); });
    const double took_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    write_text_file(options.output, to_obj(sewn));
    write_text_file(landmarks_path(options.output), to_landmarks_text(sewn));
    const std::string measured =
        fmt::format("{} closed, {}, no crossing, largest stretch {:.3f} %",
                    count_text(sewn.pieces.seams.size(), "seam"), describe_rest(sewn), 100.0 * sewn.max_stretch);
    progress.begin("drawing it");
    if (!options.picture.empty()) write_picture(options.picture, scene, bodies, sewn, measured, options.backend);
    if (!options.steps.empty()) write_steps(options.steps, scene, bodies, sewn, "sewn", options.backend);
    progress.hide();
    print_body_remarks(scene, sewn.remarks, remarks);
    if (options.json) {
      fmt::print("{}\n", Json{{"pattern", options.pattern.string()},
                              {"garment", options.output.string()},
                              {"panels", sewn.pieces.panel_count()},
                              {"seams", sewn.pieces.seams.size()},
                              {"triangles", sewn.pieces.triangles.size()},
                              {"at_rest", sewn.is_at_rest},
                              {"frames", sewn.frames},
                              {"max_surface_stretch", sewn.max_stretch},
                              {"processor_s", took_s}}
                             .dump(2));
    } else {
      fmt::print("{} of {}: {}; {:.1f} s of processor time\nwrote {}\n", count_text(sewn.pieces.panel_count(), "panel"),
                 count_text(sewn.pieces.triangles.size(), "triangle"), measured, took_s, options.output.string());
    }
    if (!sewn.is_at_rest && options.frames > 0) {
      throw PromiseBroken(
          "{} is written, but it is not at rest: {}; {}", options.output.string(), describe_rest(sewn),
          sewn.frames < options.frames ? "more frames would take minutes" : "--frames gives it more time");
    }
  } catch (const SewingFailed& error) {
    progress.hide();
    print_body_remarks(scene, error.garment.remarks, remarks);
    end_failed(options, scene, bodies, error);
  }
  return 0;
}

}  // namespace taut::app
