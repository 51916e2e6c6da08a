#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// What one frame cost an engine, and what the engine says of it.
struct FrameCost {
  double cpu_ms = 0.0;  ///< of the whole process; preparations any engine would need are left out
  int substeps = 0;
  double springs_projected = 0.0;  ///< corrections of one spring, all substeps and iterations together
  bool is_certified = true;        ///< false: the engine itself says that the bound may not hold
  /// Of the worst spring before the engine's last correction; none where it makes no such correction.
  std::optional<double> raw_stretch;
};

/// A cloth engine at work on one garment. Engines are driven alike and judged by their positions alone.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Moves on by one frame of the scene. Throws sim::Diverged where the engine finds that itself.
  virtual FrameCost advance_frame() = 0;

  /// In metres, one per vertex; valid until the next frame.
  virtual std::span<const sim::Vec3> positions() const = 0;
};

}  // namespace taut::app
