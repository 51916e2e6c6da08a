#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/types.hpp"

namespace taut::app {

/// What one frame cost an engine, and what the engine says of it.
struct FrameCost {
  double cpu_ms = 0.0;  ///< of the whole process; preparations any engine would need are left out
  int substeps = 0;
  double springs_projected = 0.0;  ///< corrections of one spring, all substeps and iterations together
  bool is_certified = true;        ///< false: the engine itself says that the bound may not hold
};

/// A cloth engine at work on one garment. Engines are driven alike and judged by their positions alone.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Moves on by one frame of the scene. Throws sim::Diverged where the engine finds that itself.
  virtual FrameCost advance_frame() = 0;

  /// What goes on into the next frame, and what is shown and written; in metres, one per vertex; valid
  /// until the next frame.
  virtual std::span<const sim::Vec3> raw_positions() const = 0;
  virtual std::span<const sim::Vec3> shown_positions() const = 0;
};

}  // namespace taut::app
