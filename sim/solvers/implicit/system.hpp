#pragma once

#include "sim/garment.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/step.hpp"

namespace taut::sim::implicit {

using Mat3 = glm::dmat3;

/// A condition that cloth opposes: a number C that is 0 at rest, by the positions x_i of up to four vertices (Baraff
/// and Witkin 1998, section 4.1). Its energy is 1/2 k C^2.
struct Condition {
  double value = 0.0;
  int count = 0;                    ///< of the vertices
  std::array<Index, 4> vertices{};  ///< each once
  std::array<Vec3, 4> gradients{};  ///< dC / dx_i
  /// d2C / dx_i dx_j = weights[i] weights[j] curvature, as far as it is used; never negative definite.
  std::array<double, 4> weights{};
  Mat3 curvature = Mat3(0.0);
};

/// A triangle with its warp and weft at rest. w_u and w_v, the derivatives of positions by lengths at rest
/// along warp and weft (eq. 9), are sums of the corners times weights.
struct WovenTriangle {
  Triangle corners{};
  std::array<double, 3> along_warp{}, along_weft{};  ///< weights of the corners, per m
  double root_area_m = 0.0;                          ///< of the area at rest
};

/// Two triangles at an edge.
struct Hinge {
  std::array<Index, 4> vertices{};  ///< the edge's ends, the third corner of one triangle and of the other
  double rest_angle_rad = 0.0;
  /// Times the bending rigidity: the stiffness, |edge|^2 / (sum of both areas). Gives a sheet that is bent
  /// to a cylinder the energy of a plate, on grids and on equilateral triangles.
  double shape = 0.0;
};

/// Returns the triangles that have a surface. The warp of a grid runs down its columns; that of any other
/// triangle along its first side, as models bring none.
std::vector<WovenTriangle> woven_triangles(const Garment& garment);
/// Returns the edges at which two triangles with a surface meet.
std::vector<Hinge> hinges(const Garment& garment);

/// Returns w_u or w_v, by the weights for it.
Vec3 derivative(const WovenTriangle& triangle, const std::array<double, 3>& weights, std::span<const Vec3> positions_m);

/// A spring: C = its length minus that at rest, in m, so that 1/2 k C^2 is Hooke's law.
Condition spring_condition(const Edge& ends, double rest_length_m, std::span<const Vec3> positions_m);
/// Stretch, eq. (10), along the direction of the weights: C = sqrt(a) (|w| - 1) for the area a. The paper
/// multiplies by a. With its root the stiffness is in N/m and does not depend on the mesh.
Condition stretch_condition(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                            std::span<const Vec3> positions_m);
/// Shear, section 4.3: C = sqrt(a) w_u . w_v. Its second derivative is not definite and left out.
Condition shear_condition(const WovenTriangle& triangle, std::span<const Vec3> positions_m);
/// Bend, section 4.3: C = angle between the triangles minus that at rest, in radians, towards -pi to pi. Its
/// second derivative is left out. 0 where a triangle has collapsed.
Condition bend_condition(const Hinge& hinge, std::span<const Vec3> positions_m);

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
