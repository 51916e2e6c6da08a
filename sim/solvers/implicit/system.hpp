#pragma once

#include "sim/garment.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/step.hpp"

namespace taut::sim::implicit {

using Mat3 = glm::dmat3;

/// Condition function of the cloth: a number C(x) of up to four positions x_i, 0 at rest (Baraff and Witkin 1998,
/// section 4.1). Its energy is 1/2 k C^2.
struct Condition {
  double value = 0.0;
  int count = 0;                    ///< number of vertices
  std::array<Index, 4> vertices{};  ///< distinct
  std::array<Vec3, 4> gradients{};  ///< dC / dx_i
  /// d2C / dx_i dx_j = weights[i] weights[j] curvature, or 0 where it is left out; never negative definite.
  std::array<double, 4> weights{};
  Mat3 curvature = Mat3(0.0);
};

/// Triangle with its warp and weft at rest. w_u and w_v, the derivatives of position by rest length along warp and weft
/// (eq. 9), are weighted sums of the corners.
struct WovenTriangle {
  Triangle corners{};
  std::array<double, 3> along_warp{}, along_weft{};  ///< corner weights, per m
  double root_area_m = 0.0;                          ///< square root of the rest area
};

/// Two triangles that share an edge.
struct Hinge {
  std::array<Index, 4> vertices{};  ///< ends of the edge, then the third corner of each triangle
  double rest_angle_rad = 0.0;
  /// Stiffness per bending rigidity, |edge|^2 / (sum of both areas). A sheet bent to a cylinder has the energy of a
  /// plate, on grids and on equilateral triangles.
  double shape = 0.0;
};

/// Returns the triangles that have a surface. On a grid the warp runs down its columns; elsewhere along a triangle's
/// first side, as models define none.
std::vector<WovenTriangle> woven_triangles(const Garment& garment);
/// Returns the edges at which two triangles with a surface meet.
std::vector<Hinge> hinges(const Garment& garment);

/// Returns w_u or w_v from its weights.
Vec3 derivative(const WovenTriangle& triangle, const std::array<double, 3>& weights, std::span<const Vec3> positions_m);

/// Spring: C = length - rest length in m, so that 1/2 k C^2 is Hooke's law.
Condition spring_condition(const Edge& ends, double rest_length_m, std::span<const Vec3> positions_m);
/// Stretch, eq. (10), along the direction of the weights: C = sqrt(a) (|w| - 1) with the area a. The paper multiplies
/// by a. With the root the stiffness is in N/m and does not depend on the mesh.
Condition stretch_condition(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                            std::span<const Vec3> positions_m);
/// Shear, section 4.3: C = sqrt(a) w_u . w_v. Its second derivative is indefinite and left out.
Condition shear_condition(const WovenTriangle& triangle, std::span<const Vec3> positions_m);
/// Bend, section 4.3: C = angle between the triangles minus its rest value, in radians, -pi to pi. Its second
/// derivative is left out. C is 0 if a triangle has collapsed.
Condition bend_condition(const Hinge& hinge, std::span<const Vec3> positions_m);

using Mat3 = glm::dmat3;

/// Symmetric matrix of 3 x 3 blocks, one row and one column per vertex. All blocks are stored.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// Blocks that may differ from 0 couple each vertex with itself and the vertices of `pairs`, which may repeat.
  BlockMatrix(std::size_t vertex_count, std::span<const Edge> pairs);

  void clear();
  /// Requires one of the pairs given to the constructor. The blocks of a row are in column order.
  Mat3& at(Index row, Index column);
  const Mat3& diagonal(Index row) const { return blocks_[diagonals_[row]]; }
  /// Fills `product` with the matrix times `vector`; both have one entry per vertex.
  void multiply(std::span<const Vec3> vector, std::span<Vec3> product) const;

 private:
  CompressedRows columns_;
  std::vector<std::size_t> diagonals_;
  std::vector<Mat3> blocks_;
};

/// Linear system of one step of backward Euler (Baraff and Witkin 1998, section 3, eq. 6, times the mass):
///   (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v)
/// for the change dv of the velocities v in a time step h.
struct System {
  double time_step_s = 0.0;
  std::span<const Vec3> velocities_m_per_s;
  BlockMatrix& matrix;
  std::span<Vec3> right_side;  ///< right side, in N s
};

/// Stiffness of a condition, and its damping as a fraction of that per unit of time.
struct Stiffness {
  double k = 0.0;
  double damping_s = 0.0;
};

/// Adds inertia, with blocks m (1 + h c), and `forces_n`. c is the rate of the drag -m c v that the forces contain.
void add_inertia(std::span<const double> masses_kg, std::span<const Vec3> forces_n, double air_drag_per_s,
                 const System& system);

/// Adds a condition's force with damping (eqs. 7 and 11), f_i = -(k C + d dC/dt) dC/dx_i with d = damping_s k, and its
/// derivatives (eqs. 8 and 12). Terms that would make the matrix indefinite are left out: terms with the second
/// derivative of C where k C + d dC/dt is negative, as in compressed cloth, and asymmetric terms.
void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system);

/// Solves A x = b for the free vertices by the modified preconditioned conjugate gradients of Baraff and Witkin 1998,
/// section 5.3. Other vertices (inverse mass 0) keep their value in `x`; filtered vectors are 0 there. The
/// preconditioner is the inverse of A's diagonal blocks, where the paper takes the diagonal. It ends when the residual,
/// in the norm of the preconditioner, is below `tolerance` times the first one, or after three iterations per vertex,
/// which would suffice in exact arithmetic. Returns the number of iterations. The spans have one entry per vertex; A
/// must be positive definite.
int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x);

/// Adds all conditions at the current positions to a system.
using AddConditions = std::function<void(const State& state, const System& system)>;

/// Fills the predicted positions by one step of backward Euler, p(t + h) = p(t) + h (v + dv); pins follow the
/// surroundings. External forces are those at the start of the step; only the drag of the air is implicit. `matrix`
/// must have a block for every pair joined by a condition. For `tolerance` see solve().
void predict(const Frame& frame, double time_step_s, double tolerance, const AddConditions& add_conditions,
             BlockMatrix& matrix, State& state);

}  // namespace taut::sim::implicit
