#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Cloth that one engine simulates with fixed settings.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Computes a frame. Returns its CPU time in ms; Bullet's is without the wind, which is Taut's own code. Throws
  /// sim::Diverged, Interrupted.
  virtual double advance_frame() = 0;
  virtual std::span<const sim::Vec3> positions() const = 0;
};

/// Time steps of a frame, and sweeps over all links in each.
struct BulletSettings {
  int substeps = 1;
  int iterations = 1;
};

/// Makes a soft body of Bullet with the cloth's structural springs as links. `cloth` must outlive it.
std::unique_ptr<Engine> make_bullet_engine(const GarmentInScene& cloth, const Scene& scene,
                                           const BulletSettings& settings);

/// An engine with fixed settings.
struct Entrant {
  std::string engine;
  std::string settings;         ///< settings as text
  std::optional<double> bound;  ///< requested bound on stretch; empty: none
  std::function<std::unique_ptr<Engine>(const GarmentInScene&, const Scene&)> make;
};

/// Returns `bounded` with each of the bounds.
std::vector<Entrant> taut_entrants(const std::vector<double>& bounds);
/// Returns Bullet with several divisions of a frame, whose best for each bound is found after the runs.
std::vector<Entrant> bullet_entrants();

/// A frame of a run. Stretch is measured from positions, as fractions.
struct RaceFrame {
  double cpu_ms = 0.0;
  double stretch = 0.0;  ///< largest of the structural springs
  double surface_stretch = 0.0;
};

/// Frames that an entrant computed on one scene.
struct Run {
  Entrant entrant;
  std::vector<RaceFrame> frames;
  std::string given_up;  ///< reason why the run ended early; empty: it did not

  double max_stretch() const;
};

/// Lets all entrants compute `frames` frames, ten at a time in turns, so that a busy machine hinders all alike. A run
/// that takes more than `max_frame_ms` a frame in the mean, or stretches by half, is given up.
std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene, int frames,
                      double max_frame_ms);

/// Returns the engine's fastest run that keeps the bound in every frame, or else the one that comes closest; null if it
/// has none. A run that asked for another bound is no candidate.
const Run* best_run(std::span<const Run> runs, const std::string& engine, double bound);

}  // namespace taut::app
