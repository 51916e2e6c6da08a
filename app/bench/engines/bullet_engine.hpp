#pragma once

#include <memory>
#include <string>

#include "app/bench/engines/engine.hpp"
#include "sim/pins.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// The version of Bullet that was compiled in, or an empty text if Bullet is not compiled in.
std::string bullet_version();

/// What a frame costs Bullet.
struct BulletSettings {
  int substeps = 1;    ///< per frame
  int iterations = 1;  ///< of Bullet's position solver in each substep (piterations)
};

/// The garment as a soft body of Bullet, set up for speed: structural springs are links of full stiffness;
/// there is no bending, no volume, no collision and no face. Masses, pins, gravity, drag and wind are those
/// of the garment and the surroundings. Taut computes the wind's forces; that time is not counted. Positions
/// are in single precision, as in Debian's package. Throws std::logic_error if Bullet is not compiled in.
std::unique_ptr<Engine> make_bullet_engine(const sim::Garment& garment, const std::vector<sim::Index>& pins,
                                           const sim::Surroundings& surroundings, double frame_time_s,
                                           const BulletSettings& settings);

}  // namespace taut::app
