#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"
#include "sim/measures.hpp"

namespace taut::app {

/// The cost of one frame, as the engine reports it.
struct FrameCost {
  double cpu_ms = 0.0;  ///< processor time of the whole process, without preparation that every engine needs
  int substeps = 0;
  bool is_certified = true;  ///< false: the engine reports that the bound may not hold
};

/// A cloth engine running on one garment. All engines are driven in the same way and are judged only by their
/// positions.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Advances the cloth by one frame of the scene. Throws sim::Diverged if the engine notices divergence.
  virtual FrameCost advance_frame() = 0;
  /// In metres, per vertex of the garment. Valid until the next frame.
  virtual std::span<const sim::Vec3> positions() const = 0;
};

/// Taut with the scene's solver. The garment never sleeps, so every frame is computed.
std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene);

/// Bullet's substeps per frame, and the iterations of its position solver in each (piterations).
struct BulletSettings {
  int substeps = 1;
  int iterations = 1;
};

/// The garment as a soft body of Bullet, set up for speed: structural springs are links of full stiffness;
/// there is no bending, no volume, no collision and no face. Masses, pins, gravity, drag and wind are those
/// of the garment and the surroundings. Taut computes the wind's forces; that time is not counted. Positions
/// are in single precision, as in Debian's package.
std::unique_ptr<Engine> make_bullet_engine(const sim::Garment& garment, const std::vector<sim::Index>& pins,
                                           const sim::Surroundings& surroundings, double frame_time_s,
                                           const BulletSettings& settings);

/// A scene of the race: the T-shirt of the scene "tshirt-gravity", and the settings that make it this scene.
struct RaceScene {
  std::string name;
  std::vector<std::string> settings;  ///< KEY=VALUE
};
const std::vector<RaceScene>& race_scenes();

/// A size of the garment: a T-shirt model, subdivided some number of times.
struct RaceSize {
  int triangles = 0;     ///< after subdivision
  int model = 0;         ///< triangles of the model file
  int subdivisions = 0;  ///< each makes four triangles of one
};
const std::vector<RaceSize>& race_sizes();

/// The scene at this size, without contact, which no other engine has here.
Scene make_race_scene(const RaceScene& scene, const RaceSize& size);

/// An engine with fixed settings.
struct Entrant {
  std::string engine;
  std::string settings;         ///< for people
  std::optional<double> bound;  ///< the largest stretch that it was asked to keep; empty: none
  std::function<std::unique_ptr<Engine>(const GarmentInScene&, const Scene&)> make;
};

/// The engines that race. The first is the one that is compared with the others.
std::vector<std::string> engine_names();

/// All settings of an engine. An engine with a bound has one entrant for each of `bounds`, any other a
/// series, of which the best for each bound is found after the runs. `full` asks for the longer series.
std::vector<Entrant> entrants_of(const std::string& engine, const std::vector<double>& bounds, bool full);

/// For each bound `bounded` as it is; then holding what it does not hold by default, and without one of its
/// parts at a time.
std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds);

/// One frame of one run, stretch as fractions, measured from positions.
struct FrameSample {
  FrameCost cost;
  sim::Stretch springs;  ///< structural
  sim::SurfaceStretch surface;
};

/// How a run ended.
enum class RunEnd { finished, diverged, too_slow, hopeless };
const char* name_of(RunEnd end);

/// The frames that an entrant computed on one scene.
struct Run {
  Entrant entrant;
  std::vector<FrameSample> frames;
  RunEnd end = RunEnd::finished;
};

/// How long runs are and when a run is stopped early.
struct RaceSettings {
  int frames = 120;
  double slowest_frame_ms = 200.0;  ///< mean processor time per frame; a slower run is too_slow
  double hopeless_stretch = 0.5;    ///< a fraction; a frame with more stretch is hopeless
};

/// Runs all entrants on the scene. They take turns of ten frames each, so that other load on the machine
/// affects all alike.
std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings);

/// A summary of one run: its largest stretches, and the processor time of its frames.
struct RunFacts {
  double median_ms = 0.0, mean_ms = 0.0, p99_ms = 0.0;
  double stretch = 0.0, p99_stretch = 0.0;                  ///< of springs
  double surface_stretch = 0.0, p99_surface_stretch = 0.0;  ///< of triangles
  int median_substeps = 0, not_certified = 0;
};
RunFacts facts_of(const Run& run);

/// Counts the frames whose worst spring exceeds `bound`, without a tolerance. A stretch that is not a number
/// counts as exceeded.
int frames_over(const Run& run, double bound);

/// The engine's run with the smallest median time among those that reached their end and keep the bound in
/// every frame; else the one with the smallest stretch, of those that reached their end if there are any. For
/// an engine with a bound, only the run that was asked for this bound counts. Null if there is none.
const Run* best_run(std::span<const Run> runs, const std::string& engine, double bound);

}  // namespace taut::app
