#include "app/models/section.hpp"

namespace taut::app {
namespace {

using sim::Vec2;
using sim::Vec3;
using EdgeKey = std::pair<sim::Index, sim::Index>;
/// Per edge that is cut, the next ones along the curves.
using Links = std::map<EdgeKey, std::vector<EdgeKey>>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The first axis of curves in a plane.
Vec3 across(const CuttingPlane& plane) {
  return glm::normalize(
      glm::cross(plane.normal, std::abs(plane.normal.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0)));
}

class Section {
 public:
  Section(const Surface& surface, const CuttingPlane& plane)
      : surface_(surface), plane_(plane), across_(across(plane)) {
    for (const sim::Triangle& t : surface.triangles) {
      std::vector<EdgeKey> cut;
      for (std::size_t k = 0; k < 3; ++k) {
        const sim::Index a = t[k];
        const sim::Index b = t[(k + 1) % 3];
        if ((height(a) < 0.0) != (height(b) < 0.0)) cut.push_back(std::minmax(a, b));
      }
      if (cut.size() == 2) {
        next_[cut[0]].push_back(cut[1]);
        next_[cut[1]].push_back(cut[0]);
      }
    }
  }

  std::vector<SectionCurve> curves() {
    std::vector<EdgeKey> ends;
    for (const auto& [edge, neighbours] : next_) {
      if (neighbours.size() != 2) ends.push_back(edge);
    }
    std::vector<SectionCurve> found;
    for (const EdgeKey& end : ends) {
      if (next_.contains(end)) found.push_back({take_curve(end), false});
    }
    while (!next_.empty()) found.push_back({take_curve(next_.begin()->first), true});
    return found;
  }

 private:
  double height(sim::Index v) const { return glm::dot(surface_.positions_m[v] - plane_.point_m, plane_.normal); }

  Vec2 point_on(const EdgeKey& edge) const {
    const double share = height(edge.first) / (height(edge.first) - height(edge.second));
    const Vec3 p =
        glm::mix(surface_.positions_m[edge.first], surface_.positions_m[edge.second], share) - plane_.point_m;
    return {glm::dot(p, across_), glm::dot(p, glm::cross(plane_.normal, across_))};
  }

  std::vector<Vec2> take_curve(EdgeKey edge) {
    std::vector<Vec2> curve;
    for (auto found = next_.find(edge); found != next_.end(); found = next_.find(edge)) {
      curve.push_back(point_on(edge));
      const std::vector<EdgeKey> ends = found->second;
      next_.erase(found);
      const auto left = std::ranges::find_if(ends, [&](const EdgeKey& end) { return next_.contains(end); });
      edge = left == ends.end() ? ends.front() : *left;
    }
    return curve;
  }

  const Surface& surface_;
  const CuttingPlane& plane_;
  Vec3 across_;
  Links next_;
};

}  // namespace

std::vector<SectionCurve> section_of(const Surface& surface, const CuttingPlane& plane) {
  return Section(surface, plane).curves();
}

sim::Vec3 place_in(const CuttingPlane& plane, const Vec2& point) {
  const Vec3 first = across(plane);
  return plane.point_m + point.x * first + point.y * glm::cross(plane.normal, first);
}

double length_m(const SectionCurve& curve) {
  double length = curve.is_closed ? glm::distance(curve.points_m.back(), curve.points_m.front()) : 0.0;
  for (std::size_t i = 1; i < curve.points_m.size(); ++i) {
    length += glm::distance(curve.points_m[i - 1], curve.points_m[i]);
  }
  return length;
}

/// Andrew 1979: the lower and the upper chain of the points in order of x.
std::vector<Vec2> convex_hull(std::vector<Vec2> points_m) {
  std::ranges::sort(points_m, [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Vec2& p : points_m) {
      while (hull.size() > first + 1 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    // Where a chain ends the other one begins.
    hull.pop_back();
    std::ranges::reverse(points_m);
  }
  return hull;
}

double tight_tape_m(std::vector<Vec2> points_m) {
  const std::vector<Vec2> hull = convex_hull(std::move(points_m));
  return hull.empty() ? 0.0 : length_m({hull, true});
}

bool is_in_hull(const std::vector<Vec2>& hull, const Vec2& point) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (turn(hull[i], hull[(i + 1) % hull.size()], point) < 0.0) return false;
  }
  return !hull.empty();
}

bool is_around_point(const SectionCurve& curve) {
  int turns = 0;
  for (std::size_t i = 0; i < curve.points_m.size(); ++i) {
    const Vec2& a = curve.points_m[i];
    const Vec2& b = curve.points_m[(i + 1) % curve.points_m.size()];
    // Crossings of the ray to the right of the point, which is the origin.
    if ((a.y < 0.0) != (b.y < 0.0) && a.x + (b.x - a.x) * a.y / (a.y - b.y) > 0.0) {
      turns += a.y < 0.0 ? 1 : -1;
    }
  }
  return turns != 0;
}

}  // namespace taut::app
