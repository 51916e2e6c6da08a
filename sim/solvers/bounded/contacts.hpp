#pragma once

#include "sim/contact/neighbour_list.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// Keeps the cloth away from bodies and its layers away from each other.
class Contacts {
 public:
  /// Finds the rows that could reach a body within the frame, which begins at `time_s`: all, if a body moves.
  /// `velocities` has one entry per row, in m/s.
  void begin_frame(const Garment& garment, const Pins& pins, const Layout& layout,
                   const Surroundings& surroundings, const Motion& motion, const Float4Array& velocities,
                   double time_s, double frame_time_s);

  /// Moves cloth out of the bodies, with friction. Call it after the sweeps of each time step.
  void push_out(const Material& cloth, const Surroundings& surroundings, const TimeSpan& step,
                Motion& motion);

  /// Moves layers apart that are too close. It removes their speed of approach and adds no other speed. Call
  /// it a few times per frame.
  void part_layers(const Garment& garment, const Layout& layout, double layer_distance_m, Motion& motion);

  /// Saves and restores what is kept from earlier frames; see NeighbourList.
  void save(ByteWriter& memory) const { layers_.save(memory); }
  void restore(const Garment& garment, ByteReader& memory) {
    layers_.restore(garment.mesh.positions, memory);
  }

 private:
  std::vector<Index> near_rows_;
  std::vector<double> near_inverse_masses_per_kg_;
  std::vector<Vec3> near_current_m_;
  std::vector<Vec3> near_predicted_m_;
  std::vector<Vec3> positions_m_;
  NeighbourList layers_;
};

}  // namespace taut::sim::bounded
