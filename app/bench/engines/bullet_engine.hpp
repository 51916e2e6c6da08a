#pragma once

#include <memory>
#include <string>

#include "app/bench/engines/engine.hpp"
#include "sim/pins.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// The version of Bullet that was compiled in, or nothing where it was not there.
std::string bullet_version();

struct BulletSettings {
  int substeps = 1;
  int iterations = 1;  ///< of Bullet's position solver in each substep (piterations)
};

/// The garment as a soft body of Bullet, set up for speed: structural springs as links of full stiffness, no
/// bending, no volume, no collisions, no faces. Masses, pins and their motion, gravity, drag and the forces
/// of the wind are the garment's and the surroundings'; the wind's are computed by Taut and cost Bullet
/// nothing. Single precision, as Debian's package has it. Throws std::logic_error where Bullet was not
/// compiled in.
std::unique_ptr<Engine> make_bullet_engine(const sim::Garment& garment, const std::vector<sim::Index>& pins,
                                           const sim::Surroundings& surroundings, double frame_time_s,
                                           const BulletSettings& settings);

}  // namespace taut::app
