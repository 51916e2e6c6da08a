#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "race.hpp"
#include "sim/measures.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

btVector3 to_bullet(const sim::Vec3& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

sim::Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

// Bullet's world with everything that it requires, although nothing collides in it.
struct World {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver rigid_solver;
  btSoftRigidDynamicsWorld dynamics{&dispatcher, &broadphase, &rigid_solver, &configuration};
};

// Origin for Bullet's positions: in single precision, the fall of one substep is lost in positions far from the origin.
sim::Vec3 compute_centre(const sim::Garment& garment) {
  sim::Vec3 sum(0.0);
  for (const sim::Vec3& position : garment.mesh.positions) sum += position;
  return sum / static_cast<double>(garment.mesh.positions.size());
}

std::unique_ptr<btSoftBody> make_body(btSoftBodyWorldInfo& world, const sim::Garment& garment, const sim::Pins& pins,
                                      const sim::Vec3& origin_m) {
  const std::size_t count = garment.mesh.positions.size();
  btAlignedObjectArray<btVector3> nodes;
  btAlignedObjectArray<btScalar> masses;
  for (std::size_t v = 0; v < count; ++v) {
    nodes.push_back(to_bullet(garment.mesh.positions[v] - origin_m));
    const bool is_pinned = pins.inverse_masses_per_kg[v] == 0.0;
    masses.push_back(is_pinned ? 0.0F : static_cast<btScalar>(garment.masses_kg[v]));
  }
  auto body = std::make_unique<btSoftBody>(&world, static_cast<int>(count), &nodes[0], &masses[0]);
  body->m_materials[0]->m_kLST = 1.0F;
  for (std::size_t s = 0; s < garment.springs.structural_count; ++s) {
    const auto [i, j] = garment.springs.ends[s];
    body->appendLink(static_cast<int>(i), static_cast<int>(j), body->m_materials[0]);
  }
  return body;
}

class BulletEngine : public Engine {
 public:
  BulletEngine(const GarmentInScene& cloth, const Scene& scene, const BulletSettings& settings)
      : garment_(*cloth.garment),
        pins_(cloth.pins),
        surroundings_(scene.surroundings),
        substeps_(settings.substeps),
        substep_s_(1.0 / (scene.simulation.frame_rate_hz * settings.substeps)),
        origin_m_(compute_centre(garment_)),
        state_(sim::make_state(garment_)) {
    // Soft bodies have their own gravity, which the world's does not change.
    world_.dynamics.getWorldInfo().m_gravity = to_bullet(surroundings_.forces.gravity_m_per_s2);
    body_ = make_body(world_.dynamics.getWorldInfo(), garment_, sim::make_pins(garment_, pins_), origin_m_);
    body_->m_cfg.piterations = settings.iterations;
    body_->m_cfg.collisions = 0;
    // Bullet removes this fraction of the velocity in every substep, whatever its length.
    body_->m_cfg.kDP = static_cast<btScalar>(surroundings_.forces.air_drag_per_s * substep_s_);
    body_->setActivationState(DISABLE_DEACTIVATION);
    world_.dynamics.addSoftBody(body_.get());
    state_.time_step_s = substep_s_;
  }

  ~BulletEngine() override { world_.dynamics.removeSoftBody(body_.get()); }

  double advance_frame() override {
    double cpu_ms = 0.0;
    for (int substep = 0; substep < substeps_; ++substep) {
      throw_if_interrupted();
      add_wind();
      move_pins();
      const Stopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
      world_.dynamics.stepSimulation(static_cast<btScalar>(substep_s_), 0);
      cpu_ms += clock.elapsed_ms();
      state_.time_s += substep_s_;
    }
    read_state();
    const std::size_t lost = sim::first_lost(state_.current);
    if (lost < state_.current.size()) throw sim::Diverged(static_cast<sim::Index>(lost), state_.time_s);
    return cpu_ms;
  }

  std::span<const sim::Vec3> positions() const override { return state_.current; }

 private:
  void read_state() {
    for (std::size_t v = 0; v < state_.current.size(); ++v) {
      const btSoftBody::Node& node = body_->m_nodes[static_cast<int>(v)];
      state_.current[v] = from_bullet(node.m_x) + origin_m_;
      state_.previous[v] = state_.current[v] - substep_s_ * from_bullet(node.m_v);
    }
  }

  void add_wind() {
    read_state();
    forces_n_.assign(state_.current.size(), sim::Vec3(0.0));
    sim::add_wind_forces(garment_, state_, surroundings_.forces.wind, {}, substep_s_, forces_n_);
    for (std::size_t v = 0; v < forces_n_.size(); ++v) body_->addForce(to_bullet(forces_n_[v]), static_cast<int>(v));
  }

  void move_pins() {
    if (surroundings_.pin_motion.amplitude_m == sim::Vec3(0.0)) return;
    const sim::Vec3 offset = sim::pin_displacement(surroundings_.pin_motion, {0.0, state_.time_s + substep_s_});
    for (const sim::Index pin : pins_) {
      body_->m_nodes[static_cast<int>(pin)].m_x = to_bullet(garment_.mesh.positions[pin] + offset - origin_m_);
    }
  }

  const sim::Garment& garment_;
  const std::vector<sim::Index>& pins_;
  sim::Surroundings surroundings_;
  int substeps_;
  double substep_s_;
  sim::Vec3 origin_m_;  ///< origin of Bullet's coordinates
  sim::State state_;    ///< state of Bullet's nodes, for the wind and for positions()
  std::vector<sim::Vec3> forces_n_;
  World world_;
  std::unique_ptr<btSoftBody> body_;
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine(const GarmentInScene& cloth, const Scene& scene,
                                           const BulletSettings& settings) {
  return std::make_unique<BulletEngine>(cloth, scene, settings);
}

}  // namespace taut::app
