#include "tailor/mannequin/tape.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>

namespace taut::tailor {
namespace {

using sim::Index;
using sim::Vec2;
using EdgeKey = std::pair<Index, Index>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Andrew 1979: the lower and the upper chain of the points in order of x.
double hull_length(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  double length = 0.0;
  for (int side = 0; side < 2; ++side) {
    std::vector<Vec2> chain;
    for (const Vec2& p : points) {
      while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0.0) {
        chain.pop_back();
      }
      chain.push_back(p);
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
      length += glm::length(chain[i] - chain[i - 1]);
    }
    std::reverse(points.begin(), points.end());
  }
  return length;
}

/// The plane's section, curve after curve.
class Section {
 public:
  Section(const sim::Mesh& mesh, const Tape& tape) : mesh_(mesh), tape_(tape) {
    across_ = glm::normalize(
        glm::cross(tape.normal, std::abs(tape.normal.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0)));
    for (const sim::Triangle& t : mesh.triangles) {
      std::vector<EdgeKey> cut;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k];
        const Index b = t[(k + 1) % 3];
        if ((height(a) < 0.0) != (height(b) < 0.0)) {
          cut.push_back(std::minmax(a, b));
        }
      }
      if (cut.size() == 2) {
        next_[cut[0]].push_back(cut[1]);
        next_[cut[1]].push_back(cut[0]);
      }
    }
  }

  /// The curve around the tape's point, as points of the plane; empty where there is none.
  std::vector<Vec2> curve_around() {
    while (!next_.empty()) {
      std::vector<Vec2> curve = take_curve(next_.begin()->first);
      double angles = 0.0;
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec2& a = curve[i];
        const Vec2& b = curve[(i + 1) % curve.size()];
        // Crossings of the ray to the right of the point, which is the origin.
        if ((a.y < 0.0) != (b.y < 0.0) && a.x + (b.x - a.x) * a.y / (a.y - b.y) > 0.0) {
          angles += a.y < 0.0 ? 1.0 : -1.0;
        }
      }
      if (angles != 0.0) {
        return curve;
      }
    }
    return {};
  }

 private:
  double height(Index v) const { return glm::dot(mesh_.positions[v] - tape_.point_m, tape_.normal); }

  Vec2 point_on(const EdgeKey& edge) const {
    const double share = height(edge.first) / (height(edge.first) - height(edge.second));
    const Vec3 p = glm::mix(mesh_.positions[edge.first], mesh_.positions[edge.second], share) - tape_.point_m;
    return {glm::dot(p, across_), glm::dot(p, glm::cross(tape_.normal, across_))};
  }

  std::vector<Vec2> take_curve(EdgeKey edge) {
    std::vector<Vec2> curve;
    for (auto found = next_.find(edge); found != next_.end(); found = next_.find(edge)) {
      curve.push_back(point_on(edge));
      const std::vector<EdgeKey> ends = found->second;
      next_.erase(found);
      edge = next_.contains(ends[0]) ? ends[0] : ends.back();
    }
    return curve;
  }

  const sim::Mesh& mesh_;
  const Tape& tape_;
  Vec3 across_;
  std::map<EdgeKey, std::vector<EdgeKey>> next_;
};

}  // namespace

double girth_m(const sim::Mesh& mesh, const Tape& tape) {
  const std::vector<Vec2> curve = Section(mesh, tape).curve_around();
  if (curve.empty()) {
    throw std::runtime_error("the tape '" + tape.name + "' finds nothing to lie around");
  }
  return hull_length(curve);
}

}  // namespace taut::tailor
