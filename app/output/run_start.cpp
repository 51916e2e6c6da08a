#include "app/output/run_start.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"
#include "app/bodies/fit.hpp"
#include "app/models/scene_crossings.hpp"
#include "app/output/run_checkpoint.hpp"

namespace taut::app {
namespace {

/// A garment that breaks its bound in so many frames in a row while it is put on is too tight.
constexpr int most_tight_frames = 8;

/// Requires that nothing crosses a body that has grown into its clothes, where the scene does not allow it.
void require_worn(const Scene& scene, const sim::Simulation& simulation) {
  const SolverChoice& solver = scene.simulation.solver;
  const bool is_kept_apart = solver.kind == sim::SolverKind::bounded && !solver.bounded.allow_crossing;
  if (scene.dressing_frames() == 0 || !is_kept_apart) {
    return;
  }
  const std::vector<sim::Body>& bodies = simulation.surroundings().bodies;
  const Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
  for (const SceneCrossings& crossings : scene_crossings(cloth, bodies, 0.0)) {
    if (crossings.body && !crossings.pairs.empty()) {
      throw PromiseBroken("when it is dressed, " + describe(crossings, cloth, bodies));
    }
  }
}

}  // namespace

void dress(const Scene& scene, sim::Simulation& simulation) {
  const int frames = scene.dressing_frames();
  if (frames == 0) {
    return;
  }
  const sim::Surroundings surroundings = simulation.surroundings();
  // Clothes would fall off a body that is thin, and slide to where they have room.
  sim::Surroundings still = surroundings;
  still.forces.gravity_m_per_s2 = sim::Vec3(0.0);
  still.forces.gravity_path.clear();
  still.forces.wind.speed_m_per_s = 0.0;
  for (sim::Body& body : still.bodies) {
    body.friction = 0.0;
  }
  simulation.set_surroundings(still);
  simulation.set_time(-frames * simulation.frame_time_s());
  int tight_frames = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    throw_if_interrupted();
    const auto give_up = [&](const std::string& why) {
      throw PromiseBroken(fmt::format("while it is dressed, in frame {} of {}: {}", frame, frames, why));
    };
    try {
      simulation.advance_frame(throw_if_interrupted);
    } catch (const sim::ContactBlocked& error) {
      give_up(error.what());
    }
    const sim::BoundedSettings& bounded = scene.simulation.solver.bounded;
    tight_frames = simulation.last_report().bound_kept ? 0 : tight_frames + 1;
    if (tight_frames == most_tight_frames && !bounded.allow_exceeding) {
      give_up(fmt::format("it would have to stretch by more than solver.max_stretch = {:g}",
                          bounded.max_stretch));
    }
  }
  simulation.set_surroundings(surroundings);
  simulation.set_time(0.0);
}

int start_frame(const Scene& scene) {
  return scene.checkpoint.empty() ? 0 : read_run_checkpoint(scene.checkpoint).frame;
}

int go_to_start(const Scene& scene, sim::Simulation& simulation) {
  if (scene.checkpoint.empty()) {
    const std::vector<FitRow> fit = scene.dressing_frames() == 0
                                        ? std::vector<FitRow>{}
                                        : fit_of(scene, simulation.garment(), simulation.state().current);
    require_wearable(scene, fit);
    try {
      dress(scene, simulation);
      require_worn(scene, simulation);
    } catch (const PromiseBroken& error) {
      throw PromiseBroken(error.what() + describe_misfit(fit));
    }
    return 0;
  }
  const RunCheckpoint checkpoint = read_run_checkpoint(scene.checkpoint);
  restore(scene.checkpoint, checkpoint, simulation);
  return checkpoint.frame;
}

}  // namespace taut::app
