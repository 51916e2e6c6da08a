#include "tailor/mannequin/shape.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::tailor {
namespace {

constexpr double midline_m =
    0.12;  // distance from x = 0 within which a part and its mirror image may flow together
constexpr double edge_of_radius = 0.65;  // edge length on a bent surface, as a fraction of its radius
constexpr double min_edge_m = 0.012;
constexpr double sole_blend_m = 0.012;  // rounding of the sole's edge

double piecewise(const std::vector<double>& from, const std::vector<double>& to, double t) {
  std::size_t i = 1;
  while (i + 1 < from.size() && from[i] < t) {
    ++i;
  }
  return to[i - 1] + (t - from[i - 1]) * (to[i] - to[i - 1]) / (from[i] - from[i - 1]);
}

/// Returns the smaller number, rounded where both are similar.
double smooth_min(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - h * h * h * width / 6.0;
}

/// Returns the point's distance from the centre divided by the curve's, for the curve of Fernandez-Guasti (1992): x^2 +
/// y^2 - q x^2 y^2 = 1, an ellipse for q = 0.
double times_out(double x, double y, double squareness) {
  const double sum = x * x + y * y;
  const double root = std::sqrt(std::max(sum * sum - 4.0 * squareness * x * x * y * y, 0.0));
  return std::sqrt(0.5 * (sum + root));
}

Vec3 mirror(const Vec3& p) { return {-p.x, p.y, p.z}; }

/// Returns the unit vector, or a shorter one if the field hardly changes.
Vec3 direction(const Vec3& v) {
  return v / std::max(glm::length(v), 1e-6);
}

/// Returns the largest curvature of the surface near the point, within about a centimetre, in 1/m.
double max_curvature(const Shape& shape, const Vec3& point_m) {
  constexpr double step_m = 0.006;
  const Vec3 normal = direction(gradient(shape, point_m));
  const Vec3 aside = glm::normalize(
      glm::cross(normal, std::abs(normal.y) < 0.7 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0)));
  const Vec3 across = glm::cross(normal, aside);
  double largest = 1e-3;
  for (const Vec3& along :
       {aside, across, (aside + across) * std::sqrt(0.5), (aside - across) * std::sqrt(0.5)}) {
    const Vec3 ahead = direction(gradient(shape, point_m + step_m * along));
    const Vec3 behind = direction(gradient(shape, point_m - step_m * along));
    largest = std::max(largest, glm::length(ahead - behind) / (2.0 * step_m));
  }
  return largest;
}

double both_sides_m(const Shape& shape, const Part& part, const Vec3& left_m) {
  const double left = distance_m(shape, part, left_m);
  if (part.on_midline || left_m.x > midline_m) {
    return left;
  }
  return smooth_min(left, distance_m(shape, part, mirror(left_m)), part.blend_m);
}

}  // namespace

void Chain::set_factors(const std::vector<double>& factors) {
  std::vector<std::array<double, 1>> values;
  for (const double f : factors) {
    values.push_back({f});
  }
  factor = Curve<1>(girths_m, values);
}

Vec3 Chain::sized(const Vec3& reference) const {
  const Vec3 from = reference - reference_origin_m;
  const double t = piecewise(reference_m, sized_m, glm::dot(from, frame.along));
  const double f = factor(t)[0];
  return frame.origin_m + t * frame.along + f * side_factor * glm::dot(from, frame.side) * frame.side +
         f * glm::dot(from, frame.front) * frame.front;
}

Vec3 Chain::reference(const Vec3& sized, double& factor_there) const {
  const Vec3 from = sized - frame.origin_m;
  const double t = glm::dot(from, frame.along);
  const double f = factor(t)[0];
  factor_there = f * std::min(side_factor, 1.0);
  return reference_origin_m + piecewise(sized_m, reference_m, t) * frame.along +
         glm::dot(from, frame.side) / (f * side_factor) * frame.side +
         glm::dot(from, frame.front) / f * frame.front;
}

double distance_m(const Shape& shape, const Part& part, const Vec3& point_m) {
  double factor = 1.0;
  const Vec3 from = shape.chains[part.chain].reference(point_m, factor) - part.frame.origin_m;
  const double t = glm::dot(from, part.frame.along);
  const double within = std::clamp(t, part.sections.first(), part.sections.last());
  const auto [side, front, width_2, back_2, front_2, squareness] = part.sections(within);
  constexpr double min_squared = 1e-8;  // gives a section that has shrunk to a point an outward direction
  const double u = glm::dot(from, part.frame.side) - side;
  const double v = glm::dot(from, part.frame.front) - front;
  const double x = u / std::sqrt(std::max(width_2, min_squared));
  const double y = v / std::sqrt(std::max(v < 0.0 ? back_2 : front_2, min_squared));
  const double times = std::max(times_out(x, y, squareness), 1e-9);
  const double across = std::sqrt(u * u + v * v) * (1.0 - 1.0 / times);
  if (t == within) {
    return factor * across;
  }
  const double beyond = t - within;
  return factor * std::sqrt(std::max(across, 0.0) * std::max(across, 0.0) + beyond * beyond);
}

double distance_m(const Shape& shape, const Vec3& point_m) {
  const Vec3 left_m = {std::abs(point_m.x), point_m.y, point_m.z};
  double distance = 1.0;
  for (const Part& part : shape.parts) {
    const double own = both_sides_m(shape, part, left_m);
    distance = part.is_hollow ? -smooth_min(-distance, own, part.blend_m) : smooth_min(distance, own, part.blend_m);
  }
  return -smooth_min(-distance, point_m.y, sole_blend_m);
}

Shape with_details(const Shape& shape) {
  Shape whole = shape;
  whole.parts.insert(whole.parts.end(), shape.details.begin(), shape.details.end());
  return whole;
}

double chain_distance_m(const Shape& shape, std::size_t chain, const Vec3& point_m) {
  double distance = 1.0;
  for (const Part& part : shape.parts) {
    if (part.chain == chain) {
      distance = std::min(distance, distance_m(shape, part, point_m));
    }
  }
  return distance;
}

Vec3 gradient(const Shape& shape, const Vec3& point_m) {
  constexpr double step_m = 1e-4;
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 ahead = point_m;
    Vec3 behind = point_m;
    ahead[axis] += step_m;
    behind[axis] -= step_m;
    result[axis] = (distance_m(shape, ahead) - distance_m(shape, behind)) / (2.0 * step_m);
  }
  return result;
}

Vec3 on_surface(const Shape& shape, Vec3 point_m) {
  constexpr double max_step_m = 0.01;
  const bool stays = point_m.x == 0.0;
  for (int i = 0; i < 8; ++i) {
    Vec3 uphill = gradient(shape, point_m);
    if (stays) {
      uphill.x = 0.0;
    }
    Vec3 step = -distance_m(shape, point_m) * uphill / std::max(glm::dot(uphill, uphill), 0.05);
    const double length = glm::length(step);
    point_m += length > max_step_m ? step * (max_step_m / length) : step;
  }
  return point_m;
}

double edge_length_m(const Shape& shape, const Vec3& point_m) {
  const Vec3 left_m = {std::abs(point_m.x), point_m.y, point_m.z};
  double sum = 0.0;
  double weights = 0.0;
  for (const Part& part : shape.parts) {
    const double near = 0.02 + std::max(distance_m(shape, part, left_m), 0.0);
    const double weight = 1.0 / (near * near * near * near);
    sum += weight * part.edge_m;
    weights += weight;
  }
  return std::clamp(edge_of_radius / max_curvature(shape, point_m), min_edge_m, sum / weights);
}

}  // namespace taut::tailor
