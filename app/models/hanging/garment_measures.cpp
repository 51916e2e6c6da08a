#include "app/models/hanging/garment_measures.hpp"

#include "app/models/hanging/hanger.hpp"
#include "app/models/hanging/tuning.hpp"

namespace taut::app {

using namespace hanging;

namespace {

using sim::Vec2;
using sim::Vec3;
using EdgeKey = std::pair<sim::Index, sim::Index>;
/// Per cut edge, the next edges along the curves.
using Links = std::map<EdgeKey, std::vector<EdgeKey>>;

/// Returns the first axis of curves in a plane.
Vec3 across(const CuttingPlane& plane) {
  return glm::normalize(
      glm::cross(plane.normal, std::abs(plane.normal.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0)));
}

class Section {
 public:
  Section(const sim::Surface& surface, const CuttingPlane& plane)
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

  const sim::Surface& surface_;
  const CuttingPlane& plane_;
  Vec3 across_;
  Links next_;
};

/// Returns the vertices of all landmarks whose names contain the word.
std::vector<sim::Index> landmarks_with(const Landmarks& landmarks, const std::string& word) {
  std::vector<sim::Index> vertices;
  for (const auto& [name, named] : landmarks) {
    if (name.find(word) != std::string::npos) vertices.insert(vertices.end(), named.begin(), named.end());
  }
  return vertices;
}

sim::Vec3 mean_position(std::span<const sim::Index> vertices, std::span<const sim::Vec3> positions_m) {
  sim::Vec3 sum(0.0);
  for (const sim::Index v : vertices) sum += positions_m[v];
  return sum / static_cast<double>(vertices.size());
}

struct Finder {
  const Landmarks& landmarks;
  const sim::Mesh& mesh;
  const GarmentPart& part;
  std::span<const sim::Vec3> positions_m = mesh.positions;
  sim::Surface surface = {mesh.positions, mesh.triangles};

  bool is_in_middle(const Opening& opening) const {
    const int across = part.across();
    return std::abs(opening.range.middle()[across] - part.range.middle()[across]) < max_middle_offset * part.width_m();
  }

  bool is_open_front(const Opening& opening) const {
    return is_in_middle(opening) && opening.range.size().y > min_open_front_fraction * part.range.size().y;
  }

  /// Returns the vertices around the neck of a jacket that is open in front.
  std::vector<sim::Index> neck_of_open_front(const GarmentMarks& marks) const {
    std::vector<sim::Index> neck;
    const double from_m = part.range.upper.y - neck_height_fraction * part.range.size().y;
    for (const Opening& opening : part.openings) {
      if (marks.cuffs.empty() || !is_open_front(opening)) continue;
      std::ranges::copy_if(opening.vertices, std::back_inserter(neck),
                           [&](sim::Index v) { return positions_m[v].y > from_m; });
    }
    return neck;
  }

  /// Returns the depth of a stand collar below its edge, in m; 0 if there is none.
  double collar_m(const Opening& top) const {
    if (top.range.size().y > max_collar_unevenness_m) return 0.0;
    const sim::Vec3 middle = top.range.middle();
    for (double below_m = collar_step_m; below_m < max_collar_m; below_m += collar_step_m) {
      double around_m = 0.0;
      for (const SectionCurve& curve : cut_section(surface, {{middle.x, top.range.lower.y - below_m, middle.z}})) {
        if (curve.is_closed && is_around_point(curve)) around_m = std::max(around_m, length_m(curve));
      }
      if (around_m == 0.0) return 0.0;
      if (around_m > min_shoulder_girth_ratio * top.length_m) return below_m - collar_step_m;
    }
    return 0.0;
  }

  /// Sets the front to the side of the longest opening above the neck of a hood.
  void face_front(const std::vector<sim::Index>& neck, GarmentMarks& marks) const {
    const sim::Vec3 neck_m = mean_position(neck, positions_m);
    const Opening* face = nullptr;
    for (const Opening& opening : part.openings) {
      const bool is_above = opening.mean_height_m > neck_m.y;
      if (is_above && (face == nullptr || opening.length_m > face->length_m)) face = &opening;
    }
    if (face == nullptr) return;
    const int depth = 2 - part.across();
    marks.front = sim::Vec3(0.0);
    marks.front[depth] = face->range.middle()[depth] < neck_m[depth] ? -1.0 : 1.0;
    marks.is_front_known = true;
  }

  void find_top(const Opening* top, GarmentMarks& marks) const {
    std::vector<sim::Index> vertices = landmarks_with(landmarks, "neck");
    const std::vector<sim::Index> hooded =
        vertices.empty() ? neck_below_hood(mesh, part, part.across()) : std::vector<sim::Index>();
    if (!hooded.empty()) {
      top = nullptr;
      vertices = hooded;
    }
    if (vertices.empty() && top == nullptr) vertices = neck_of_open_front(marks);
    marks.is_worn_at_waist = vertices.empty();
    if (vertices.empty()) vertices = landmarks_with(landmarks, "waist");
    if (vertices.empty() && top != nullptr) {
      vertices = top->vertices;
      const auto above = std::ranges::count_if(
          part.openings, [&](const Opening& o) { return o.mean_height_m > part.range.middle().y; });
      marks.is_worn_at_waist = above == 1 && (part.openings.size() == 2 || !marks.hem_height_m);
    }
    if (!vertices.empty()) {
      marks.top = sim::compute_extent(positions_m, vertices);
      marks.top_m = top == nullptr ? 0.0 : top->length_m;
      marks.top_height_m = mean_position(vertices, positions_m).y;
      marks.neck_base_m = vertices == hooded ? marks.top->lower.y : marks.top->upper.y;
      find_front(vertices, marks);
      if (vertices == hooded) face_front(hooded, marks);
      if (top != nullptr && vertices == top->vertices) {
        const double below_m = collar_m(*top);
        if (below_m > 0.0) marks.neck_base_m = top->range.lower.y - below_m;
      }
    }
  }

  void find_hem_and_cuffs(const Opening* top, GarmentMarks& marks) const {
    std::vector<const Opening*> beside;
    for (const Opening& opening : part.openings) {
      if (&opening != top && is_open_front(opening)) {
        marks.is_open_in_front = true;
        continue;
      }
      const bool is_hem = is_in_middle(opening) && opening.mean_height_m < part.range.middle().y;
      if (&opening != top && is_hem && opening.length_m > marks.hem_m) {
        marks.hem_height_m = opening.mean_height_m;
        marks.hem_m = opening.length_m;
      } else if (&opening != top && !is_in_middle(opening)) {
        beside.push_back(&opening);
      }
    }
    // The lowest two openings belong to legs if there is no hem.
    std::ranges::stable_sort(beside,
                             [](const Opening* a, const Opening* b) { return a->mean_height_m > b->mean_height_m; });
    const bool may_have_legs = !marks.hem_height_m && !marks.is_open_in_front;
    const std::size_t sleeves = beside.size() - (may_have_legs ? std::min<std::size_t>(beside.size(), 2) : 0);
    const std::span<const Opening* const> all = beside;
    marks.cuffs = pair_of(all.first(sleeves));
    marks.legs = pair_of(all.subspan(sleeves));
    if (!marks.legs.empty() && marks.legs.front().middle_m.y > part.range.middle().y) marks.legs.clear();
  }

  /// Returns both openings of a pair; none if there are others, or if both are on one side.
  std::vector<LimbOpening> pair_of(std::span<const Opening* const> openings) const {
    std::vector<LimbOpening> pair;
    for (const Opening* const opening : openings) {
      pair.push_back({mean_position(opening->vertices, positions_m), opening->length_m});
    }
    const int across = part.across();
    const double middle = part.range.middle()[across];
    if (pair.size() != 2 || (pair[0].middle_m[across] < middle) == (pair[1].middle_m[across] < middle)) {
      pair.clear();
    }
    return pair;
  }

  void find_front(const std::vector<sim::Index>& top, GarmentMarks& marks) const {
    const std::vector<sim::Index> front = landmarks_with(landmarks, "front");
    const std::vector<sim::Index> back = landmarks_with(landmarks, "back");
    if (!front.empty() && !back.empty()) {
      sim::Vec3 forwards = mean_position(front, positions_m) - mean_position(back, positions_m);
      forwards.y = 0.0;
      if (glm::length(forwards) > 0.0) {
        marks.front = glm::normalize(forwards);
        marks.is_front_known = true;
        return;
      }
    }
    const int depth = 2 - part.across();
    const double middle = marks.top->middle()[depth];
    std::array<std::vector<sim::Index>, 2> sides;  // behind and before the middle
    for (const sim::Index v : top) sides[positions_m[v][depth] > middle ? 1 : 0].push_back(v);
    const double dip_m = sides[0].empty() || sides[1].empty()
                             ? 0.0
                             : mean_position(sides[0], positions_m).y - mean_position(sides[1], positions_m).y;
    marks.front = sim::Vec3(0.0);
    marks.front[depth] = dip_m < 0.0 ? -1.0 : 1.0;
    marks.is_front_known = std::abs(dip_m) > min_front_dip * marks.top->size()[part.across()];
  }
};

/// Length of cloth around the trunk, or of a tight tape around both legs.
struct Around {
  double length_m = 0.0;
  bool is_parted = false;
  double single_m = 0.0;  ///< length around the largest curve
};

std::optional<Around> around(const sim::Surface& garment, const sim::Vec3& middle_m, double height_m) {
  std::vector<SectionCurve> curves = cut_section(garment, {{middle_m.x, height_m, middle_m.z}});
  std::erase_if(curves, [](const SectionCurve& curve) { return !curve.is_closed; });
  if (curves.empty()) return std::nullopt;
  const auto tape_m = [](const SectionCurve& curve) { return tight_tape_m(curve.points_m); };
  const SectionCurve& trunk = *std::ranges::max_element(curves, {}, tape_m);
  std::vector<sim::Vec2> both;
  std::size_t legs = 0;
  for (const SectionCurve& curve : curves) {
    if (tape_m(curve) > min_leg_girth_ratio * tape_m(trunk)) {
      ++legs;
      both.insert(both.end(), curve.points_m.begin(), curve.points_m.end());
    }
  }
  // A leg is beside the middle, though a wide one may reach over it. A trunk between sleeves is around the middle.
  sim::Extent box;
  for (const sim::Vec2& p : trunk.points_m) box.add({p.x, 0.0, p.y});
  const bool is_parted = legs > 1 && glm::length(box.middle()) > min_leg_offset * box.size()[sim::long_axis(box)];
  if (!is_parted && !is_around_point(trunk)) {
    return std::nullopt;  // a fold, or one leg where the other is open
  }
  return Around{is_parted ? tight_tape_m(both) : length_m(trunk), is_parted, length_m(trunk)};
}

}  // namespace

std::vector<SectionCurve> cut_section(const sim::Surface& surface, const CuttingPlane& plane) {
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

/// Returns the lower and the upper chain of the points in order of x (Andrew 1979).
std::vector<Vec2> convex_hull(std::vector<Vec2> points_m) {
  std::ranges::sort(points_m, [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Vec2& p : points_m) {
      while (hull.size() > first + 1 && sim::doubled_area(hull[hull.size() - 2], hull.back(), p) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    // The other chain begins where this one ends.
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
    if (sim::doubled_area(hull[i], hull[(i + 1) % hull.size()], point) < 0.0) return false;
  }
  return !hull.empty();
}

bool is_around_point(const SectionCurve& curve) {
  int turns = 0;
  for (std::size_t i = 0; i < curve.points_m.size(); ++i) {
    const Vec2& a = curve.points_m[i];
    const Vec2& b = curve.points_m[(i + 1) % curve.points_m.size()];
    // Counts crossings of the ray to the right of the plane's point, which is the origin.
    if ((a.y < 0.0) != (b.y < 0.0) && a.x + (b.x - a.x) * a.y / (a.y - b.y) > 0.0) {
      turns += a.y < 0.0 ? 1 : -1;
    }
  }
  return turns != 0;
}

GarmentMarks find_garment_marks(const sim::Garment& garment, std::span<const sim::Vec3> positions_m,
                                const Landmarks& landmarks) {
  const sim::Mesh mesh{{positions_m.begin(), positions_m.end()}, garment.mesh.triangles, {}};
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, garment.adjacency);
  const GarmentPart& part = *std::ranges::max_element(parts, {}, &GarmentPart::area_m2);
  const Opening* const top = top_opening(part);
  const Finder finder{landmarks, mesh, part};
  GarmentMarks marks;
  finder.find_hem_and_cuffs(top, marks);
  finder.find_top(top, marks);
  return marks;
}

const LimbOpening& find_nearest_opening(const std::vector<LimbOpening>& openings, const sim::Vec3& place_m) {
  const auto distance_m = [&](const LimbOpening& opening) { return glm::distance(opening.middle_m, place_m); };
  return *std::ranges::min_element(openings, {}, distance_m);
}

std::optional<double> girth_at(const sim::Surface& garment, double height_m) {
  const auto level = around(garment, sim::compute_extent(garment.positions_m).middle(), height_m);
  return level ? std::optional(level->length_m) : std::nullopt;
}

std::optional<double> leg_at(const sim::Surface& garment, double height_m) {
  const auto level = around(garment, sim::compute_extent(garment.positions_m).middle(), height_m);
  return level && level->is_parted ? std::optional(level->single_m) : std::nullopt;
}

std::optional<GarmentTube> find_tube(const sim::Surface& garment) {
  const sim::Extent box = sim::compute_extent(garment.positions_m);
  std::optional<GarmentTube> tube;
  double below_m = 0.0;
  std::size_t missed = 0;
  for (int k = 0; k < tube_levels; ++k) {
    const double height_m = box.lower.y + (k + 0.5) / tube_levels * box.size().y;
    const std::optional<Around> level = around(garment, box.middle(), height_m);
    const bool is_joining = tube && tube->fork_m == tube->max_height_m && level && !level->is_parted;
    missed = level ? 0 : missed + 1;
    if (tube &&
        (missed > max_missed_levels || (level && level->length_m > min_sleeve_girth_ratio * below_m && !is_joining))) {
      break;
    }
    if (level) {
      tube = tube.value_or(GarmentTube{height_m});
      tube->max_height_m = height_m;
      tube->fork_m = level->is_parted ? height_m : tube->fork_m;
      below_m = level->length_m;
    }
  }
  return tube;
}

}  // namespace taut::app
