#include "app/bench/contact_trials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"
#include "app/base/ranking.hpp"
#include "app/base/stopwatch.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/output/frame_verifier.hpp"
#include "app/output/run_start.hpp"
#include "app/scene/promise.hpp"
#include "app/scene/scene_lookup.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

// From -1 to 1. Distributions of the standard library differ from one to the next.
double random_share(std::mt19937_64& random) {
  return 2.0 * std::ldexp(static_cast<double>(random() >> 11U), -53) - 1.0;
}

/// Judges frames and keeps what comes of it in a run.
class Judge {
 public:
  Judge(const Scene& scene, ContactRun& run)
      : holds_surface_(bound_kind(scene) == sim::BoundKind::surface), run_(run) {}

  ContactFrame judge(const sim::Simulation& simulation, int frame, double cpu_ms) {
    FrameRecord record = measure_frame(simulation, frame);
    std::string broken = verifier_.check(simulation, record);
    if (broken.empty() && !record.bound_kept) {
      broken = fmt::format("frame {}: the solver could not make sure of it", frame);
    }
    const bool is_broken = !broken.empty();
    if (run_.first_broken.empty()) {
      run_.first_broken = std::move(broken);
    }
    run_.stretch = holds_surface_ ? verifier_.largest().surface : verifier_.largest().springs;
    return {cpu_ms, record.contact, record.crossing_pairs.value(), is_broken};
  }

 private:
  bool holds_surface_;
  ContactRun& run_;
  FrameVerifier verifier_;
};

void end_early(const std::exception& reason, ContactRun& run) {
  if (run.first_broken.empty()) {
    run.first_broken = fmt::format("frame {}: {}", run.frames.size() + 1, reason.what());
  }
}

void add(const ContactFrame& frame, ContactFacts& facts) {
  facts.most_pairs = std::max(facts.most_pairs, frame.contact.most_pairs);
  facts.smallest_distance_m = std::min(facts.smallest_distance_m, frame.contact.smallest_distance_m);
  facts.crossing_pairs += frame.crossing_pairs;
  facts.broken_frames += frame.is_broken ? 1 : 0;
}

}  // namespace

std::vector<sim::Vec3> jittered_start(const GarmentInScene& cloth, double thickness_m, std::uint64_t seed) {
  std::vector<sim::Vec3> start_m = cloth.start_m.value_or(cloth.garment->mesh.positions);
  std::vector<bool> is_pinned(start_m.size(), false);
  for (const sim::Index pin : cloth.pins) {
    is_pinned[pin] = true;
  }
  std::mt19937_64 random(seed);
  for (std::size_t v = 0; v < start_m.size(); ++v) {
    const double x = random_share(random), y = random_share(random), z = random_share(random);
    if (!is_pinned[v]) {
      start_m[v] += jitter_part * thickness_m * sim::Vec3(x, y, z);
    }
  }
  return start_m;
}

ContactRun run_contact(const Scene& scene, const GarmentInScene& cloth, int frames, std::uint64_t seed,
                       const std::function<void(int)>& after_frame) {
  Scene awake = scene;
  awake.simulation.rest.speed_m_per_s = 0.0;
  GarmentInScene begun = cloth;
  if (seed != 0) {
    begun.start_m = jittered_start(cloth, cloth.garment->material.thickness_m, seed);
  }
  sim::Simulation simulation = make_simulation(awake, begun);
  ContactRun run;
  run.seed = seed;
  Judge judge(scene, run);
  try {
    dress(scene, simulation);
    run.start = judge.judge(simulation, 0, 0.0);
    for (int frame = 1; frame <= frames; ++frame) {
      const ProcessorStopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
      simulation.advance_frame(throw_if_interrupted);
      run.frames.push_back(judge.judge(simulation, frame, clock.elapsed_ms()));
      after_frame(frame);
    }
  } catch (const sim::Diverged& diverged) {
    end_early(diverged, run);
  } catch (const sim::ContactBlocked& blocked) {
    end_early(blocked, run);
  } catch (const PromiseBroken& undressed) {
    end_early(undressed, run);
  }
  return run;
}

ContactFacts facts_of(std::span<const ContactRun> runs) {
  ContactFacts facts;
  std::vector<double> times_ms;
  for (const ContactRun& run : runs) {
    facts.passed += run.first_broken.empty() ? 1 : 0;
    facts.stretch = std::max(facts.stretch, run.stretch);
    add(run.start, facts);
    for (const ContactFrame& frame : run.frames) {
      add(frame, facts);
      times_ms.push_back(frame.cpu_ms);
      facts.detections += frame.contact.detections;
      facts.partial_detections += frame.contact.partial_detections;
    }
  }
  facts.frames = times_ms.size();
  if (!times_ms.empty()) {
    facts.median_ms = ranked(times_ms, 0.5);
    facts.worst_ms = ranked(times_ms, 1.0);
    facts.detections /= static_cast<double>(facts.frames);
    facts.partial_detections /= static_cast<double>(facts.frames);
  }
  return facts;
}

std::vector<std::string> contact_scene_names() {
  std::vector<std::string> names;
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.is_of_contact || find_scene(scene.name, {}).dressing_frames() > 0) {
      names.push_back(scene.name);
    }
  }
  return names;
}

}  // namespace taut::app
