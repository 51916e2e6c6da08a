#include "app/bench/bench.hpp"

#include <random>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/runs/csv.hpp"
#include "app/runs/frame_verifier.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

// Returns a random number from -1 to 1. Distributions of the standard library differ between implementations.
double random_component(std::mt19937_64& random) {
  return 2.0 * std::ldexp(static_cast<double>(random() >> 11U), -53) - 1.0;
}

void end_early(const std::exception& reason, ContactRun& run) {
  if (run.first_broken.empty()) run.first_broken = fmt::format("frame {}: {}", run.frames.size() + 1, reason.what());
}

void add(const ContactFrame& frame, ContactFacts& facts) {
  facts.max_pairs = std::max(facts.max_pairs, frame.contact.max_pairs);
  facts.min_distance_m = std::min(facts.min_distance_m, frame.contact.min_distance_m);
  facts.crossing_pairs += frame.crossing_pairs;
  facts.broken_frames += frame.is_broken ? 1 : 0;
}

// The solver knows no distance beyond the range of its search.
std::string millimetres(double distance_m) {
  return std::isfinite(distance_m) ? fmt::format("{:.4f}", 1e3 * distance_m) : "-";
}

/// Returns the mean time of the slowest 60 consecutive frames, or of all frames if there are fewer.
double slowest_second_ms(std::span<const double> times_ms) {
  const std::size_t length = std::min<std::size_t>(times_ms.size(), 60);
  double slowest_ms = 0.0;
  for (std::size_t first = 0; first + length <= times_ms.size(); ++first) {
    const auto second = times_ms.subspan(first, length);
    slowest_ms = std::max(slowest_ms, std::accumulate(second.begin(), second.end(), 0.0));
  }
  return slowest_ms / static_cast<double>(length);
}

}  // namespace

std::vector<sim::Vec3> jittered_start(const GarmentInScene& cloth, double thickness_m, std::uint64_t seed) {
  std::vector<sim::Vec3> start_m = cloth.start_m.value_or(cloth.garment->mesh.positions);
  std::vector<bool> is_pinned(start_m.size(), false);
  for (const sim::Index pin : cloth.pins) is_pinned[pin] = true;
  std::mt19937_64 random(seed);
  for (std::size_t v = 0; v < start_m.size(); ++v) {
    const double x = random_component(random), y = random_component(random), z = random_component(random);
    if (!is_pinned[v]) start_m[v] += jitter_fraction * thickness_m * sim::Vec3(x, y, z);
  }
  return start_m;
}

ContactRun run_contact(const Scene& scene, const GarmentInScene& cloth, const std::vector<sim::Body>& bodies,
                       int frames, std::uint64_t seed, const std::function<void(int, sim::Simulation&)>& before_frame) {
  Scene awake = scene;
  awake.simulation.rest.speed_m_per_s = 0.0;
  GarmentInScene begun = cloth;
  if (seed != 0) begun.start_m = jittered_start(cloth, cloth.garment->material.thickness_m, seed);
  sim::Simulation simulation = make_simulation(awake, begun, bodies);
  // Wall-clock time counts with several threads: their CPU time includes waiting for each other.
  const bool is_alone = awake.simulation.solver.bounded.threads == 1;
  ContactRun run;
  run.seed = seed;
  FrameVerifier verifier;
  const auto judge = [&](int frame, double took_ms, double cpu_ms) -> ContactFrame {
    FrameRecord record = measure_frame(simulation, frame);
    std::string broken = verifier.check(simulation, record);
    if (broken.empty() && !record.bound_kept) {
      broken = fmt::format("frame {}: the solver could not make sure of it", frame);
    }
    const bool is_broken = !broken.empty();
    if (run.first_broken.empty()) run.first_broken = std::move(broken);
    const bool holds_surface = bound_kind(scene) == sim::BoundKind::surface;
    run.stretch = holds_surface ? verifier.largest().surface : verifier.largest().springs;
    return {took_ms,  cpu_ms, simulation.last_report().search.ms, record.contact, record.crossing_pairs.value(),
            is_broken};
  };
  try {
    dress(scene, simulation);
    run.start = judge(0, 0.0, 0.0);
    for (int frame = 1; frame <= frames; ++frame) {
      before_frame(frame, simulation);
      const Stopwatch wall, processors(CLOCK_PROCESS_CPUTIME_ID);
      simulation.advance_frame(throw_if_interrupted);
      const double cpu_ms = processors.elapsed_ms();
      run.frames.push_back(judge(frame, is_alone ? cpu_ms : wall.elapsed_ms(), cpu_ms));
    }
  } catch (const std::exception& error) {
    if (!is_any<PromiseBroken, sim::Diverged, sim::ContactBlocked>(error)) throw;
    end_early(error, run);
  }
  return run;
}

void drag_wind(int frame, int frames, double max_m_per_s, sim::Simulation& simulation) {
  sim::Surroundings surroundings = simulation.surroundings();
  const double part = 2.0 * frame / frames;
  surroundings.forces.wind.speed_m_per_s = max_m_per_s * std::min(part, 2.0 - part);
  simulation.set_surroundings(surroundings);
}

ContactFacts summarise_contact(std::span<const ContactRun> runs) {
  ContactFacts facts;
  std::vector<double> medians_ms;
  double all_ms = 0.0, search_ms = 0.0;
  for (const ContactRun& run : runs) {
    std::vector<double> times_ms;
    facts.passed_runs += run.first_broken.empty() ? 1 : 0;
    facts.stretch = std::max(facts.stretch, run.stretch);
    add(run.start, facts);
    for (const ContactFrame& frame : run.frames) {
      add(frame, facts);
      times_ms.push_back(frame.took_ms);
      all_ms += frame.cpu_ms;
      search_ms += frame.search_ms;
      facts.detections += frame.contact.detections;
      facts.partial_detections += frame.contact.partial_detections;
    }
    facts.frames += times_ms.size();
    if (!times_ms.empty()) {
      medians_ms.push_back(quantile(times_ms, 0.5));
      facts.p99_ms = std::max(facts.p99_ms, quantile(times_ms, 0.99));
      facts.worst_ms = std::max(facts.worst_ms, quantile(times_ms, 1.0));
      facts.slowest_second_ms = std::max(facts.slowest_second_ms, slowest_second_ms(times_ms));
    }
  }
  if (facts.frames > 0) {
    facts.median_ms = median(medians_ms);
    facts.search_share = search_ms / all_ms;
    facts.detections /= static_cast<double>(facts.frames);
    facts.partial_detections /= static_cast<double>(facts.frames);
  }
  return facts;
}

std::vector<ContactCase> all_contact_cases() {
  std::vector<ContactCase> cases;
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.is_of_contact || find_scene(scene.name, {}).dressing_frames() > 0) {
      cases.push_back({scene.name, scene.name});
    }
  }
  cases.push_back({"fine-wind-10", "tshirt-wind-10", {{"garment.subdivisions=1"}}, 60});
  return cases;
}

std::vector<ContactCase> quick_contact_cases() {
  const std::string speed = "wind.speed=20";
  const std::string front = "wind.direction=[0, 0, -1]", side = "wind.direction=[-1, 0, 0]";
  const std::string slanting = "wind.direction=[0.7, 0, -0.7]", below = "wind.direction=[0, 0.5, 0.9]";
  std::vector<ContactCase> cases = {{"hanging", "tshirt-gravity"},
                                    {"wind-1", "tshirt-wind-1"},
                                    {"wind-10", "tshirt-wind-10"},
                                    {"wind-10-around", "tshirt-wind-10", {{front}, {side}, {slanting}, {below}}},
                                    {"wind-10-upwards", "tshirt-wind-10", {{"wind.direction=[0, 1, 0]"}}},
                                    {"wind-20-front", "tshirt-wind-10", {{speed, front}}},
                                    {"wind-20-side", "tshirt-wind-10", {{speed, side}}},
                                    {"slider", "tshirt-wind-10", {{speed}}, 600, true},
                                    {"walking", "tshirt-walk"},
                                    {"hang", "hang"}};
  for (ContactCase& one : cases) one.frames = one.frames.value_or(60);
  return cases;
}

sim::VectorUnit measured_vector_unit() {
  const std::vector<sim::VectorUnit> available = sim::available_vector_units();
  const bool has = std::ranges::find(available, sim::VectorUnit::avx2) != available.end();
  return has ? sim::VectorUnit::avx2 : sim::VectorUnit::best;
}

std::string contact_head(const std::string& vector_unit, int threads) {
  return (threads == 1 ? "Processor time of a frame with contact, on one thread, with "
                       : fmt::format("Wall-clock time of a frame with contact, on {} threads, with ", threads)) +
         vector_unit +
         ". Of several runs the median of their medians, and the worst second, 99th percentile and frame.\n"
         "Searches for what is near: their part of the time, and how many a frame, through all and around "
         "single vertices.\n"
         "Pairs: the most that were kept apart at a time. Distance: the smallest of these pairs when a frame "
         "began, as the solver measured it.\n"
         "Stretch and crossing pairs: of every frame, the start included, by a way that shares nothing with "
         "the solver.\n\n"
         "                                 tri-                   ms a frame               searches          "
         " most  "
         "distance   stretch         crossing  broken  runs\n"
         "scene                          angles  frames   median  second    99 %   worst       %     all  "
         "around    "
         "pairs        mm         %  bound     pairs  frames  passed\n";
}

std::string contact_row(const ContactTrial& trial) {
  const ContactFacts facts = summarise_contact(trial.runs);
  std::string text = fmt::format(
      "{:<30}{:>6}{:>8}{:>9.1f}{:>8.0f}{:>8.0f}{:>8.0f}{:>8.0f}{:>8.1f}{:>8.1f}{:>9}{:>10}{:>10.5f}{:>7}{:>"
      "10}{:>8}  "
      "{}\n",
      trial.scene, trial.triangles, facts.frames, facts.median_ms, facts.slowest_second_ms, facts.p99_ms,
      facts.worst_ms, 100.0 * facts.search_share, facts.detections, facts.partial_detections, facts.max_pairs,
      millimetres(facts.min_distance_m), 100.0 * facts.stretch, fmt::format("{:g} %", 100.0 * trial.bound),
      facts.crossing_pairs, facts.broken_frames, fmt::format("{} of {}", facts.passed_runs, trial.runs.size()));
  for (const ContactRun& run : trial.runs) {
    if (run.first_broken.empty()) continue;
    const std::string start = run.seed == 0 ? "" : fmt::format(", start {}", run.seed);
    text += fmt::format("  {}{}: {}\n", trial.scene, start, run.first_broken);
  }
  return text;
}

std::string contact_csv(std::span<const ContactTrial> trials) {
  CsvTable table(
      "scene,seed,triangles,bound,frames,median_ms,second_ms,p99_ms,worst_ms,search_share,detections,"
      "partial_detections,contact_pairs,smallest_distance_m,max_stretch,crossing_pairs,broken_frames,first_broken");
  for (const ContactTrial& trial : trials) {
    for (const ContactRun& run : trial.runs) {
      const ContactFacts facts = summarise_contact({&run, 1});
      table.add(trial.scene, run.seed, trial.triangles, trial.bound, facts.frames, facts.median_ms,
                facts.slowest_second_ms, facts.p99_ms, facts.worst_ms, facts.search_share, facts.detections,
                facts.partial_detections, facts.max_pairs, facts.min_distance_m, facts.stretch, facts.crossing_pairs,
                facts.broken_frames, run.first_broken);
    }
  }
  return table.text();
}

}  // namespace taut::app
