#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <array>
#include <vector>

/// The incremental potential of cloth (Li, Ferguson and others 2020; Li, Kaufman and Jiang 2021), whose minima are
/// shapes at rest. It shares no code with the solvers of this project: see README.md.
namespace reference {

using Point = Eigen::Vector3d;
/// Positions or forces of all vertices, as x y z x y z.
using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Corners = std::array<int, 3>;

/// An isotropic fabric without lateral contraction.
struct Fabric {
  double density_kg_per_m2 = 0.0;
  double stiffness_n_per_m = 0.0;  ///< tension over strain
  double rigidity_n_m = 0.0;       ///< moment over curvature, per width
  double thickness_m = 0.0;        ///< distance at which the barrier begins
};

/// A cloth, its pins and the ball below it.
struct Cloth {
  std::vector<Point> rest_m;
  std::vector<Corners> triangles;
  std::vector<int> pins;
  Fabric fabric;
  double gravity_m_per_s2 = 9.81;
  /// Pinned vertex without triangles, the centre of a ball that cloth cannot enter; -1: none.
  int ball = -1;
  double ball_radius_m = 0.0;
};

/// Energy of up to four vertices, with its derivatives.
struct Local {
  std::array<int, 4> vertices = {};
  int count = 0;
  double energy = 0.0;
  Eigen::Matrix<double, 12, 1> gradient = Eigen::Matrix<double, 12, 1>::Zero();
  Eigen::Matrix<double, 12, 12> hessian = Eigen::Matrix<double, 12, 12>::Zero();
};

struct Energies {
  double stretch = 0.0, bend = 0.0, weight = 0.0, barrier = 0.0;
  double sum() const { return stretch + bend + weight + barrier; }
};

/// Two primitives that could touch: a vertex and a triangle, or two edges.
struct Pair {
  std::array<int, 4> vertices = {};
  bool is_of_edges = false;
  double offset_m = 0.0;           ///< distance at which they touch
  double parallel_below_m4 = 0.0;  ///< squared doubled area of two edges below which the barrier fades
};

/// Shortest vector sum c_i x_i between two primitives. To first order it does not change with the free parameters.
struct Closest {
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  std::array<Eigen::Vector4d, 2> free = {};  ///< derivatives of the weights
  int free_count = 0;
  double squared_m2 = 0.0;
};
Closest find_closest(const Pair& pair, const std::array<Point, 4>& x);

/// Returns the largest fraction of the step, at most 1, that leaves the pair a tenth of its distance (additive
/// continuous collision detection, Li, Kaufman and Jiang 2021).
double step_that_keeps_apart(const Pair& pair, std::array<Point, 4> x, std::array<Point, 4> by);

class Potential {
 public:
  explicit Potential(Cloth cloth);

  const Cloth& cloth() const { return cloth_; }
  const std::vector<double>& masses_kg() const { return masses_kg_; }
  std::size_t vertex_count() const { return cloth_.rest_m.size(); }

  /// Returns the energies, which are not finite if a triangle has no area or two primitives touch.
  Energies energies(const Vector& x) const;
  /// Returns the gradient, which is 0 at pins.
  Vector gradient(const Vector& x) const;
  /// Returns the Hessian, which has the identity at pins. If `is_projected`, each energy's part is made positive
  /// semidefinite.
  Matrix hessian(const Vector& x, bool is_projected) const;
  /// Returns the largest fraction of a step, at most 1, along which nothing touches.
  double max_step(const Vector& x, const Vector& by) const;

  Local stretch_of(const Vector& x, std::size_t triangle, bool has_hessian = true) const;
  Local bend_of(const Vector& x, std::size_t hinge, bool has_hessian = true) const;
  Local barrier_of(const Vector& x, const Pair& pair, bool has_hessian = true) const;
  /// Returns all pairs that come nearer than the barrier's reach during the step.
  std::vector<Pair> pairs_near(const Vector& x, const Vector& by) const;

 private:
  struct Hinge {
    std::array<int, 4> vertices;  ///< ends of the edge, and the two opposite vertices
    double stiffness;             ///< energy = stiffness / 2 angle^2
  };

  template <class Use> void for_each(const Vector& x, bool has_hessian, const Use& use) const;
  void find_hinges();

  Cloth cloth_;
  std::vector<char> is_pinned_;
  std::vector<double> masses_kg_;
  std::vector<double> areas_m2_;
  std::vector<Eigen::Matrix<double, 3, 2>> shape_;  ///< F = sum x_i row_i
  std::vector<std::array<int, 2>> edges_;
  std::vector<Hinge> hinges_;
};

struct Descent {
  double max_force = 1e-4;  ///< largest force on a vertex, in mean vertex weights
  int max_steps = 1000;
  double max_move_m = 0.05;  ///< largest movement of a vertex in a step
};

struct Rest {
  Vector x;
  int steps = 0;
  double max_force = 0.0;  ///< see Descent
  bool is_stable = false;  ///< the Hessian is positive definite
};

/// Returns the largest force on a vertex, in mean vertex weights.
double max_force(const Potential& potential, const Vector& x);

/// Minimises by Newton's method, projected where necessary, with a line search in which nothing touches. Nothing may
/// touch in the shape `x` either.
Rest minimise(const Potential& potential, Vector x, const Descent& descent);

Vector flatten(const std::vector<Point>& points);
Point at(const Vector& x, int vertex);

}  // namespace reference
