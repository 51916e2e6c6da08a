#pragma once

#include "sim/bytes.hpp"
#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/substep_control.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim::bounded {

/// Motion of the vertices in earlier regions, from which the next motion is predicted.
struct RowMemory {
  Float4Array velocities;         ///< mean velocities over the last regions, in m/s
  Float4Array accelerations;      ///< smoothed accelerations, at most those of a fall, in m/s^2
  std::vector<float> deviations;  ///< deviations from the predicted motion, in m
  double elapsed_s = 0.0;         ///< duration of the last observation
  bool is_touching = false;       ///< something was near

  void resize(std::size_t rows);

  /// Learns from the displacements at both ends of a time, in m. Accelerations above `max_acceleration_m_per_s2`, in
  /// m/s^2, count as trembling and are limited.
  void observe(std::size_t rows, const Float4Array& before, const Float4Array& after, double elapsed_s,
               float max_acceleration_m_per_s2);

  /// Returns the relative speed of neighbours in the cloth, without the fastest ones.
  double relative_speed_m_per_s(std::span<const Triangle> triangles) const;

  bool is_empty() const { return velocities.empty(); }
  void save(std::size_t rows, ByteWriter& memory) const;
  /// Requires the same number of vertices. Throws BadBytes.
  void restore(std::size_t rows, ByteReader& memory);
};

/// Memory of contact from frame to frame.
struct ContactMemory {
  RowMemory rows;  ///< empty if contact was off
  /// A crossing was accepted in the last frame; the next one searches for all crossings.
  bool may_have_crossed = false;
  /// Bodies at the start, and triangles that cross since then; empty before the first frame.
  std::optional<std::vector<Body>> bodies = {};
  std::vector<ExcludedTriangle> excluded_triangles = {};
};

/// Memory of the tension law from frame to frame; empty without a law.
struct ElasticMemory {
  /// Low-passed tension along warp and weft and in shear, by block of surface lanes.
  std::vector<SurfaceSums> tension_n_per_m;
  /// Tension that shortens rest shapes so that triangles reach the length of the law.
  std::vector<SurfaceSums> shortening_n_per_m;
};

/// Everything that `bounded` keeps from frame to frame besides the State. An attempt at a frame makes a new Memory from
/// the old one; a kept frame assigns it.
struct Memory {
  std::vector<Index> pins;  ///< pinned vertices at the time of this memory
  SubstepControl control;
  Float4Array corrections;    ///< corrections of the last frame's projection by solver index, in m
  Float4Array wind_velocity_m_per_s;  ///< see SlowForces::begin_attempt; empty before the first frame
  ContactMemory contact;
  ElasticMemory elastic;
  double shift_ratio = 0.0;  ///< largest correction of the last frame, as a fraction of the largest allowed
  double median_work = 0.0;  ///< median work of frames, in sweeps; 0 before the first
};

void save(const Memory& memory, std::size_t vertex_count, ByteWriter& bytes);
/// Requires a memory made for the same garment, pins and settings. `row_count` includes padding. Throws BadBytes.
void restore(const Frame& frame, std::size_t row_count, ByteReader& bytes, Memory& memory);

}  // namespace taut::sim::bounded
