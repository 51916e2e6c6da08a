#pragma once

#include "sim/solvers/explicit_solvers.hpp"
#include "sim/solvers/implicit/system.hpp"

namespace taut::sim {

/// Linear system of one projection, with one row per edge that has a free end. The sparsity pattern and the elimination
/// order are found once.
class LengthSystem {
 public:
  LengthSystem(std::span<const Edge> edges, std::span<const double> rest_lengths_m, const Pins& pins);
  ~LengthSystem();

  /// Returns the largest | |e| / l - 1 | of the edges with a free end.
  double find_max_strain(std::span<const Vec3> positions_m) const;
  /// Moves the free vertices by one projection. Returns false and moves nothing if a number is not finite.
  bool project(std::span<Vec3> positions_m);

 private:
  struct Factors;

  void fill(std::span<const Vec3> positions_m);
  Vec3 gradient(std::size_t edge, Index end, std::span<const Vec3> positions_m) const;

  std::vector<Edge> edges_;
  std::vector<double> rest_lengths_m_;
  std::vector<double> inverse_masses_per_kg_;
  std::unique_ptr<Factors> factors_;
};

/// Settings of `fast-projection`.
struct FastProjectionSettings {
  SpringStiffness stiffness = {};  ///< the structural value is not used: those springs are the constraints
  /// Largest relative length error of structural springs at which projections end. Lower values take more projections.
  double max_strain = 0.05;
  /// Largest number of projections per time step, at least 1. If they do not suffice, the strain stays larger.
  int max_projections = 20;

  bool operator==(const FastProjectionSettings&) const = default;
};

/// Inextensible cloth (Goldenthal, Harmon, Fattal, Bercovier and Grinspun 2007). A time step first predicts without the
/// constraint, by backward Euler with the shear and flexural springs, so that it may be long. Then it projects:
/// structural springs neither stretch nor shorten. With the constraint C = |e|^2 / l - l of an edge e of rest length l,
/// each projection is one Newton step towards C = 0 in directions of the shape reached so far (implicit constraint
/// direction and fast projection, section 4):
///   (h^2 grad C M^-1 grad C^T) dl = C,   dx = -h^2 M^-1 grad C^T dl.
/// At least one projection is done: cloth that is only projected from the threshold vibrates below it.
///
/// On a grid the edges are its warp and weft, as in the paper, and it drapes. On a triangle model all edges are
/// constraints: about as many as coordinates of vertices. It locks and only folds along its edges, like paper. Flat
/// parts make the system singular, so its diagonal is raised slightly. Contradictory lengths are then not kept, and
/// neither are lengths next to bodies, out of which the cloth is pushed after the projection.
class FastProjectionSolver : public Solver {
 public:
  /// `substeps` is the number of equal steps per frame, 5 if not set.
  FastProjectionSolver(const FastProjectionSettings& settings, std::optional<int> substeps);

  FrameReport advance_frame(const Frame& frame, State& state) override;
  // The solver has no memory besides the state.
  void save(const Garment&, const Pins&, ByteWriter&) const override {}
  void restore(const Frame&, ByteReader&) override {}

 private:
  void prepare(const Garment& garment, const Pins& pins);
  void predict(const Frame& frame, double time_step_s, State& state);
  void project(std::span<Vec3> predicted_m);

  FastProjectionSettings settings_;
  int substeps_;
  std::vector<Index> pinned_;  ///< pins for which the members below were made
  std::unique_ptr<LengthSystem> lengths_;
  implicit::BlockMatrix matrix_;
};

}  // namespace taut::sim
