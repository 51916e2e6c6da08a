#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/drawing/framing.hpp"
#include "app/library/taut.h"
#include "app/runs/frame_verifier.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::library {

/// A body that moves from one shape to another within one frame of the run, each vertex in a straight line. Its frames
/// are counted from 0 s, as for a motion from a file, so that both give the same bits.
class BodyMove final : public sim::BodyFrames {
 public:
  BodyMove(std::vector<sim::Vec3> from_m, std::vector<sim::Vec3> to_m, double from_s, double rate_hz)
      : from_m_(std::move(from_m)),
        to_m_(std::move(to_m)),
        frame_(static_cast<std::size_t>(std::max(std::round(from_s * rate_hz), 0.0))),
        rate_hz_(rate_hz) {
    // A state saved at another frame rate may lie between two frames.
    const double off = from_s * rate_hz - static_cast<double>(frame_);
    first_s_ = std::abs(off) > 1e-6 ? off / rate_hz : 0.0;
  }

  std::size_t count() const override { return frame_ + 2; }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return first_s_; }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    const std::vector<sim::Vec3>& shape_m = frame <= frame_ ? from_m_ : to_m_;
    std::ranges::copy(shape_m, positions_m.begin());
  }

 private:
  std::vector<sim::Vec3> from_m_, to_m_;
  std::size_t frame_;  ///< frame of the run at which the motion begins
  double rate_hz_;
  double first_s_ = 0.0;
};

/// A body that keeps its shape.
class StillBody final : public sim::BodyFrames {
 public:
  explicit StillBody(std::vector<sim::Vec3> shape_m) : shape_m_(std::move(shape_m)) {}

  std::size_t count() const override { return 1; }
  double rate_hz() const override { return 1.0; }
  void positions_in(std::size_t /*frame*/, std::span<sim::Vec3> positions_m) const override {
    std::ranges::copy(shape_m_, positions_m.begin());
  }

 private:
  std::vector<sim::Vec3> shape_m_;
};

/// A caller's mesh that is a body.
struct CallerBody {
  app::FileVertexPlaces places;
  std::size_t vertices = 0;                             ///< vertices of the caller's mesh
  std::optional<std::vector<sim::Vec3>> target_m = {};  ///< positions at the end of the next frame, per vertex of the
                                                        ///< body
};

/// A caller's body in a form that can be added to a scene.
struct GivenBody {
  sim::Body body;
  app::BodySource source = {};
  std::shared_ptr<const app::Wearer> wearer = {};  ///< null: not dressed
  std::optional<CallerBody> lent = {};             ///< caller's mesh; empty: a plane
  std::vector<std::string> remarks = {};           ///< guesses and repairs
};

/// Converts a body for a scene. Throws ArgumentError, and InputError for a mesh that is not closed.
GivenBody take_body(const TautBody* body, const app::Scene& scene);

/// Receiver of messages about guesses, repairs and choices.
struct Listener {
  TautLog log = nullptr;
  void* user = nullptr;

  void tell(const std::vector<std::string>& lines) const;
};

/// A scene with its bodies and its garment, ready to start.
struct Start {
  app::DrawnScene scene;
  app::LoadedBodies bodies;
  app::LoadedGarment loaded;
  std::map<std::size_t, CallerBody> lent = {};  ///< key: body number
  std::size_t crossings = 0;                    ///< see TautInfo::crossings_at_start
  Listener listener = {};                       ///< receives the messages of later calls
};

/// Loads the scene, garment and bodies of the options and sends messages to their log. Throws ArgumentError, and as
/// find_scene(), take_body(), load_bodies(), load_garment() and put_where_it_begins() do.
Start load(const TautOptions& options);

/// A cloth of the library: the simulation of a scene, as the program runs it, and the pins and bodies that the caller
/// moves. Vertices are numbered as in the caller's mesh, or in a scene's simulated mesh. Calls throw ArgumentError for
/// arguments that are not valid, and then change nothing.
class Session {
 public:
  /// Throws as make_simulation() and go_to_start() do.
  Session(const TautOptions& options, Start start);

  const app::DrawnScene& scene() const { return scene_; }
  const std::vector<sim::Body>& bodies() const { return bodies_.all; }
  const sim::Simulation& simulation() const { return simulation_; }
  const app::GarmentInScene& garment() const { return loaded_; }
  int frame() const { return frame_; }

  /// Simulates a frame. Throws sim::ContactBlocked, which leaves the state unchanged, and sim::Diverged.
  app::FrameRecord step();

  // Settings, forces and pins. All throw as sim::Simulation does.
  void set(const std::string& key, const std::string& value);
  void set_wind(const sim::Vec3& velocity_m_per_s);
  void set_gravity(const sim::Vec3& gravity_m_per_s2);
  void set_forces(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& forces_n);
  void set_pins(const std::vector<sim::Index>& vertices);
  std::vector<sim::Index> pins() const;
  void move_pins(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& targets_m);

  /// Adds a body, logs its crossings with the cloth and returns its number. Throws as take_body() does.
  std::size_t add_body(const TautBody* body);
  std::size_t crossings_at_start() const { return crossings_at_start_; }
  /// Number of positions of a body's mesh.
  std::size_t positions_of_body(std::size_t body) const { return lent_body(body).vertices; }
  void move_body(std::size_t body, const std::vector<sim::Vec3>& positions_m);
  void place_body(std::size_t body, const std::vector<sim::Vec3>& positions_m);

  // Shape of the cloth, per vertex of the caller.
  std::size_t vertex_count() const { return mesh_vertex_.size(); }
  std::vector<sim::Vec3> positions_m() const;
  void set_positions(const std::vector<sim::Vec3>& positions_m);
  std::vector<double> stretch() const;
  /// Returns the first of the caller's vertices that became this mesh vertex.
  sim::Index vertex_of(sim::Index mesh_vertex) const { return own_vertex_[mesh_vertex]; }

  std::string save() const;
  /// Restores a checkpoint. `name` is its source, for messages. Throws InputError.
  void restore(const std::filesystem::path& name, const app::RunCheckpoint& checkpoint);

 private:
  const CallerBody& lent_body(std::size_t body) const;
  std::vector<sim::Vec3> to_body_positions(const CallerBody& lent, const std::vector<sim::Vec3>& positions_m) const;
  std::vector<sim::Vec3> shape_m(std::size_t body) const;
  void set_shape(std::size_t body, std::vector<sim::Vec3> positions_m);
  sim::Surroundings surroundings_of(const app::Scene& scene) const;
  /// Throws sim::Diverged if a position is not finite or too far away.
  void require_not_diverged() const;
  void change(app::DrawnScene next);
  void apply_targets(sim::Surroundings& surroundings) const;
  void stay_at_targets();
  void forget_targets();
  void begin_again();
  sim::Index mesh_vertex(sim::Index vertex) const;
  /// Returns the vector at rest from a vertex of the caller's following model to the simulated vertex that represents
  /// it; otherwise 0.
  sim::Vec3 vertex_offset_m(sim::Index in_mesh, sim::Index own) const;
  std::vector<sim::Vec3> to_mesh_positions(const std::vector<sim::Vec3>& positions_m) const;

  app::DrawnScene scene_;
  app::LoadedBodies bodies_;
  app::GarmentInScene loaded_;
  std::vector<sim::Index> mesh_vertex_;  ///< mesh vertex of each of the caller's vertices, or sim::no_vertex
  std::vector<sim::Index> own_vertex_;   ///< caller's vertex of each mesh vertex
  sim::Simulation simulation_;
  int frame_ = 0;
  std::optional<app::FrameVerifier> verifier_;
  std::vector<sim::PointForce> forces_;              ///< forces on mesh vertices, in addition to the scene's
  std::map<sim::Index, sim::Vec3> pin_targets_m_;    ///< pin positions at the end of the next frame; key: mesh vertex
  std::map<std::size_t, CallerBody> caller_bodies_;  ///< key: body number
  std::size_t crossings_at_start_;
  Listener listener_;
};

}  // namespace taut::library
