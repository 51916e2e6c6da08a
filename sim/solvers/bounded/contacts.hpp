#pragma once

#include "sim/contact/neighbour_list.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// What keeps the cloth off obstacles and off itself.
class Contacts {
 public:
  /// Finds the rows that could reach an obstacle within the frame.
  void begin_frame(const Garment& garment, const Pins& pins, const Layout& layout,
                   const Surroundings& surroundings, const Motion& motion, const Float4Array& velocities,
                   double frame_time_s);

  /// After the sweeps of each time step: out of the obstacles, with friction.
  void push_out(const Material& cloth, const Surroundings& surroundings, Motion& motion);

  /// A few times in a frame: moves layers that are too close apart and takes away the speed with which they
  /// approach, but gives them none.
  void part_layers(const Garment& garment, const Layout& layout, double layer_distance_m, Motion& motion);

  /// Of earlier frames: see NeighbourList.
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
