#include "app/figures/experiments/garment_trials.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/ranking.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/figures/experiments/experiments.hpp"
#include "app/figures/experiments/samples/model_writing.hpp"
#include "app/figures/experiments/samples/sample_garments.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {
namespace {

/// A folder that goes when it is left.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "taut_models_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw InputError(fmt::format("cannot make a folder for models, '{}': {}", name,
                                   std::generic_category().message(errno)));
    }
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

Mapping mapping_of(const sim::Garment& garment) {
  const auto springs_of = sim::edges_of_vertices(garment.mesh.positions.size(), garment.springs.ends);
  Mapping mapping;
  mapping.vertices = garment.mesh.positions.size();
  mapping.triangles = garment.mesh.triangles.size();
  mapping.edges = garment.adjacency.edges.size();
  mapping.structural = garment.springs.count(sim::SpringKind::structural);
  mapping.flexural = garment.springs.count(sim::SpringKind::flexural);
  for (std::size_t v = 0; v < springs_of.size(); ++v) {
    mapping.loose_vertices += springs_of[v].empty() ? 1 : 0;
  }
  return mapping;
}

TrialRun run_trial(const LoadedGarment& loaded, const DrawnScene& scene,
                   const ProgressCallback& report_progress) {
  sim::Simulation simulation = make_simulation(scene, loaded);
  FrameOutputs outputs;
  outputs.report = [&](const FrameRecord& record) {
    report_progress(static_cast<double>(record.frame) / trial_frames);
  };
  try {
    std::vector<double> times_ms;
    TrialRun run;
    for (const FrameRecord& record : run_frames(simulation, trial_frames, outputs)) {
      run.largest_stretch = std::max(run.largest_stretch, record.stretch.max);
      times_ms.push_back(record.sim_ms);
    }
    run.median_ms = median(times_ms);
    return run;
  } catch (const sim::Diverged&) {
    return {INFINITY, 0.0};
  }
}

}  // namespace

GarmentTrial try_garment(const std::string& file, const std::string& kind,
                         const ProgressCallback& report_progress) {
  GarmentTrial trial;
  trial.file = std::filesystem::path(file).filename().string();
  trial.kind = kind;
  try {
    DrawnScene scene = find_scene(file, {});
    scene.garment.mesh = MeshChoice::model;  // which springs each kind of model gives
    const LoadedGarment loaded = load_garment(scene);
    trial.mapping = mapping_of(*loaded.garment);
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
  const ScratchFolder folder;
  struct Model {
    std::string file, kind;
    double cost;
  };
  std::vector<Model> models;
  for (const SampleGarment& sample : make_sample_garments()) {
    const std::filesystem::path file = folder / (sample.name + '.' + sample.format);
    write_text_file(file, model_text(sample.model, sample.format));
    models.push_back({file.string(), sample.kind, static_cast<double>(sample.model.corners.size())});
  }
  for (const int triangles : model_sizes) {
    models.push_back(
        {shirt_scene("tshirt-gravity", triangles).garment.file.string(), "a sewn T-shirt", 3.0 * triangles});
  }
  double total = 0.0, done = 0.0;
  for (const Model& model : models) {
    total += model.cost;
  }
  std::vector<GarmentTrial> trials;
  for (const Model& model : models) {
    trials.push_back(try_garment(model.file, model.kind, [&](double fraction) {
      report_progress((done + fraction * model.cost) / total);
    }));
    done += model.cost;
  }
  return trials;
}

}  // namespace taut::app
