#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tailor/mannequin/body.hpp"
#include "tailor/mannequin/polygonise.hpp"

namespace taut::tailor {
namespace {

constexpr double cell_m = 0.0125;
constexpr double accepted_m = 2e-4;
constexpr double damping = 0.7;  // parts flow into each other, so each correction changes other girths

/// Returns the height of the surface's uppermost point at this x, in metres.
double top_m(const sim::Mesh& mesh, double x) {
  double top = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = mesh.positions[t[k]];
      const Vec3& b = mesh.positions[t[(k + 1) % 3]];
      if ((a.x < x) != (b.x < x)) {
        top = std::max(top, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y));
      }
    }
  }
  return top;
}

/// Scales every section by the wanted over the measured girth, and lifts the shoulders. Returns the largest error in
/// metres.
double correct(Body& body, std::vector<std::vector<double>>& factors, const sim::Mesh& whole) {
  const double lift = body.shoulder_tip_m.y - top_m(whole, body.shoulder_tip_m.x);
  body.shape.chains[1].frame.origin_m.y += damping * lift;
  double worst = std::abs(lift);
  std::vector<std::size_t> knots(factors.size(), 0);
  for (const Tape& tape : body.tapes) {
    const double found_m = girth_m(whole, tape);
    factors[tape.chain][knots[tape.chain]++] *= 1.0 + damping * (tape.girth_m / found_m - 1.0);
    worst = std::max(worst, std::abs(found_m - tape.girth_m));
  }
  for (const std::size_t chain : {0U, 2U, 3U}) {
    body.shape.chains[chain].set_factors(factors[chain]);
  }
  return worst;
}

void put_on_surface(const Shape& shape, sim::Mesh& half) {
  for (Vec3& p : half.positions) {
    p = on_surface(shape, p);
  }
}

}  // namespace

FittedBody fit(Body& body) {
  std::vector<std::vector<double>> factors;
  for (const Chain& chain : body.shape.chains) {
    factors.emplace_back(chain.girths_m.size(), 1.0);
  }
  const double top_m = body.shape.chains[0].sized_m.back();
  const Vec3 high_m = {0.62 * top_m, top_m + 0.05, 0.3};
  const auto extract = [&] {
    return polygonise_left_half(body.shape, {0.0, -2.0 * cell_m - 0.003, -0.3}, high_m, cell_m);
  };
  sim::Mesh rough = extract();
  for (int i = 0; i < 8; ++i) {
    correct(body, factors, with_mirror_image(rough));
    rough = extract();
  }
  FittedBody fitted;
  fitted.half = even_out(body.shape, rough, 12);
  for (int i = 0; i < 40; ++i) {
    put_on_surface(body.shape, fitted.half);
    fitted.whole = with_mirror_image(fitted.half);
    const std::vector<Chain> measured = body.shape.chains;
    fitted.worst_error_m = correct(body, factors, fitted.whole);
    if (fitted.worst_error_m < accepted_m) {
      body.shape.chains = measured;
      return fitted;
    }
  }
  throw std::runtime_error("girths or shoulders are off by up to " +
                           std::to_string(1e3 * fitted.worst_error_m) + " mm");
}

}  // namespace taut::tailor
