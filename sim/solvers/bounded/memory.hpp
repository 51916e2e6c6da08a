#pragma once

#include "sim/bytes.hpp"
#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/substep_control.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim::bounded {

/// Motion of the rows in earlier regions, from which their next positions are predicted.
struct RowMemory {
  Float4Array velocities;         ///< lasting ones, in m/s
  Float4Array accelerations;      ///< lasting ones, no larger than a fall's, in m/s^2
  std::vector<float> deviations;  ///< how far rows went from where they were expected, in m
  double elapsed_s = 0.0;         ///< the time that they were last observed over
  bool is_touching = false;       ///< something was near

  void resize(std::size_t rows);

  /// Learns from displacements at both ends of a time, in m. More acceleration than `most_acceleration`, in
  /// m/s^2, is trembling.
  void observe(std::size_t rows, const Float4Array& before, const Float4Array& after, double elapsed_s,
               float most_acceleration);

  /// Returns the speed at which neighbours in the cloth move against each other, but for the fastest.
  double relative_speed_m_per_s(std::span<const Triangle> triangles) const;

  bool is_empty() const { return velocities.empty(); }
  void save(std::size_t rows, ByteWriter& memory) const;
  /// Requires as many rows. Throws BadBytes.
  void restore(std::size_t rows, ByteReader& memory);
};

/// The memory of contact from frame to frame.
struct ContactMemory {
  RowMemory rows;  ///< empty where contact was off
  /// A crossing was accepted in the last frame, so that the next one looks for all that crosses.
  bool may_have_crossed = false;
  /// The bodies among which the cloth began, and triangles that cross since then; empty: no frame began yet.
  std::optional<std::vector<Body>> bodies = {};
  std::vector<LeftOutTriangle> left_out = {};
};

/// The memory of the law of cloth in its plane from frame to frame; empty where it has none.
struct ElasticMemory {
  /// By block of the surface's lanes, low-passed, along warp and weft and in shear.
  std::vector<SurfaceSums> tension_n_per_m;
  /// The tension of triangles that have the length that the law gives them, by which their rest shapes are
  /// shorter.
  std::vector<SurfaceSums> held_n_per_m;
};

/// Everything that `bounded` keeps from frame to frame besides the State. An attempt at a frame makes a new
/// Memory of the old one; a frame that ends well is an assignment.
struct Memory {
  std::vector<Index> pins;  ///< the pinned vertices of the cloth that this is about
  SubstepControl control;
  Float4Array corrections;    ///< of the last frame's projection; by row, in m
  Float4Array blown_m_per_s;  ///< see SlowForces::begin_attempt; empty before the first frame
  ContactMemory contact;
  ElasticMemory elastic;
  double shift = 0.0;        ///< the largest correction of the last frame, as a fraction of the largest allowed
  double median_work = 0.0;  ///< of frames, in sweeps; 0 before the first
};

void save(const Memory& memory, std::size_t vertex_count, ByteWriter& bytes);
/// Requires a memory made for the same garment, pins and settings. `row_count` includes spare rows. Throws
/// BadBytes.
void restore(const Frame& frame, std::size_t row_count, ByteReader& bytes, Memory& memory);

}  // namespace taut::sim::bounded
