#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// A frame of a contact run, judged by FrameVerifier.
struct ContactFrame {
  double took_ms = 0.0;        ///< CPU time of one thread, or wall-clock time of several; 0 for the start
  double cpu_ms = 0.0;         ///< CPU time of all threads
  double search_ms = 0.0;      ///< CPU time of the contact search, a part of cpu_ms
  sim::ContactReport contact;  ///< the solver's report
  std::size_t crossing_pairs = 0;
  bool is_broken = false;  ///< breaks a promise, or the solver could not make sure of its promises
};

/// A run of a scene with contact.
struct ContactRun {
  std::uint64_t seed = 0;            ///< seed of the random start; 0: the scene's own start
  std::vector<ContactFrame> frames;  ///< computed frames, without the start
  ContactFrame start;
  double stretch = 0.0;      ///< largest stretch of any spring, or of any triangle if the bound is on the surface; a
                             ///< fraction
  std::string first_broken;  ///< message about the first broken promise; empty: the run passed
};

/// Runs of a built-in scene.
struct ContactCase {
  std::string name;
  std::string scene;
  std::vector<std::vector<std::string>> runs = {{}};  ///< overrides of the scene in each run, as KEY=VALUE
  std::optional<int> frames = {};                     ///< frames of each run; empty: as many as the scene has
  bool drags_wind = false;                            ///< changes the wind from 0 to the scene's speed and back, as a
                                                      ///< slider does
};

/// Returns the built-in scenes with contact or with a dressed body, and a fine shirt in wind.
std::vector<ContactCase> all_contact_cases();

/// Returns the scenes that decide whether cloth runs in real time: a hanging shirt, shirts in winds from several
/// directions and on a walking body, and a sheet.
std::vector<ContactCase> quick_contact_cases();

/// Returns the vector unit to measure with: AVX2, which most processors have, or else the best available.
sim::VectorUnit measured_vector_unit();

/// All runs of a case.
struct ContactTrial {
  std::string scene;
  double bound = 0.0;  ///< largest promised stretch, a fraction
  std::size_t triangles = 0;
  std::vector<ContactRun> runs;
};

/// The summary of all runs of a trial.
struct ContactFacts {
  std::size_t passed_runs = 0;      ///< runs that broke no promise
  std::size_t frames = 0;           ///< frames of all runs, without the starts
  double median_ms = 0.0;           ///< median of the runs' median times per frame; 0 without frames
  double p99_ms = 0.0;              ///< 99th percentile of the time per frame in the worst run
  double worst_ms = 0.0;            ///< time of the slowest frame
  double slowest_second_ms = 0.0;   ///< mean time of the slowest 60 consecutive frames
  double search_share = 0.0;        ///< fraction of the CPU time that the contact search takes
  double detections = 0.0;          ///< full contact searches per frame
  double partial_detections = 0.0;  ///< contact searches around single vertices, per frame
  int max_pairs = 0;                ///< largest number of near pairs at one time
  double min_distance_m = std::numeric_limits<double>::infinity();  ///< smallest distance of a near pair at the
                                                                    ///< start of a frame (ContactReport)
  double stretch = 0.0;                                             ///< largest stretch, a fraction
  std::size_t crossing_pairs = 0;                                   ///< sum of all frames
  std::size_t broken_frames = 0;
};

/// Largest random shift of a start along each axis, as a fraction of the cloth's thickness.
inline constexpr double jitter_fraction = 0.05;

/// Returns the cloth's start positions, in which every free vertex is moved at random by up to jitter_fraction times
/// `thickness_m` along each axis. The same seed gives the same result on every machine.
std::vector<sim::Vec3> jittered_start(const GarmentInScene& cloth, double thickness_m, std::uint64_t seed);

/// Runs the scene for `frames` frames and never lets it sleep. Starts from a jittered start, or with seed 0 from the
/// scene's own. Bodies must be loaded; they are dressed first, and if dressing fails the run has no frames. A frame
/// that breaks a promise does not end the run; a frame that diverges or is blocked does. Calls `before_frame` with the
/// number of every frame.
ContactRun run_contact(const Scene& scene, const GarmentInScene& cloth, const std::vector<sim::Body>& bodies,
                       int frames, std::uint64_t seed, const std::function<void(int, sim::Simulation&)>& before_frame);

/// Sets the wind of one of `frames` frames, in which a slider is dragged evenly from 0 to `max_m_per_s` and back.
void drag_wind(int frame, int frames, double max_m_per_s, sim::Simulation& simulation);

ContactFacts summarise_contact(std::span<const ContactRun> runs);

/// Returns the table's head, in plain text.
std::string contact_head(const std::string& vector_unit, int threads);
/// Returns the table's row of a trial, followed by the first failure of each run.
std::string contact_row(const ContactTrial& trial);

/// Returns all runs of all trials as CSV, a row for each run.
std::string contact_csv(std::span<const ContactTrial> trials);

}  // namespace taut::app
