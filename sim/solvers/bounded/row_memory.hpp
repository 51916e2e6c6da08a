#pragma once

#include "sim/bytes.hpp"
#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

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

}  // namespace taut::sim::bounded
