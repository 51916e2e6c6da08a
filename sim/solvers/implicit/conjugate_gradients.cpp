#include "sim/solvers/implicit/conjugate_gradients.hpp"

#include <cassert>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace taut::sim::implicit {
namespace {

double product(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    sum += glm::dot(a[v], b[v]);
  }
  return sum;
}

/// The inverse diagonal blocks, filtered: 0 at vertices that are not free.
std::vector<Mat3> preconditioner(const BlockMatrix& a, std::span<const double> inverse_masses_per_kg) {
  std::vector<Mat3> inverses(inverse_masses_per_kg.size(), Mat3(0.0));
  for (std::size_t v = 0; v < inverses.size(); ++v) {
    if (inverse_masses_per_kg[v] > 0.0) {
      inverses[v] = glm::inverse(a.diagonal(static_cast<Index>(v)));
    }
  }
  return inverses;
}

void apply(const std::vector<Mat3>& blocks, std::span<const Vec3> vector, std::span<Vec3> result) {
  for (std::size_t v = 0; v < blocks.size(); ++v) {
    result[v] = blocks[v] * vector[v];
  }
}

/// y += factor x
void add(double factor, std::span<const Vec3> x, std::span<Vec3> y) {
  for (std::size_t v = 0; v < x.size(); ++v) {
    y[v] += factor * x[v];
  }
}

}  // namespace

int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x) {
  assert(b.size() == x.size() && inverse_masses_per_kg.size() == x.size());
  const std::vector<Mat3> inverses = preconditioner(a, inverse_masses_per_kg);
  std::vector<Vec3> residual(x.size()), search(x.size()), image(x.size()), preconditioned(x.size());
  // r = b - A x; the preconditioner filters, so that r itself need not be.
  a.multiply(x, image);
  residual.assign(b.begin(), b.end());
  add(-1.0, image, residual);
  apply(inverses, residual, search);
  double error = product(residual, search);
  const double least = tolerance * tolerance * error;
  const int most = 3 * static_cast<int>(x.size());
  int iteration = 0;
  for (; iteration < most && error > least; ++iteration) {
    a.multiply(search, image);
    const double step = error / product(search, image);
    add(step, search, x);
    add(-step, image, residual);
    apply(inverses, residual, preconditioned);
    const double before = error;
    error = product(residual, preconditioned);
    for (std::size_t v = 0; v < search.size(); ++v) {
      search[v] = preconditioned[v] + (error / before) * search[v];
    }
  }
  return iteration;
}

}  // namespace taut::sim::implicit
