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

/// Cost of one frame, as the engine reports it.
struct FrameCost {
  double cpu_ms = 0.0;  ///< CPU time of the whole process, without preparation that every engine needs
  int substeps = 0;
  bool is_certified = true;  ///< false: the engine reports that the bound may not hold
};

/// A cloth engine with one garment. All engines are driven in the same way and judged only by their positions.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Advances the cloth by one frame of the scene. Throws sim::Diverged if the engine notices divergence.
  virtual FrameCost advance_frame() = 0;
  /// Returns positions in metres, per vertex of the garment. They are valid until the next frame.
  virtual std::span<const sim::Vec3> positions() const = 0;
};

/// Makes an engine of Taut with the scene's solver. The garment never sleeps, so every frame is computed.
std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene);

/// Bullet's substeps per frame, and the iterations of its position solver in each (piterations).
struct BulletSettings {
  int substeps = 1;
  int iterations = 1;
};

/// Makes an engine with the garment as a soft body of Bullet, set up for speed: structural springs are links of full
/// stiffness; there is no bending, volume, collision or face. Masses and pins are the garment's; gravity, drag and wind
/// are the surroundings'. Taut computes the wind's forces, whose time is not counted. Positions are in single
/// precision, as in Debian's package.
std::unique_ptr<Engine> make_bullet_engine(const sim::Garment& garment, const std::vector<sim::Index>& pins,
                                           const sim::Surroundings& surroundings, double frame_time_s,
                                           const BulletSettings& settings);

/// Scene of the race: the T-shirt of the scene "tshirt-gravity" with these settings.
struct RaceScene {
  std::string name;
  std::vector<std::string> settings;  ///< KEY=VALUE
};
const std::vector<RaceScene>& race_scenes();

/// Size of the garment: a T-shirt model, subdivided some number of times.
struct RaceSize {
  int triangles = 0;     ///< triangles after subdivision
  int model = 0;         ///< triangles of the model file
  int subdivisions = 0;  ///< each divides a triangle into four
};
const std::vector<RaceSize>& race_sizes();

/// Returns the scene at this size, without contact, which no other engine has here.
Scene make_race_scene(const RaceScene& scene, const RaceSize& size);

/// An engine with fixed settings.
struct Entrant {
  std::string engine;
  std::string settings;         ///< settings as text
  std::optional<double> bound;  ///< requested bound on stretch; empty: none
  std::function<std::unique_ptr<Engine>(const GarmentInScene&, const Scene&)> make;
};

/// Returns the names of the engines. The first is compared with the others.
std::vector<std::string> engine_names();

/// Returns all settings of an engine. An engine with a bound has one entrant for each of `bounds`. Any other has a
/// series, whose best entrant for each bound is found after the runs; `full` selects the longer series.
std::vector<Entrant> list_entrants(const std::string& engine, const std::vector<double>& bounds, bool full);

/// Returns for each bound the solver `bounded` with its defaults, with its bound on springs alone, and with one of its
/// parts left out at a time.
std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds);

/// One frame of one run. Stretch is measured from positions, as fractions.
struct FrameSample {
  FrameCost cost;
  sim::Stretch springs;  ///< structural springs
  sim::SurfaceStretch surface;
};

/// End of a run.
enum class RunEnd { finished, diverged, too_slow, hopeless };
const char* to_name(RunEnd end);

/// Frames that an entrant computed on one scene.
struct Run {
  Entrant entrant;
  std::vector<FrameSample> frames;
  RunEnd end = RunEnd::finished;
};

/// Length of the runs, and limits that stop a run early.
struct RaceSettings {
  int frames = 120;
  double slowest_frame_ms = 200.0;  ///< mean CPU time per frame; a slower run is too_slow
  double hopeless_stretch = 0.5;    ///< a fraction; a frame with more stretch is hopeless
};

/// Runs all entrants on the scene. They take turns of ten frames each, so that other load on the machine affects all
/// equally.
std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings);

/// Summary of one run: its largest stretches, and the CPU time of its frames.
struct RunFacts {
  double median_ms = 0.0, mean_ms = 0.0, p99_ms = 0.0;
  double stretch = 0.0, p99_stretch = 0.0;                  ///< springs
  double surface_stretch = 0.0, p99_surface_stretch = 0.0;  ///< triangles
  int median_substeps = 0, not_certified = 0;
};
RunFacts summarise_run(const Run& run);

/// Counts the frames whose worst spring exceeds `bound`, without a tolerance. A stretch that is not a number counts as
/// exceeded.
int frames_over(const Run& run, double bound);

/// Returns the engine's run with the smallest median time among the finished runs that keep the bound in every frame;
/// else the finished run with the smallest stretch, or any run if none finished. For an engine with a bound, only the
/// run with this bound counts. Null if there is none.
const Run* best_run(std::span<const Run> runs, const std::string& engine, double bound);

}  // namespace taut::app
