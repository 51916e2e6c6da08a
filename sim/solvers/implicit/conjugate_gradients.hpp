#pragma once

#include <span>

#include "sim/solvers/implicit/block_matrix.hpp"

namespace taut::sim::implicit {

/// The modified preconditioned conjugate gradients of Baraff and Witkin 1998, section 5.3: solves A x = b in
/// the rows of the vertices that are free, while the others keep what `x` holds for them. Filtered, a vector
/// is 0 at vertices that are not free (inverse mass 0). The preconditioner is the inverse of A's diagonal
/// blocks, where the paper takes the diagonal. Ends where the residual has fallen below `tolerance` times
/// the first one, by the norm of the preconditioner, or after three times as many iterations as
/// there are vertices, which is all that exact numbers would take. Returns the iterations done. The spans
/// have one entry per vertex; A must be positive definite.
int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x);

}  // namespace taut::sim::implicit
