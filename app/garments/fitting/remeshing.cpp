#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>

#include "app/base/errors.hpp"
#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/garments/fitting/triangle_net.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

using sim::Vec3;
struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Net = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

double max_side(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
}

/// A closed border of the model.
struct BorderLine {
  BorderLine(const sim::Mesh& mesh, const std::vector<sim::Index>& loop) {
    for (const sim::Index v : loop) {
      length_m += places.empty() ? 0.0 : glm::distance(places.back(), mesh.positions[v]);
      places.push_back(mesh.positions[v]);
      ways_m.push_back(length_m);
    }
    length_m += glm::distance(places.back(), places.front());
    places.push_back(places.front());
    ways_m.push_back(length_m);
  }

  /// Returns the same position within the border's length. It may be less than this before its begin or beyond its end.
  double wrap(double way_m) const {
    return way_m < 0.0 ? way_m + length_m : way_m >= length_m ? way_m - length_m : way_m;
  }
  Vec3 place(double way_m) const {
    const auto after = std::upper_bound(ways_m.begin() + 1, ways_m.end() - 1, way_m) - ways_m.begin();
    const auto k = static_cast<std::size_t>(after);
    const double edge = ways_m[k] - ways_m[k - 1];
    return places[k - 1] + (edge > 0.0 ? (way_m - ways_m[k - 1]) / edge : 0.0) * (places[k] - places[k - 1]);
  }

  std::vector<Vec3> places;
  std::vector<double> ways_m;
  double length_m = 0.0;
};

/// Position of a vertex on a border of the model.
struct OnLine {
  std::size_t line;
  double way_m;
};

class Remesher {
 public:
  Remesher(const sim::Mesh& surface, double edge_m, std::size_t max_looks)
      : model_(surface),
        tree_(surface.positions, surface.triangles),
        normals_(unit_normals(surface)),
        max_looks_(max_looks),
        length_(edge_m),
        at_(surface.positions),
        on_line_(surface.positions.size()),
        is_corner_(surface.positions.size(), 0) {
    net_.request_vertex_status();
    net_.request_halfedge_status();
    net_.request_edge_status();
    net_.request_face_status();
    sim::Groups parts = sim::connect_vertices(at_.size(), surface.triangles);
    for (sim::Index v = 0; v < at_.size(); ++v) {
      net_.new_vertex();
      part_.push_back(parts.find(v));
    }
    add_triangles(surface.triangles, net_);
    for (const std::vector<sim::Index>& loop : border_loops(surface)) {
      const BorderLine& line = lines_.emplace_back(surface, loop);
      for (std::size_t i = 0; i < loop.size(); ++i) on_line_[loop[i]] = {lines_.size() - 1, line.ways_m[i]};
      mark_corners(loop, line);
    }
  }

  sim::Mesh run() {
    for (int round = 0; round < remeshing_rounds; ++round) {
      split_long();
      collapse_short();
      flip([this](Edge e) { return evens_valences(e); });
      smooth();
      smooth();
    }
    for (int round = 0; round < 3; ++round) {
      flip([this](Edge e) { return widens_angles(e); });
      smooth();
    }
    flip([this](Edge e) { return widens_angles(e); });
    return {at_, to_triangles(net_), {}};
  }

 private:
  const Vec3& at(Vertex v) const { return at_[number(v)]; }
  Vec3& at(Vertex v) { return at_[number(v)]; }
  double length(Edge e) const {
    const Halfedge h = net_.halfedge_handle(e, 0);
    return glm::distance(at(net_.from_vertex_handle(h)), at(net_.to_vertex_handle(h)));
  }
  static Vec3 doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::cross(b - a, c - a); }

  void mark_corners(const std::vector<sim::Index>& loop, const BorderLine& line) {
    const std::size_t n = loop.size();
    const double reach_m = std::min(corner_reach_edges * length_, line.length_m);
    std::vector<double> straight;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& place = at_[loop[i]];
      const Vec3 before = place - line.place(line.wrap(line.ways_m[i] - reach_m));
      const Vec3 after = line.place(line.wrap(line.ways_m[i] + reach_m)) - place;
      const double lengths = glm::length(before) * glm::length(after);
      straight.push_back(lengths > 0.0 ? glm::dot(before, after) / lengths : 1.0);
    }
    for (std::size_t i = 0; i < n; ++i) {
      bool is_sharpest = straight[i] < max_corner_cosine;
      for (const std::size_t step : {std::size_t{1}, n - 1}) {
        for (std::size_t j = (i + step) % n; j != i && is_sharpest; j = (j + step) % n) {
          const double way_m = line.ways_m[j] - line.ways_m[i];
          if (line.wrap(step == 1 ? way_m : -way_m) > reach_m) break;
          is_sharpest = straight[i] < straight[j] || (straight[i] == straight[j] && i < j);
        }
      }
      is_corner_[loop[i]] = static_cast<char>(is_sharpest);
    }
  }

  /// Halves long edges, the longest first. Another order would leave fans of slivers in large triangles.
  void split_long() {
    for (bool is_split = true; is_split;) {
      std::vector<std::pair<double, int>> edges;
      for (const Edge e : net_.edges()) {
        throw_if_interrupted();
        if (length(e) > max_edge_ratio * length_) edges.emplace_back(-length(e), e.idx());
      }
      std::ranges::sort(edges);
      is_split = !edges.empty() && at_.size() < max_vertices;
      for (const auto& [negative, e] : edges) {
        throw_if_interrupted();
        if (at_.size() < max_vertices && 2.0 * negative <= edges.front().first) split(Edge(e));
      }
    }
  }

  void spend(std::size_t more) {
    looks_ += more;
    if (looks_ > max_looks_) {
      throw std::invalid_argument("it has too many needles across each other");
    }
  }

  /// Halves an edge. The new vertex moves onto the model if both halves become clearly shorter, so that splitting ends.
  void split(Edge e) {
    spend(looks_of_split);
    const bool is_border = net_.is_boundary(e);
    const Halfedge h = net_.halfedge_handle(e, is_border && net_.is_boundary(net_.halfedge_handle(e, 0)) ? 1 : 0);
    const Vertex a = net_.from_vertex_handle(h), b = net_.to_vertex_handle(h);
    const double most = max_half_ratio * length(e);
    at_.push_back(0.5 * (at(a) + at(b)));
    part_.push_back(part_[number(a)]);
    on_line_.push_back(is_border ? halfway(on_line_[number(a)], on_line_[number(b)]) : OnLine{});
    is_corner_.push_back(0);
    const Vertex added = net_.new_vertex();
    net_.split(e, added);
    const Vec3 place = is_border ? on_border(added) : on_model(added, at(added));
    if (is_border || (glm::distance(place, at(a)) < most && glm::distance(place, at(b)) < most)) {
      at(added) = place;
    }
  }

  OnLine halfway(const OnLine& from, const OnLine& to) const {
    const BorderLine& line = lines_[from.line];
    return {from.line, line.wrap(from.way_m + 0.5 * line.wrap(to.way_m - from.way_m))};
  }
  Vec3 on_border(Vertex v) const {
    const OnLine& on_line = on_line_[number(v)];
    return lines_[on_line.line].place(on_line.way_m);
  }

  void collapse_short() {
    bool changed = true;
    for (int sweep = 0; changed && sweep < max_collapse_sweeps; ++sweep) {
      changed = false;
      for (const Edge e : net_.edges()) {
        throw_if_interrupted();
        if (!(length(e) < min_edge_length_ratio * length_)) continue;
        for (const unsigned side : {0U, 1U}) {
          const Halfedge h = net_.halfedge_handle(e, side);
          if (may_collapse(h)) {
            net_.collapse(h);
            changed = true;
            break;
          }
        }
      }
    }
  }

  bool may_collapse(Halfedge h) {
    const Vertex from = net_.from_vertex_handle(h), to = net_.to_vertex_handle(h);
    spend(net_.valence(from) + net_.valence(to));
    const bool border = net_.is_boundary(from);
    if (is_corner_[number(from)] != 0 || (border && !net_.is_boundary(net_.edge_handle(h)))) return false;
    for (const Vertex a : net_.vv_range(from)) {
      if (a != to && glm::distance(at(a), at(to)) > max_edge_ratio * length_) return false;
    }
    return may_move(from, at(to), to) && net_.is_collapse_ok(h);
  }

  /// Returns whether a triangle still faces the side of its former normal and has an area.
  bool stays(const Vec3& normal_before, const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 now = doubled_area(a, b, c);
    const double side = max_side(a, b, c);
    const double before = glm::length(normal_before), after = glm::length(now);
    if (before < min_area_ratio * side * side) return true;
    return after >= min_area_ratio * side * side && glm::dot(now, normal_before) > min_normal_cosine * before * after;
  }

  template <class Wanted> void flip(const Wanted& wanted) {
    bool changed = true;
    for (int sweep = 0; changed && sweep < max_collapse_sweeps; ++sweep) {
      changed = false;
      for (const Edge e : net_.edges()) {
        throw_if_interrupted();
        if (!net_.is_boundary(e) && net_.is_flip_ok(e) && wanted(e) && may_flip(e)) {
          net_.flip(e);
          changed = true;
        }
      }
    }
  }

  bool may_flip(Edge e) const {
    const Diamond d = diamond(net_, e);
    const Vec3 before = doubled_area(at(d.a), at(d.b), at(d.left)) + doubled_area(at(d.b), at(d.a), at(d.right));
    return stays(before, at(d.left), at(d.right), at(d.b)) && stays(before, at(d.right), at(d.left), at(d.a));
  }

  int excess(Vertex v, int change) const {
    const int valence = static_cast<int>(net_.valence(v)) + change;
    const int off = valence - (net_.is_boundary(v) ? 4 : 6);
    return off * off;
  }
  bool evens_valences(Edge e) const {
    const Diamond d = diamond(net_, e);
    const int before = excess(d.a, 0) + excess(d.b, 0) + excess(d.left, 0) + excess(d.right, 0);
    const int after = excess(d.a, -1) + excess(d.b, -1) + excess(d.left, 1) + excess(d.right, 1);
    return after < before && narrowest({d.left, d.right, d.b, d.a}) < 0.94;
  }
  /// Returns the cosine of the smallest angle of the two triangles.
  double narrowest(const Diamond& d) const {
    return std::max(max_cosine(at(d.a), at(d.b), at(d.left)), max_cosine(at(d.b), at(d.a), at(d.right)));
  }
  bool widens_angles(Edge e) const {
    const Diamond d = diamond(net_, e);
    return narrowest({d.left, d.right, d.b, d.a}) < narrowest(d) - 1e-9;
  }
  static double max_cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double x = glm::dot(b - a, b - a), y = glm::dot(c - b, c - b), z = glm::dot(a - c, a - c);
    const auto cosine = [](double opposite, double p, double q) {
      return p * q > 0.0 ? (p + q - opposite) / (2.0 * std::sqrt(p * q)) : 1.0;
    };
    return std::max({cosine(x, y, z), cosine(y, z, x), cosine(z, x, y)});
  }

  /// Returns the other two vertices of the triangle of a halfedge that begins at a vertex.
  std::array<Vertex, 2> ends_across(Halfedge h) const {
    return {net_.to_vertex_handle(h), net_.to_vertex_handle(net_.next_halfedge_handle(h))};
  }

  Vec3 normal_at(Vertex v) const {
    Vec3 sum(0.0);
    for (const Halfedge h : net_.voh_range(v)) {
      if (!net_.is_boundary(h)) {
        const auto [a, b] = ends_across(h);
        sum += doubled_area(at(v), at(a), at(b));
      }
    }
    return sim::unit_or_zero(sum);
  }

  /// Returns the nearest point of the model that is in the same part and faces the same way.
  Vec3 on_model(Vertex v, const Vec3& place) {
    const sim::Index part = part_[number(v)];
    const Vec3 normal = normal_at(v);
    const auto faces_alike = [&](const TreeSurfacePoint& p) {
      return part_[model_.triangles[p.triangle][0]] == part &&
             glm::dot(normals_[p.triangle], normal) > min_normal_cosine;
    };
    const auto found = tree_.find_nearest(place, length_, faces_alike, &looks_);
    spend(0);
    return found ? found->place_m : place;
  }

  void smooth() {
    for (const Vertex v : net_.vertices()) {
      throw_if_interrupted();
      if (net_.is_isolated(v) || is_corner_[number(v)] != 0) continue;
      net_.is_boundary(v) ? smooth_border(v) : smooth_within(v);
    }
  }

  void smooth_within(Vertex v) {
    Vec3 sum(0.0);
    double count = 0.0;
    for (const Vertex other : net_.vv_range(v)) {
      sum += at(other);
      count += 1.0;
    }
    const Vec3 way = sum / count - at(v), normal = normal_at(v);
    for (double step = 1.0; step > 0.2; step *= 0.5) {
      const Vec3 place = on_model(v, at(v) + step * (way - glm::dot(way, normal) * normal));
      if (may_move(v, place)) {
        at(v) = place;
        return;
      }
    }
  }

  /// Moves a border vertex to the middle between its neighbours along the border.
  void smooth_border(Vertex v) {
    const Halfedge back = net_.halfedge_handle(v);  // the halfedge along the border, with the cloth on its right
    const OnLine here = on_line_[number(v)], before = on_line_[number(net_.to_vertex_handle(back))],
                 after = on_line_[number(net_.from_vertex_handle(net_.prev_halfedge_handle(back)))];
    const BorderLine& line = lines_[here.line];
    const double way_m = line.wrap(here.way_m - before.way_m) + line.wrap(after.way_m - here.way_m);
    on_line_[number(v)].way_m = line.wrap(before.way_m + 0.5 * way_m);
    const Vec3 place = on_border(v);
    if (may_move(v, place)) {
      at(v) = place;
    } else {
      on_line_[number(v)] = here;
    }
  }

  /// Returns whether the triangles around the vertex may have it at this place. Triangles with the vertex `merged` do
  /// not matter.
  bool may_move(Vertex v, const Vec3& place, Vertex merged = Vertex()) const {
    for (const Halfedge h : net_.voh_range(v)) {
      const auto [a, b] = ends_across(h);
      const bool matters = !net_.is_boundary(h) && a != merged && b != merged;
      if (matters && !stays(doubled_area(at(v), at(a), at(b)), place, at(a), at(b))) return false;
    }
    return true;
  }

  const sim::Mesh& model_;  ///< surface that the mesh approximates
  SurfaceTree tree_;
  std::vector<Vec3> normals_;
  std::vector<BorderLine> lines_;
  std::size_t max_looks_, looks_ = 0;
  double length_;
  OpenMesh::TriConnectivity net_;
  std::vector<Vec3> at_;          ///< position of each vertex
  std::vector<sim::Index> part_;  ///< part of the model of each vertex, of its own vertices first
  std::vector<OnLine> on_line_;   ///< position of each vertex on a border
  std::vector<char> is_corner_;   ///< flag of each vertex
};

/// Welds the ends of edges shorter than `least_m` that no collapse could remove, such as edges between two corners of a
/// border.
bool weld_ends(double least_m, sim::Mesh& mesh) {
  sim::Groups groups(mesh.positions.size());
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const sim::Index a = t[k], b = t[(k + 1) % 3];
      if (glm::distance(mesh.positions[a], mesh.positions[b]) < least_m) groups.join(a, b);
    }
  }
  return merge_vertices(groups, mesh.triangles) > 0;
}

/// Drops triangles lower than `least_m` that no flip could remove, mostly at borders.
bool drop_flat(double least_m, sim::Mesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const sim::Triangle& t) {
           const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
           return glm::length(glm::cross(b - a, c - a)) < least_m * max_side(a, b, c);
         }) > 0;
}

}  // namespace

sim::Mesh remesh(const sim::Mesh& surface, double edge_m, std::size_t max_looks) {
  sim::Mesh mesh = Remesher(surface, edge_m, max_looks).run();
  do {
    mesh = cut_into_sheets(mesh).mesh;
  } while (weld_ends(min_edge_ratio * edge_m, mesh) || drop_flat(min_height_ratio * edge_m, mesh));
  return mesh;
}

sim::Mesh simplify(const sim::Mesh& surface, std::size_t max_triangles) {
  Net net;
  for (const Vec3& p : surface.positions) net.add_vertex({p.x, p.y, p.z});
  add_triangles(surface.triangles, net);
  net.request_face_normals();
  net.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Net> decimater(net);
  OpenMesh::Decimater::ModQuadricT<Net>::Handle by_quadric;
  OpenMesh::Decimater::ModRoundnessT<Net>::Handle by_roundness;
  OpenMesh::Decimater::ModNormalFlippingT<Net>::Handle by_normal;
  decimater.add(by_quadric);
  decimater.add(by_roundness);
  decimater.add(by_normal);
  decimater.module(by_quadric).unset_max_err();
  decimater.module(by_roundness).set_min_roundness(min_roundness);
  decimater.module(by_normal).set_max_normal_deviation(max_normal_turn_deg);
  decimater.initialize();
  decimater.decimate_to_faces(0, max_triangles);
  net.garbage_collection();
  sim::Mesh mesh{{}, to_triangles(net), {}};
  for (const auto v : net.vertices()) mesh.positions.emplace_back(net.point(v)[0], net.point(v)[1], net.point(v)[2]);
  return mesh;
}

}  // namespace taut::app
