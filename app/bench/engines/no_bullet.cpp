#include <stdexcept>

#include "app/bench/engines/bullet_engine.hpp"

namespace taut::app {

std::string bullet_version() {
  return "";
}

std::unique_ptr<Engine> make_bullet_engine(const sim::Garment&, const std::vector<sim::Index>&,
                                           const sim::Surroundings&, double, const BulletSettings&) {
  throw std::logic_error("this program was built without Bullet");
}

}  // namespace taut::app
