#include "app/bodies/body_loading.hpp"
#include "app/commands/run.hpp"
#include "app/drawing/inspection_picture.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/output/picture_record.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::app {
namespace {

/// Largest stretch of cloth whose fabric has no stretch limit.
constexpr double max_worn_stretch = 1.0;

DrawnScene make_scene(const FitOptions& options) {
  std::vector<Override> overrides = options.overrides;
  if (sets(overrides, "body.file") && !sets(overrides, "body.dress")) {
    const std::string frames = std::to_string(usual_dressing_frames);
    overrides.push_back({"body.dress", frames, "--dress " + frames});
  }
  DrawnScene scene = find_scene(options.scene, overrides);
  if (sets(overrides, "body.file") && !sets(overrides, "pins.at")) scene.pins.reset();
  if (scene.dressing_frames() == 0) {
    throw UsageError("taut fit " + options.scene +
                     ": found no body that is dressed, expected --body FILE; taut fit --help says more");
  }
  scene.checkpoint.clear();
  // A worn garment may stretch up to the limits of its fabric.
  if (sim::has_law(scene.material) && !sets(overrides, "solver.max_stretch")) {
    scene.simulation.solver.bounded.max_stretch =
        std::min(max_worn_stretch, std::max(scene.material.warp_limit, scene.material.weft_limit));
  }
  return scene;
}

struct SettledRun {
  int frames = 0;
  FrameRecord last;
};

/// Simulates until the cloth sleeps, for at most options.frames frames.
SettledRun run_until_rest(const FitOptions& options, const DrawnScene& scene, sim::Simulation& simulation,
                          Progress& progress, RunSummary& summary) {
  SettledRun worn;
  FrameOutputs outputs;
  outputs.report = [&](const FrameRecord& record) {
    summary.add(record);
    worn.last = record;
    progress.begin(fmt::format("worn for {} of {} frames", record.frame, options.frames));
  };
  try {
    for (; worn.frames < options.frames && !worn.last.asleep; ++worn.frames) {
      outputs.start_frame = worn.frames;
      run_frames(simulation, worn.frames + 1, outputs);
    }
  } catch (const FrameBlocked& error) {
    progress.hide();
    end_blocked(error, scene, simulation, options.output.string());
  }
  return worn;
}

Json report_json(const FitOptions& options, std::span<const FitRow> rows, const SettledRun& worn,
                 const std::string& tightness) {
  Json json = {{"garment", options.scene},
               {"frames", worn.frames},
               {"at_rest", worn.last.asleep},
               {"max_stretch", worn.last.stretch.max},
               {"max_surface_stretch", worn.last.surface_stretch.max},
               {"picture", options.output.string()},
               {"stretched_most", tightness},
               {"fit", Json::array()}};
  for (const FitRow& row : rows) {
    json["fit"].push_back({{"name", row.name},
                           {"body_m", row.body_m},
                           {"garment_m", row.garment_m},
                           {"ease_m", row.ease_m()},
                           {"worn_m", row.worn_m ? Json(*row.worn_m) : Json()},
                           {"is", fit_word(row)}});
  }
  return json;
}

}  // namespace

int run(const FitOptions& asked) {
  FitOptions options = asked;
  DrawnScene scene = make_scene(options);
  if (options.output.empty()) options.output = choose_name(scene.name + "-fit.png");
  prepare_png(options.output);
  std::FILE* const remarks = options.json ? stderr : stdout;
  Progress progress(scene.name);
  const auto stage = [&](const std::string& begun) { progress.begin(begun); };
  LoadedBodies bodies = sew_and_load_bodies(scene, {}, stage);
  progress.hide();
  print_body_remarks(scene, bodies.remarks, remarks);
  LoadedGarment loaded = load_garment(scene, stage);
  progress.hide();
  require_inputs_kept({options.output}, scene, bodies.files_read);
  require_inputs_kept({options.output}, scene, loaded.files_read);
  print_body_remarks(scene, put_on(loaded, scene, bodies), remarks);
  print_remarks(scene, loaded, bodies.all, remarks);
  std::vector<FitRow> rows = compute_fit(bodies, *loaded.garment, surface_at_start(loaded).positions_m);
  fmt::print("{}", options.json ? "" : describe(rows));
  std::fflush(stdout);
  sim::Simulation simulation = make_simulation(scene, loaded, bodies.all);
  go_to_start(scene, bodies, simulation, stage);
  RunSummary summary;
  const SettledRun worn_garment = run_until_rest(options, scene, simulation, progress, summary);
  progress.begin("drawing it");
  measure_worn(simulation.garment(), simulation.state().current, rows);
  const std::string tightness = describe_tightness(bodies, simulation.garment(), simulation.state().current, rows);
  const std::string measured =
      fmt::format("worn for {:.1f} s{}; largest stretch {:.2f} %, of the surface {:.2f} %", worn_garment.last.time_s,
                  worn_garment.last.asleep ? ", at rest" : "", 100.0 * worn_garment.last.stretch.max,
                  100.0 * worn_garment.last.surface_stretch.max);
  const std::string title = fmt::format("{} on {}", scene.name, bodies.all[dressed_body(bodies).body].name);
  write_file(options.output,
             renderer::encode_png(draw_fit({scene, bodies, simulation.garment(), simulation.state().current,
                                            worn_garment.last.time_s, rows, title, measured, tightness},
                                           options.backend),
                                  std::array{program_text()}));
  progress.hide();
  if (options.json) {
    fmt::print("{}\n", report_json(options, rows, worn_garment, tightness).dump(2));
  } else {
    fmt::print("{}\n{}{}wrote {}\n", measured, describe_worn(rows), tightness.empty() ? "" : tightness + '\n',
               options.output.string());
  }
  return judge_bound(scene, summary);
}

}  // namespace taut::app
