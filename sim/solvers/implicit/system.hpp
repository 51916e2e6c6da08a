#pragma once

#include "sim/mesh/adjacency.hpp"
#include "sim/solvers/implicit/conditions.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/step.hpp"

namespace taut::sim::implicit {

using Mat3 = glm::dmat3;

/// A symmetric matrix of 3 x 3 blocks, a row and a column for each vertex. All blocks are stored.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// The blocks that may differ from 0: those of each vertex with itself and those of `pairs`, which may
  /// repeat.
  BlockMatrix(std::size_t vertex_count, std::span<const Edge> pairs);

  void clear();
  /// Requires that the pair is one of those above. A row's blocks are in the order of their columns.
  Mat3& at(Index row, Index column);
  const Mat3& diagonal(Index row) const { return blocks_[diagonals_[row]]; }
  /// Fills `product` with the matrix times `vector`; one entry per vertex.
  void multiply(std::span<const Vec3> vector, std::span<Vec3> product) const;

 private:
  CompressedRows columns_;
  std::vector<std::size_t> diagonals_;
  std::vector<Mat3> blocks_;
};

/// The linear system of one step of backward Euler (Baraff and Witkin 1998, section 3, eq. 6, times the
/// mass):
///   (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v)
/// for the change dv of the velocities v in a time step h.
struct System {
  double time_step_s = 0.0;
  std::span<const Vec3> velocities_m_per_s;
  BlockMatrix& matrix;
  std::span<Vec3> right_side;  ///< in N s
};

/// How a condition is opposed: its stiffness, and its damping as a fraction of that per unit of time.
struct Stiffness {
  double k = 0.0;
  double damping_s = 0.0;
};

/// Adds inertia, whose blocks are m (1 + h c), and the forces `forces_n`; c is what the forces contain of a
/// drag, -m c v.
void add_inertia(std::span<const double> masses_kg, std::span<const Vec3> forces_n, double air_drag_per_s,
                 const System& system);

/// Adds a condition's force with damping (eqs. 7 and 11), f_i = -(k C + d dC/dt) dC/dx_i with d = damping_s
/// k, and its derivatives (eqs. 8 and 12). Terms are left out that would make the matrix indefinite: those
/// with the second derivative of C where k C + d dC/dt is negative, as in cloth that is pressed together, and
/// those that are not symmetric.
void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system);

/// The modified preconditioned conjugate gradients of Baraff and Witkin 1998, section 5.3: solves A x = b in
/// the rows of the vertices that are free, while the others keep what `x` holds for them. Filtered, a vector
/// is 0 at vertices that are not free (inverse mass 0). The preconditioner is the inverse of A's diagonal
/// blocks, where the paper takes the diagonal. Ends where the residual has fallen below `tolerance` times
/// the first one, by the norm of the preconditioner, or after three times as many iterations as
/// there are vertices, which is all that exact numbers would take. Returns the iterations done. The spans
/// have one entry per vertex; A must be positive definite.
int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x);

/// Adds what the cloth opposes in the current positions to a system.
using AddConditions = std::function<void(const State& state, const System& system)>;

/// Fills the predicted positions by one step of backward Euler, p(t + h) = p(t) + h (v + dv), where pins move
/// as the surroundings have it. External forces are those of the step's beginning; the drag of the air alone
/// is implicit too. `matrix` must have a block for every pair that a condition joins. For `tolerance` see
/// solve().
void predict(const Frame& frame, double time_step_s, double tolerance, const AddConditions& add_conditions,
             BlockMatrix& matrix, State& state);

}  // namespace taut::sim::implicit
