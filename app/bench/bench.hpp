#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// One frame of a run of a scene about contact, judged by FrameVerifier.
struct ContactFrame {
  double took_ms = 0.0;        ///< processor time of one thread, or wall-clock time of several; 0 of the start
  double cpu_ms = 0.0;         ///< processor time of all threads
  double search_ms = 0.0;      ///< of that the search for what is near
  sim::ContactReport contact;  ///< what the solver says
  std::size_t crossing_pairs = 0;
  bool is_broken = false;  ///< it broke a promise, or the solver says that it could not make sure
};

/// A run of such a scene.
struct ContactRun {
  std::uint64_t seed = 0;            ///< of where it started; 0: where the scene has it
  std::vector<ContactFrame> frames;  ///< those that were computed, after the start
  ContactFrame start;
  double stretch = 0.0;      ///< a fraction: of the worst spring, or triangle where those are held
  std::string first_broken;  ///< what the first frame that broke a promise broke; empty: the run passed
};

/// Runs of a built-in scene.
struct ContactCase {
  std::string name;
  std::string scene;
  std::vector<std::vector<std::string>> runs = {{}};  ///< of each what is not as in the scene: KEY=VALUE
  std::optional<int> frames = {};                     ///< empty: as many as the scene has
  bool drags_wind = false;                            ///< from 0 to the scene's and back, as a slider
};

/// The built-in scenes about contact, those in which something is worn among them, and a fine shirt in wind.
std::vector<ContactCase> all_contact_cases();

/// A shirt that hangs, in winds from several directions and on someone who walks, and a sheet: what decides
/// whether cloth keeps up with the clock.
std::vector<ContactCase> quick_contact_cases();

/// The vectors that are measured: those that most people's processors have.
sim::VectorUnit measured_vector_unit();

/// All runs of a case.
struct ContactTrial {
  std::string scene;
  double bound = 0.0;  ///< the largest stretch that is promised, a fraction
  std::size_t triangles = 0;
  std::vector<ContactRun> runs;
};

/// The summary of all runs of a trial.
struct ContactFacts {
  std::size_t passed = 0;           ///< runs that broke no promise
  std::size_t frames = 0;           ///< of all runs, the starts not counted
  double median_ms = 0.0;           ///< time per frame, the median of the runs'; 0 without frames
  double p99_ms = 0.0;              ///< its 99th percentile in the worst run
  double worst_ms = 0.0;            ///< of the slowest frame
  double second_ms = 0.0;           ///< the mean of the slowest 60 frames in a row
  double search_share = 0.0;        ///< the part of the processor time that the search takes
  double detections = 0.0;          ///< per frame: searches through all
  double partial_detections = 0.0;  ///< per frame: searches around single vertices
  int most_pairs = 0;               ///< near pairs at a time
  double smallest_distance_m = std::numeric_limits<double>::infinity();  ///< as ContactReport has it
  double stretch = 0.0;                                                  ///< the largest, a fraction
  std::size_t crossing_pairs = 0;                                        ///< the sum of all frames
  std::size_t broken_frames = 0;
};

/// How far a start is moved at random, as a part of the cloth's thickness, along each axis both ways.
inline constexpr double jitter_part = 0.05;

/// Returns where the cloth starts, every vertex that is not pinned moved at random by up to jitter_part of
/// `thickness_m` along each axis. The same for the same seed on every machine.
std::vector<sim::Vec3> jittered_start(const GarmentInScene& cloth, double thickness_m, std::uint64_t seed);

/// Runs the scene for `frames` frames from a jittered start, or from its own with the seed 0, and never lets
/// it sleep. Bodies are dressed first; a run of which that fails has no frames. A frame that breaks a promise
/// does not end the run; one that diverges or cannot be made does. `before_frame` is called with the number
/// of every frame. Bodies must have been loaded.
ContactRun run_contact(const Scene& scene, const GarmentInScene& cloth, int frames, std::uint64_t seed,
                       const std::function<void(int, sim::Simulation&)>& before_frame);

/// Sets the wind that a slider has in this frame of so many, dragged evenly from 0 to `most_m_per_s` and
/// back.
void drag_wind(int frame, int frames, double most_m_per_s, sim::Simulation& simulation);

ContactFacts facts_of(std::span<const ContactRun> runs);

/// The lines above the rows, for people.
std::string contact_head(const std::string& vector_unit, int threads);
/// A trial as a row for people, with the first failure of each of its runs below.
std::string contact_row(const ContactTrial& trial);

/// All runs of all trials as a table (CSV), a row for each run.
std::string contact_csv(std::span<const ContactTrial> trials);

}  // namespace taut::app
