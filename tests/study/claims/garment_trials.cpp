#include "app/base/progress.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

struct Sample {
  const char* file;
  const char* kind;
};

// A sample of every kind, each in another format, about 1 m large.
constexpr std::array samples = {
    Sample{"sheet.obj", "an open sheet of quads"},
    Sample{"irregular.ply", "irregular triangles"},
    Sample{"graded.off", "triangles from 6 cm down to 2 mm"},
    Sample{"skirt.stl", "a tube of unconnected triangles"},
    Sample{"turned.obj", "triangles that face both ways"},
    Sample{"cushion.dae", "closed, without a border"},
    Sample{"sleeves.dae", "three parts that are not joined"},
    Sample{"lining.fbx", "two layers"},
    Sample{"wings.ply", "three sheets at one edge, non-manifold"},
    Sample{"band.stl", "a Möbius band, one-sided"},
    Sample{"honeycomb.obj", "hexagons"},
};

Mapping describe_mapping(const sim::Garment& garment) {
  const auto map_springs = sim::at_vertices(garment.mesh.positions.size(), garment.springs.ends);
  Mapping mapping;
  mapping.vertices = garment.mesh.positions.size();
  mapping.triangles = garment.mesh.triangles.size();
  mapping.edges = garment.adjacency.edges.size();
  mapping.structural = garment.springs.count(sim::SpringKind::structural);
  mapping.flexural = garment.springs.count(sim::SpringKind::flexural);
  for (std::size_t v = 0; v < map_springs.size(); ++v) mapping.loose_vertices += map_springs[v].empty() ? 1 : 0;
  return mapping;
}

TrialRun run_trial(const LoadedGarment& loaded, const DrawnScene& scene, const ProgressCallback& report_progress) {
  sim::Simulation simulation = make_simulation(scene, loaded);
  FrameOutputs outputs;
  outputs.report = [&](const FrameRecord& record) {
    report_progress(static_cast<double>(record.frame) / trial_frames);
  };
  try {
    std::vector<double> times_ms;
    TrialRun run;
    for (const FrameRecord& record : run_frames(simulation, trial_frames, outputs)) {
      run.max_stretch_seen = std::max(run.max_stretch_seen, record.stretch.max);
      times_ms.push_back(record.sim_ms);
    }
    run.median_ms = median(times_ms);
    return run;
  } catch (const sim::Diverged&) {
    return {INFINITY, 0.0};
  }
}

}  // namespace

GarmentTrial try_garment(const std::string& file, const std::string& kind, const ProgressCallback& report_progress) {
  GarmentTrial trial;
  trial.file = std::filesystem::path(file).filename().string();
  trial.kind = kind;
  try {
    DrawnScene scene = find_scene(file, {});
    scene.garment.mesh = MeshChoice::model;  // shows which springs each kind of model gives
    const LoadedGarment loaded = load_garment(scene);
    trial.mapping = describe_mapping(*loaded.garment);
    SolverChoice& solver = scene.simulation.solver;
    solver = {};
    solver.kind = sim::SolverKind::strong;
    solver.substeps = trial_steps;
    solver.strong.iterations = trial_sweeps;
    trial.strong = run_trial(loaded, scene, [&](double done) { report_progress(0.8 * done); });
    solver = {};
    solver.bounded.max_stretch = trial_bound;
    trial.bounded = run_trial(loaded, scene, [&](double done) { report_progress(0.8 + 0.2 * done); });
  } catch (const InputError& error) {
    trial.refusal = error.what();
  }
  return trial;
}

std::vector<GarmentTrial> try_garments(const ProgressCallback& report_progress) {
  std::vector<std::pair<std::string, const char*>> models;
  for (const auto& [file, kind] : samples) {
    models.emplace_back(find_asset(std::string("garments/samples/") + file).value_or(file).string(), kind);
  }
  for (const int triangles : model_sizes) {
    models.emplace_back(shirt_scene("tshirt-gravity", triangles).garment.file.string(), "a sewn T-shirt");
  }
  std::vector<GarmentTrial> trials;
  for (const auto& [file, kind] : models) {
    trials.push_back(try_garment(file, kind, report_part(report_progress, trials.size(), models.size())));
  }
  return trials;
}

}  // namespace taut::app
