#include "sim/mesh/polygons.hpp"

#include "sim/mesh/mesh.hpp"

namespace taut::sim {
namespace {

/// Largest number of ear ratings per corner of a face. It limits the work on outlines that cross themselves; smaller
/// values cut these worse.
constexpr std::size_t ratings_per_corner = 50;
/// A quad is cut along its second diagonal if the fullness of the first cut is below this fraction of the second's.
/// Larger values cut fewer quads of one cloth the same way.
constexpr double min_fullness_ratio = 0.5;

/// Returns the area over the squared edge lengths: largest for an equilateral triangle, 0 for a line, negative if
/// clockwise.
double fullness(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double squares = glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c);
  return squares > 0.0 ? doubled_area(a, b, c) / squares : 0.0;
}

/// Returns the corners in the face's mean plane, scaled to about 1 so that no product overflows.
std::vector<Vec2> flatten_face(std::span<const Vec3> positions, std::span<const Index> face) {
  const Vec3 origin = positions[face[0]];
  double size = 0.0;
  for (const Index v : face) {
    const Vec3 d = positions[v] - origin;
    size = std::max({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  std::vector<Vec2> flat(face.size(), Vec2(0.0));
  if (!(size > 0.0) || !std::isfinite(size)) return flat;
  const auto scaled = [&](std::size_t k) { return (positions[face[k]] - origin) / size; };
  Vec3 normal(0.0);
  for (std::size_t k = 0; k < face.size(); ++k) {
    normal += glm::cross(scaled(k), scaled((k + 1) % face.size()));
  }
  const double length = glm::length(normal);
  if (!(length > 0.0)) return flat;
  normal /= length;
  const Vec3 away = std::abs(normal.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 u = glm::normalize(glm::cross(away, normal));
  const Vec3 v = glm::cross(normal, u);
  for (std::size_t k = 0; k < face.size(); ++k) flat[k] = {glm::dot(scaled(k), u), glm::dot(scaled(k), v)};
  return flat;
}

/// Ring of the remaining corners of a face while ears are cut off.
class Ring {
 public:
  explicit Ring(std::vector<Vec2> corners) : corners_(std::move(corners)) {
    const std::size_t count = corners_.size();
    for (std::size_t k = 0; k < count; ++k) {
      before_.push_back((k + count - 1) % count);
      after_.push_back((k + 1) % count);
    }
    left_ = count;
    gains_.assign(count, 0.0);
    blockers_.assign(count, 0);
    ratings_left_ = ratings_per_corner * count;
    for (std::size_t k = 0; k < count; ++k) rate(k);
  }

  std::size_t left() const { return left_; }
  std::size_t before(std::size_t k) const { return before_[k]; }
  std::size_t after(std::size_t k) const { return after_[k]; }
  /// Returns the corner with the fullest ear.
  std::size_t best() const {
    std::size_t best = first_;
    for (std::size_t n = 0, k = first_; n < left_; ++n, k = after_[k]) {
      best = gains_[k] > gains_[best] ? k : best;
    }
    return best;
  }
  void cut(std::size_t k) {
    after_[before_[k]] = after_[k];
    before_[after_[k]] = before_[k];
    first_ = after_[k];
    --left_;
    rate(before_[k]);
    rate(after_[k]);
    free_ears_blocked_by(k);
  }

 private:
  /// Returns a corner of the outline inside the ear at k, or k if there is none.
  std::size_t blocker(std::size_t k) const {
    const Vec2 &a = corners_[before_[k]], &b = corners_[k], &c = corners_[after_[k]];
    for (std::size_t n = 3, m = after_[after_[k]]; n < left_; ++n, m = after_[m]) {
      const Vec2& p = corners_[m];
      if (p != a && p != b && p != c && doubled_area(a, b, p) >= 0.0 && doubled_area(b, c, p) >= 0.0 &&
          doubled_area(c, a, p) >= 0.0) {
        return m;
      }
    }
    return k;
  }
  // An outline that crosses itself may have no ear. The least bad corner is cut then, so that cutting ends.
  void rate(std::size_t k) {
    constexpr double no_ear = 10.0;
    const double full = fullness(corners_[before_[k]], corners_[k], corners_[after_[k]]);
    blockers_[k] = full > 0.0 ? blocker(k) : k;
    gains_[k] = full > 0.0 && blockers_[k] == k ? full : full - no_ear;
  }
  /// Rates ears again that this corner blocked.
  void free_ears_blocked_by(std::size_t cut) {
    for (std::size_t n = 0, m = first_; n < left_; ++n, m = after_[m]) {
      if (blockers_[m] == cut && ratings_left_ > 0) {
        --ratings_left_;
        rate(m);
      }
    }
  }

  std::vector<Vec2> corners_;
  std::vector<std::size_t> before_, after_;
  std::vector<double> gains_;
  std::vector<std::size_t> blockers_;
  std::size_t ratings_left_ = 0;  ///< remaining ear ratings; limits the work
  std::size_t left_ = 0;
  std::size_t first_ = 0;
};

void cut_quad(std::span<const Vec3> positions, std::span<const Index> q, std::vector<Triangle>& triangles) {
  assert(q.size() == 4);
  const std::vector<Vec2> p = flatten_face(positions, q);
  const double first = std::min(fullness(p[0], p[1], p[2]), fullness(p[0], p[2], p[3]));
  const double second = std::min(fullness(p[0], p[1], p[3]), fullness(p[1], p[2], p[3]));
  // All quads of one cloth should be cut the same way, however they fold, unless that makes needles.
  if (first < min_fullness_ratio * second) {
    triangles.push_back({q[0], q[1], q[3]});
    triangles.push_back({q[1], q[2], q[3]});
  } else {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
}

void cut_ears(std::span<const Vec3> positions, std::span<const Index> face, std::vector<Triangle>& triangles) {
  assert(face.size() >= 3);
  Ring ring(flatten_face(positions, face));
  while (ring.left() >= 3) {
    const std::size_t k = ring.best();
    triangles.push_back({face[ring.before(k)], face[k], face[ring.after(k)]});
    if (ring.left() == 3) return;
    ring.cut(k);
  }
}

void require_corners(std::size_t face, std::uint32_t count, std::size_t there) {
  const std::string name = "face " + std::to_string(face) + " has " + std::to_string(count) + " corners";
  if (count < 3 || count > max_face_corners) {
    throw std::invalid_argument(name + "; expected 3 to " + std::to_string(max_face_corners));
  }
  if (count > there) throw std::invalid_argument(name + ", but only " + std::to_string(there) + " are there");
}

}  // namespace

std::vector<Triangle> cut_into_triangles(const Polygons& polygons) {
  std::vector<Triangle> triangles;
  std::size_t at = 0;
  for (std::size_t f = 0; f < polygons.corner_counts.size(); ++f) {
    const std::uint32_t count = polygons.corner_counts[f];
    require_corners(f, count, polygons.corners.size() - at);
    const std::span<const Index> face = polygons.corners.subspan(at, count);
    at += count;
    for (const Index v : face) {
      if (v >= polygons.positions.size()) {
        throw std::invalid_argument("face " + std::to_string(f) + " uses vertex " + std::to_string(v) +
                                    ", but there are only " + std::to_string(polygons.positions.size()));
      }
    }
    if (count == 3) {
      triangles.push_back({face[0], face[1], face[2]});
    } else if (count == 4) {
      cut_quad(polygons.positions, face, triangles);
    } else {
      cut_ears(polygons.positions, face, triangles);
    }
  }
  if (at != polygons.corners.size()) {
    throw std::invalid_argument(std::to_string(polygons.corners.size() - at) + " corners belong to no face");
  }
  return triangles;
}

}  // namespace taut::sim
