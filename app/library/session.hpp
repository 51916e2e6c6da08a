#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/library/taut.h"
#include "app/output/frame_verifier.hpp"
#include "app/output/run_checkpoint.hpp"

namespace taut::library {

/// A body that goes from one shape to another within one frame of the run, each vertex in a straight line.
/// Its frames are counted from 0 s, as those of a file's motion are: the bits are the same.
class WayOfBody final : public sim::BodyFrames {
 public:
  WayOfBody(std::vector<sim::Vec3> from_m, std::vector<sim::Vec3> to_m, double from_s, double rate_hz)
      : from_m_(std::move(from_m)),
        to_m_(std::move(to_m)),
        frame_(static_cast<std::size_t>(std::max(std::round(from_s * rate_hz), 0.0))),
        rate_hz_(rate_hz) {
    // A state that was saved at another rate is between two frames.
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
  std::size_t frame_;  ///< of the run, with which the way begins
  double rate_hz_;
  double first_s_ = 0.0;
};

/// A body that stays in a shape.
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

/// A mesh of a caller that is a body.
struct LentBody {
  app::FileVertexPlaces places;
  std::size_t vertices = 0;                             ///< that the caller's mesh has
  std::optional<std::vector<sim::Vec3>> target_m = {};  ///< of the next frame, per vertex of the body
};

/// A body of a caller as a scene has it.
struct GivenBody {
  sim::Body body;
  app::BodySource source = {};
  std::shared_ptr<const app::Wearer> wearer = {};  ///< null: it is not dressed
  std::optional<LentBody> lent = {};               ///< empty: a plane
  std::vector<std::string> remarks = {};           ///< what was guessed and repaired
};

/// Takes a body, for a scene with these frames. Throws ArgumentError, and InputError on a mesh that is not
/// closed.
GivenBody take_body(const TautBody* body, const app::Scene& scene);

/// Adds it to the bodies of the scene and returns its number.
std::size_t put_in(const GivenBody& given, app::Scene& scene);

/// Who is told what was guessed, repaired or chosen.
struct Listener {
  TautLog log = nullptr;
  void* user = nullptr;

  void tell(const std::vector<std::string>& lines) const;
};

/// A scene as it begins, made of what a caller says.
struct Start {
  app::Scene scene;
  app::LoadedGarment loaded;
  std::map<std::size_t, LentBody> lent = {};  ///< by the number of the body
  std::size_t crossings = 0;                  ///< as TautInfo has them
  Listener listener = {};                     ///< of later calls
};

/// Reads what the options name and tells their log what was guessed. Throws ArgumentError, and as
/// find_scene(), take_body(), load_bodies(), load_garment() and put_where_it_begins() do.
Start load(const TautOptions& options);

/// A cloth of the library: the simulation of a scene as the program runs it, and what a caller leads in it.
/// Vertices are the caller's: those of the mesh that was given, or of the simulated mesh. Calls throw
/// ArgumentError on arguments that cannot be used, and have changed nothing then.
class Session {
 public:
  /// Throws as make_simulation() and go_to_start() do.
  Session(const TautOptions& options, Start start);

  const sim::Simulation& simulation() const { return simulation_; }
  int frame() const { return frame_; }

  /// Throws sim::ContactBlocked with everything as it was, and sim::Diverged.
  app::FrameRecord step();

  // Forces on the cloth. Each throws as sim::Simulation does.
  void set(const std::string& key, const std::string& value);
  void set_wind(const sim::Vec3& velocity_m_per_s);
  void set_gravity(const sim::Vec3& gravity_m_per_s2);
  void set_forces(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& forces_n);
  void set_pins(const std::vector<sim::Index>& vertices);
  std::vector<sim::Index> pins() const;
  void move_pins(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& targets_m);

  /// Returns its number, and tells what is wrong with where it is. Throws as take_body() does.
  std::size_t add_body(const TautBody* body);
  std::size_t crossings_at_start() const { return crossings_at_start_; }
  /// How many positions the mesh of a body was given with.
  std::size_t positions_of_body(std::size_t body) const { return lent_body(body).vertices; }
  void move_body(std::size_t body, const std::vector<sim::Vec3>& positions_m);
  void place_body(std::size_t body, const std::vector<sim::Vec3>& positions_m);

  // The shape, by the caller's vertices.
  std::size_t vertex_count() const { return mesh_vertex_.size(); }
  std::vector<sim::Vec3> positions_m() const;
  void set_positions(const std::vector<sim::Vec3>& positions_m);
  std::vector<double> stretch() const;
  /// The caller's vertex for one of the simulated mesh: the first that became it.
  sim::Index vertex_of(sim::Index mesh_vertex) const { return own_vertex_[mesh_vertex]; }

  std::string save() const;
  /// `name` is where the checkpoint is from, for messages. Throws InputError.
  void restore(const std::filesystem::path& name, const app::RunCheckpoint& checkpoint);

 private:
  const LentBody& lent_body(std::size_t body) const;
  std::vector<sim::Vec3> in_body(const LentBody& lent, const std::vector<sim::Vec3>& positions_m) const;
  std::vector<sim::Vec3> shape_m(std::size_t body) const;
  void set_shape(std::size_t body, std::vector<sim::Vec3> positions_m);
  sim::Surroundings surroundings_of(const app::Scene& scene) const;
  /// Throws sim::Diverged while the cloth is lost.
  void require_found() const;
  void change(app::Scene next);
  void apply_targets(sim::Surroundings& surroundings) const;
  void stay_at_targets();
  void forget_targets();
  void begin_again();
  sim::Index mesh_vertex(sim::Index vertex) const;
  /// From a vertex of the caller's, where the model follows, to the simulated one that stands for it, at
  /// rest.
  sim::Vec3 beside_own_m(sim::Index in_mesh, sim::Index own) const;
  std::vector<sim::Vec3> in_mesh(const std::vector<sim::Vec3>& positions_m) const;

  app::Scene scene_;
  app::GarmentInScene loaded_;
  std::vector<sim::Index> mesh_vertex_;  ///< per vertex of the caller, or sim::no_vertex
  std::vector<sim::Index> own_vertex_;   ///< per vertex of the mesh
  sim::Simulation simulation_;
  int frame_ = 0;
  std::optional<app::FrameVerifier> verifier_;
  std::vector<sim::PointForce> forces_;            ///< besides those of the scene; vertices of the mesh
  std::map<sim::Index, sim::Vec3> pin_targets_m_;  ///< of the next frame; vertices of the mesh
  std::map<std::size_t, LentBody> lent_;           ///< by the number of the body
  std::size_t crossings_at_start_;
  Listener listener_;
};

}  // namespace taut::library
