#pragma once

#include <array>
#include <span>
#include <vector>

namespace taut::tailor {

/// Smooth curves of N quantities through knots: cubic pieces whose slope at a knot is the slope of the parabola through
/// it and its neighbours. Values outside the knots equal the nearest knot's.
template <std::size_t N>
class Curve {
 public:
  using Values = std::array<double, N>;

  Curve() = default;

  /// Requires at least two knots, in increasing order, and as many values.
  Curve(std::vector<double> knots, std::vector<Values> values)
      : knots_(std::move(knots)), values_(std::move(values)), slopes_(values_.size()) {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      for (std::size_t n = 0; n < N; ++n) {
        slopes_[i][n] = slope(i, n);
      }
    }
  }

  Values operator()(double t) const {
    if (t <= knots_.front()) {
      return values_.front();
    }
    if (t >= knots_.back()) {
      return values_.back();
    }
    std::size_t i = 1;
    while (knots_[i] < t) {
      ++i;
    }
    const double step = knots_[i] - knots_[i - 1];
    const double s = (t - knots_[i - 1]) / step;
    const double end = s * s * (3.0 - 2.0 * s);
    const double leave = s * (1.0 - s) * (1.0 - s) * step;
    const double arrive = s * s * (s - 1.0) * step;
    Values result;
    for (std::size_t n = 0; n < N; ++n) {
      result[n] = (1.0 - end) * values_[i - 1][n] + end * values_[i][n] + leave * slopes_[i - 1][n] +
                  arrive * slopes_[i][n];
    }
    return result;
  }

  double first() const { return knots_.front(); }
  double last() const { return knots_.back(); }

 private:
  double secant(std::size_t i, std::size_t n) const {
    return (values_[i + 1][n] - values_[i][n]) / (knots_[i + 1] - knots_[i]);
  }

  double slope(std::size_t i, std::size_t n) const {
    const std::size_t last = knots_.size() - 1;
    if (last == 1 || i == 0 || i == last) {
      return end_slope(i, n);
    }
    const double before = knots_[i] - knots_[i - 1];
    const double after = knots_[i + 1] - knots_[i];
    return (secant(i - 1, n) * after + secant(i, n) * before) / (before + after);
  }

  double end_slope(std::size_t i, std::size_t n) const {
    const std::size_t last = knots_.size() - 1;
    const std::size_t outer = i == 0 ? 0 : last - 1;
    return last == 1 ? secant(outer, n) : 1.5 * secant(outer, n) - 0.5 * slope(i == 0 ? 1 : last - 1, n);
  }

  std::vector<double> knots_;
  std::vector<Values> values_;
  std::vector<Values> slopes_;
};

}  // namespace taut::tailor
