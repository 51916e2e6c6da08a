#pragma once

#include "sim/solvers/explicit_solvers.hpp"
#include "sim/solvers/implicit/system.hpp"

namespace taut::sim {

/// The equations of one projection: as many rows as edges that have a free end. Which entries are not zero,
/// and in which order they are eliminated, is found once.
class LengthSystem {
 public:
  LengthSystem(std::span<const Edge> edges, std::span<const double> rest_lengths_m, const Pins& pins);
  ~LengthSystem();

  /// Returns the largest | |e| / l - 1 | of the edges that have a free end.
  double largest_strain(std::span<const Vec3> positions_m) const;
  /// Moves the free vertices by one projection. Returns false, with nothing moved, where a number is not
  /// finite.
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

/// The settings of `fast-projection`.
struct FastProjectionSettings {
  SpringStiffness stiffness = {};  ///< the structural one is not used: those springs are the constraints
  /// How much longer or shorter than at rest a structural spring may be when projections end. Less takes
  /// more projections.
  double max_strain = 0.05;
  /// The most projections in a time step, at least 1. Where they do not suffice the strain stays larger.
  int most_projections = 20;

  bool operator==(const FastProjectionSettings&) const = default;
};

/// Cloth that keeps its lengths (Goldenthal, Harmon, Fattal, Bercovier and Grinspun 2007). A time step
/// predicts without the constraint, here by backward Euler with the shear and flexural springs, so that it
/// may be long, and then projects: structural springs neither stretch nor shorten. With the constraint of an
/// edge e of length l at rest, C = |e|^2 / l - l, each projection is one step of Newton's method towards C =
/// 0 in directions of the shape that it has reached (implicit constraint direction and fast projection,
/// section 4):
///   (h^2 grad C M^-1 grad C^T) dl = C,   dx = -h^2 M^-1 grad C^T dl.
/// The first is always done: cloth that is only brought back from the threshold vibrates below it.
///
/// On a grid the edges are its warp and weft, as in the paper, and it drapes. A triangle model keeps all its
/// edges: about as many lengths as its vertices have coordinates. It locks: what is left to it is to fold
/// along its edges, like paper. Flat parts make the system singular. Its diagonal is raised by a little, so
/// that it can be solved all the same; lengths that contradict each other are then not kept, nor those next
/// to bodies, out of which the cloth is pushed after the projection.
class FastProjectionSolver : public Solver {
 public:
  /// A frame is divided into `substeps` equal steps, 5 without.
  FastProjectionSolver(const FastProjectionSettings& settings, std::optional<int> substeps);

  FrameReport advance_frame(const Frame& frame, State& state) override;
  // All that it knows is in the state.
  void save(const Garment&, const Pins&, ByteWriter&) const override {}
  void restore(const Frame&, ByteReader&) override {}

 private:
  void prepare(const Garment& garment, const Pins& pins);
  void predict(const Frame& frame, double time_step_s, State& state);
  void project(std::span<Vec3> predicted_m);

  FastProjectionSettings settings_;
  int substeps_;
  std::vector<Index> pinned_;  ///< what is below was made for these pins
  std::unique_ptr<LengthSystem> lengths_;
  implicit::BlockMatrix matrix_;
};

}  // namespace taut::sim
