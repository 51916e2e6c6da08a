#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// What one frame cost an engine, and what the engine reports about it.
struct FrameCost {
  /// Processor time of the whole process. Preparation that every engine needs is not counted.
  double cpu_ms = 0.0;
  int substeps = 0;
  double projections = 0.0;  ///< corrections of one spring or triangle, over all substeps and iterations
  bool is_certified = true;        ///< false: the engine reports that the bound may not hold
  /// Stretch of the worst spring before the engine's last correction, a fraction. Empty if there is no such
  /// correction.
  std::optional<double> raw_stretch;
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

}  // namespace taut::app
