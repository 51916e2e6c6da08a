#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "tests/study/claims/truth.hpp"

namespace taut::app {
namespace {

/// A mode of bending a plate out of its plane: slopes and curvatures at a point.
struct Mode {
  double x, y, xx, yy, xy;
};

/// Returns polynomials along the length, times 1, y and y^2 across. None has a slope at the clamp, but torsion may
/// build up within a fraction of the width.
std::vector<Mode> modes_at(double x, double y, double width) {
  std::vector<Mode> modes;
  for (int j = 0; j < 3; ++j) {
    const double across = std::pow(y, j), d = j == 0 ? 0.0 : j == 1 ? 1.0 : 2.0 * y, dd = j == 2 ? 2.0 : 0.0;
    const auto add = [&](double f, double df, double ddf) {
      modes.push_back({df * across, f * d, ddf * across, f * dd, df * d});
    };
    for (int i = 2; i <= 6; ++i) add(std::pow(x, i), i * std::pow(x, i - 1), i * (i - 1) * std::pow(x, i - 2));
    const double rate = 4.0 / width, faded = std::exp(-rate * x);
    if (j == 1) add(x - (1.0 - faded) / rate, 1.0 - faded, rate * faded);
  }
  return modes;
}

}  // namespace

double weight_that_buckles(double width) {
  constexpr double lateral_contraction = 1.0 / 3.0;
  constexpr int along = 160, across = 40;
  const auto count = std::ssize(modes_at(0.0, 0.0, width));
  // Only the lower triangles of these symmetric matrices are set.
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count, count), released = stiffness;
  for (int point = 0; point < along * across; ++point) {
    const double x = (point / across + 0.5) / along, y = width * ((point % across + 0.5) / across - 0.5);
    // Stresses in the plane by the weight beyond the point, in equilibrium and with free edges: bending, and its shear.
    const double beyond = 1.0 - x, over = 2.0 * y / width;
    const double n_xx = 6.0 * beyond * beyond * y / (width * width), n_xy = 1.5 * beyond * (over * over - 1.0);
    const double n_yy = 0.25 * width * (over * over * over - over);
    const std::vector<Mode> modes = modes_at(x, y, width);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      for (std::ptrdiff_t j = 0; j <= i; ++j) {
        const Mode &a = modes[static_cast<std::size_t>(i)], &b = modes[static_cast<std::size_t>(j)];
        stiffness(i, j) += a.xx * b.xx + a.yy * b.yy + lateral_contraction * (a.xx * b.yy + a.yy * b.xx) +
                           2.0 * (1.0 - lateral_contraction) * a.xy * b.xy;
        released(i, j) -= n_xx * a.x * b.x + n_xy * (a.x * b.y + a.y * b.x) + n_yy * a.y * b.y;
      }
    }
  }
  double low = 0.0, high = 100.0;
  for (int step = 0; step < 40; ++step) {
    const double weight = 0.5 * (low + high);
    const bool is_stable = (stiffness - weight * released).llt().info() == Eigen::Success;
    (is_stable ? low : high) = weight;
  }
  return low;
}

double friction_that_sticks(double strain) {
  struct Clamp {
    double strain, friction;
  };
  // Integrates from the hinge, in the frame of the force there, whose size is the unit, until a line to the hinge lies
  // along the strip. There the strip is clamped.
  const auto clamp_of = [](double angle) {
    constexpr double step = 1e-3;
    double curvature = -0.5 * step * std::sin(angle), x = 0.0, y = 0.0, length = 0.0;
    do {
      const double middle = angle + 0.5 * step * curvature;
      x += step * std::cos(middle);
      y += step * std::sin(middle);
      angle += step * curvature;
      curvature -= step * std::sin(angle);
      length += step;
    } while (x * std::sin(angle) < y * std::cos(angle));
    return Clamp{1.0 - std::hypot(x, y) / length, std::abs(std::tan(angle))};
  };
  double low = 0.01, high = 2.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (clamp_of(middle).strain < strain ? low : high) = middle;
  }
  return clamp_of(low).friction;
}

double droop_of_elastica(double weight_over_rigidity) {
  constexpr int steps = 400;
  constexpr double h = 1.0 / steps;
  struct End {
    double curvature, reach, drop;
  };
  // Integrates from the clamp with this curvature there, by the method of Runge and Kutta.
  const auto integrated = [&](double curvature) {
    double angle = 0.0, reach = 0.0, drop = 0.0;
    const auto change = [&](double s, double a) { return -weight_over_rigidity * (1.0 - s) * std::cos(a); };
    for (int i = 0; i < steps; ++i) {
      const double s = i * h;
      const double k1 = change(s, angle), a1 = curvature;
      const double k2 = change(s + 0.5 * h, angle + 0.5 * h * a1), a2 = curvature + 0.5 * h * k1;
      const double k3 = change(s + 0.5 * h, angle + 0.5 * h * a2), a3 = curvature + 0.5 * h * k2;
      const double k4 = change(s + h, angle + h * a3), a4 = curvature + h * k3;
      const double next = angle + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      curvature += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      reach += 0.5 * h * (std::cos(angle) + std::cos(next));
      drop += 0.5 * h * (std::sin(angle) + std::sin(next));
      angle = next;
    }
    return End{curvature, reach, drop};
  };
  double low = 0.0, high = weight_over_rigidity;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (integrated(middle).curvature > 0.0 ? high : low) = middle;
  }
  const End end = integrated(0.5 * (low + high));
  return end.drop / end.reach;
}

namespace {

/// Returns the eigenvalues of w'''' + load w' for a strip of length 1 that is hinged at its edge to windward, and at
/// the other unless that is free.
Eigen::VectorXcd find_strip_modes(double load, bool is_free) {
  constexpr int parts = 40;
  constexpr double h = 1.0 / parts;
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(parts + 1, parts + 1);
  const Eigen::Vector3d bend(1.0, -2.0, 1.0);
  for (int i = 1; i < parts; ++i) forces.block<3, 3>(i - 1, i - 1) += bend * bend.transpose() / (h * h * h);
  for (int i = 0; i < parts; ++i) {
    forces.block<2, 1>(i, i).array() -= 0.5 * load;
    forces.block<2, 1>(i, i + 1).array() += 0.5 * load;
  }
  forces /= h;
  forces.row(parts) *= 2.0;  // half of a part moves with the edge
  const int moving = is_free ? parts : parts - 1;
  return forces.block(1, 1, moving, moving).eigenvalues();
}

/// Returns the rate at which the fastest mode grows and turns.
std::complex<double> find_fastest_rate(double load, double air_ratio, bool is_free) {
  const double drag = std::sqrt(air_ratio * load);
  std::complex<double> fastest = -drag;
  for (const std::complex<double>& mode : find_strip_modes(load, is_free)) {
    const std::complex<double> root = std::sqrt(drag * drag - 4.0 * mode);
    const std::complex<double> rate = 0.5 * (root.real() > 0.0 ? root - drag : -root - drag);
    if (rate.real() > fastest.real()) fastest = rate;
  }
  return fastest;
}

}  // namespace

FlutterOnset flutter_onset(double air_ratio, bool is_free) {
  double low = 1.0, high = 4000.0;
  for (int step = 0; step < 30; ++step) {
    const double middle = 0.5 * (low + high);
    (find_fastest_rate(middle, air_ratio, is_free).real() > 1e-5 ? high : low) = middle;
  }
  return {high, std::abs(find_fastest_rate(high, air_ratio, is_free).imag()) / (2.0 * std::acos(-1.0))};
}

}  // namespace taut::app
