#include "app/garments/sewing/pattern.hpp"

#include "app/base/files.hpp"
#include "app/base/json_reading.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

using sim::Vec2;
using sim::Vec3;

constexpr double degree = 0.017453292519943295;
constexpr double max_panel_m = 20.0;  ///< longer panels have the wrong unit
constexpr double min_panel_m = 1e-3;
constexpr double min_edge_m = 1e-5;
constexpr double max_distance_m = 100.0;   ///< distance of a panel from the origin
constexpr double max_radius_m = 1e4;       ///< radius of an arc
constexpr std::size_t max_corners = 1000;  ///< corners of a panel
constexpr std::size_t max_stitches = 10000;
constexpr std::size_t max_panels = 500;
constexpr int max_curve_steps = 1024;

/// A value of the file and its path in it, such as pattern.panels.front.edges[3].
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string name, const std::string& file)
      : value_(&value), name_(std::move(name)), file_(&file) {}

  const nlohmann::json& value() const { return *value_; }
  bool has(const char* member) const {
    return value_->is_object() && value_->contains(member) && !(*value_)[member].is_null();
  }

  JsonPlace member(const std::string& key) const {
    if (!value_->is_object() || !value_->contains(key)) fail("a member '" + key + '\'');
    return {(*value_)[key], name_.empty() ? key : name_ + '.' + key, *file_};
  }
  JsonPlace item(std::size_t index) const { return {(*value_)[index], fmt::format("{}[{}]", name_, index), *file_}; }

  std::size_t count(std::size_t least, std::size_t most, const char* what) const {
    if (!value_->is_array() || value_->size() < least || value_->size() > most) {
      fail(fmt::format("a list of {}, at least {} and at most {}", what, least, most));
    }
    return value_->size();
  }
  std::vector<double> numbers(std::size_t wanted) const {
    std::vector<double> found;
    for (const nlohmann::json& number : value_->is_array() ? *value_ : nlohmann::json::array()) {
      if (number.is_number() && std::isfinite(number.get<double>())) found.push_back(number.get<double>());
    }
    if (found.size() != wanted || found.size() != value_->size()) fail(fmt::format("{} numbers", wanted));
    return found;
  }
  Vec2 point() const {
    const std::vector<double> found = numbers(2);
    return {found[0], found[1]};
  }
  std::size_t index_below(std::size_t limit, const char* what) const {
    if (!value_->is_number_integer() || value_->get<std::int64_t>() < 0 ||
        value_->get<std::int64_t>() >= static_cast<std::int64_t>(limit)) {
      fail(fmt::format("the number of {}, from 0 to {}", what, limit - 1));
    }
    return value_->get<std::size_t>();
  }
  std::string text() const {
    if (!value_->is_string()) fail("a text");
    return value_->get<std::string>();
  }

  [[noreturn]] void fail(const std::string& expected) const {
    constexpr std::size_t max_shown = 60;
    std::string found = value_->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    found = found.size() > max_shown ? found.substr(0, max_shown) + "..." : found;
    throw InputError("'{}': {}: found {}, expected {}", *file_, name_.empty() ? "the file" : name_, found, expected);
  }

 private:
  const nlohmann::json* value_;
  std::string name_;
  const std::string* file_;
};

/// Returns a polyline along a Bezier curve with these control points, in the unit of the file.
std::vector<Vec2> bezier(const std::vector<Vec2>& control, double tolerance) {
  // The error of n steps is at most an eighth of the largest second derivative over n squared.
  double second = 0.0;
  const auto degree_of = static_cast<double>(control.size() - 1);
  for (std::size_t k = 2; k < control.size(); ++k) {
    second = std::max(second,
                      degree_of * (degree_of - 1.0) * glm::length(control[k] - 2.0 * control[k - 1] + control[k - 2]));
  }
  const int steps =
      static_cast<int>(std::clamp(std::ceil(std::sqrt(second / (8.0 * tolerance))), 1.0, double{max_curve_steps}));
  std::vector<Vec2> line;
  for (int step = 0; step <= steps; ++step) {
    const double t = static_cast<double>(step) / steps;
    std::vector<Vec2> points = control;
    for (std::size_t left = points.size() - 1; left > 0; --left) {
      for (std::size_t k = 0; k < left; ++k) points[k] = (1.0 - t) * points[k] + t * points[k + 1];
    }
    line.push_back(points[0]);
  }
  line.back() = control.back();
  return line;
}

/// Returns a polyline along an arc from `from` to `to`: the larger or the smaller part of the circle, to the right or
/// to the left, as in SVG with y up. A radius below half the distance is increased to that.
std::vector<Vec2> arc(const Vec2& from, const Vec2& to, double radius, bool is_large, bool is_right, double tolerance) {
  const Vec2 along = to - from;
  const double half = 0.5 * glm::length(along);
  radius = std::max(radius, half);
  const double to_middle = std::sqrt(std::max(0.0, radius * radius - half * half));
  const Vec2 left = Vec2(-along.y, along.x) / (2.0 * half);
  const double side = is_large == is_right ? -1.0 : 1.0;
  const Vec2 middle = 0.5 * (from + to) + side * to_middle * left;
  const double half_angle = is_large ? 180.0 * degree - std::asin(half / radius) : std::asin(half / radius);
  const double per_step = 2.0 * std::acos(1.0 - std::min(1.0, tolerance / radius));
  const int steps = static_cast<int>(std::clamp(std::ceil(2.0 * half_angle / per_step), 2.0, double{max_curve_steps}));
  std::vector<Vec2> line = {from};
  for (int step = 1; step < steps; ++step) {
    const double angle = (is_right ? 2.0 : -2.0) * half_angle * step / steps;
    const Vec2 d = from - middle;
    line.push_back(middle +
                   Vec2(std::cos(angle) * d.x - std::sin(angle) * d.y, std::sin(angle) * d.x + std::cos(angle) * d.y));
  }
  line.push_back(to);
  return line;
}

std::vector<Vec2> read_arc(const JsonPlace& place, const Vec2& from, const Vec2& to, double tolerance) {
  std::vector<double> params;
  for (std::size_t k = 0; k < place.count(3, 3, "numbers"); ++k) {
    const nlohmann::json& number = place.item(k).value();
    params.push_back(number.is_boolean()  ? (number.get<bool>() ? 1.0 : 0.0)
                     : number.is_number() ? number.get<double>()
                                          : NAN);
  }
  const auto is_flag = [](double flag) { return flag == 0.0 || flag == 1.0; };
  if (!(params[0] > 0.0) || !(params[0] * line_tolerance_m <= max_radius_m * tolerance) || !is_flag(params[1]) ||
      !is_flag(params[2])) {
    place.fail(fmt::format(
        "a radius above 0 and up to {:g} m, then 1 or 0 for the larger arc, then 1 or 0 for one to the right",
        max_radius_m));
  }
  return arc(from, to, params[0], params[1] == 1.0, params[2] == 1.0, tolerance);
}

std::vector<Vec2> read_edge(const JsonPlace& edge, const Vec2& from, const Vec2& to, bool is_relative,
                            double tolerance) {
  if (!edge.has("curvature")) return {from, to};
  const auto frame = [&](const Vec2& p) {
    return is_relative ? from + p.x * (to - from) + p.y * Vec2(from.y - to.y, to.x - from.x) : p;
  };
  const JsonPlace curve = edge.member("curvature");
  std::vector<Vec2> control = {from};
  if (curve.value().is_array()) {
    control.push_back(frame(curve.point()));
    control.push_back(to);
    return bezier(control, tolerance);
  }
  const std::string type = curve.member("type").text();
  const JsonPlace params = curve.member("params");
  if (type == "circle") return read_arc(params, from, to, tolerance);
  const std::map<std::string, std::pair<std::size_t, std::size_t>> point_counts = {
      {"quadratic", {1, 1}}, {"cubic", {2, 2}}, {"polyline", {1, max_curve_steps}}};
  const auto found = point_counts.find(type);
  if (found == point_counts.end()) curve.member("type").fail("\"quadratic\", \"cubic\", \"circle\" or \"polyline\"");
  const std::size_t count = params.count(found->second.first, found->second.second, "points");
  for (std::size_t k = 0; k < count; ++k) control.push_back(frame(params.item(k).point()));
  control.push_back(to);
  return type == "polyline" ? control : bezier(control, tolerance);
}

/// Returns the rotation of Euler angles as in Maya: about x first, then y, then z.
glm::dmat3 to_rotation(const std::vector<double>& degrees) {
  glm::dmat3 rotation(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double c = std::cos(degrees[static_cast<std::size_t>(axis)] * degree),
                 s = std::sin(degrees[static_cast<std::size_t>(axis)] * degree);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    glm::dmat3 turn(1.0);
    turn[next][next] = turn[last][last] = c;
    turn[next][last] = s;
    turn[last][next] = -s;
    rotation = turn * rotation;
  }
  return rotation;
}

PatternPanel read_panel(const JsonPlace& place, const std::string& name, bool is_relative, double metres) {
  PatternPanel panel{name, {}};
  const JsonPlace vertices = place.member("vertices"), edges = place.member("edges");
  std::vector<Vec2> corners;
  const auto require_near = [&](const JsonPlace& found, const Vec2& point) {
    if (!(glm::length(point - corners.front()) * metres <= max_panel_m)) {
      found.fail(fmt::format("a panel of at most {} m; properties.units_in_meter says what a unit is", max_panel_m));
    }
  };
  for (std::size_t k = 0; k < vertices.count(2, max_corners, "points"); ++k) {
    corners.push_back(vertices.item(k).point());
    require_near(vertices.item(k), corners.back());
  }
  std::optional<std::size_t> at;
  std::size_t begin = 0;
  for (std::size_t e = 0; e < edges.count(2, max_corners, "edges"); ++e) {
    const JsonPlace ends = edges.item(e).member("endpoints");
    ends.count(2, 2, "vertices");
    const std::size_t from = ends.item(0).index_below(corners.size(), "a vertex");
    const std::size_t to = ends.item(1).index_below(corners.size(), "a vertex");
    begin = at ? begin : from;
    if (from != at.value_or(from)) ends.fail(fmt::format("an edge from vertex {}, where the one before ends", *at));
    if (!(glm::length(corners[to] - corners[from]) * metres >= min_edge_m)) {
      ends.fail(
          fmt::format("two vertices at least {} m apart; properties.units_in_meter says what a unit is", min_edge_m));
    }
    at = to;
    std::vector<Vec2> line =
        read_edge(edges.item(e), corners[from], corners[to], is_relative, line_tolerance_m / metres);
    for (Vec2& p : line) {
      require_near(edges.item(e), p);
      p *= metres;
    }
    panel.edges_m.push_back(std::move(line));
  }
  if (*at != begin) {
    edges.fail(fmt::format("a closed outline: the last edge ends at vertex {}, the first begins at {}", *at, begin));
  }
  sim::Extent box;
  for (const Vec2& corner : corners) box.add({corner * metres, 0.0});
  if (!(glm::length(box.size()) >= min_panel_m)) vertices.fail(fmt::format("a panel of at least {} m", min_panel_m));
  const auto vector_at = [&](const char* key) {
    return place.has(key) ? place.member(key).numbers(3) : std::vector<double>{0.0, 0.0, 0.0};
  };
  panel.rotation = to_rotation(vector_at("rotation"));
  const std::vector<double> t = vector_at("translation");
  panel.translation_m = metres * Vec3(t[0], t[1], t[2]);
  if (!(glm::length(panel.translation_m) <= max_distance_m)) {
    place.member("translation").fail(fmt::format("a place at most {} m from the origin", max_distance_m));
  }
  return panel;
}

PanelEdge read_side(const JsonPlace& side, const SewingPattern& pattern) {
  const JsonPlace name = side.member("panel");
  const std::string panel = name.text();
  const auto found = std::ranges::find(pattern.panels, panel, &PatternPanel::name);
  if (found == pattern.panels.end()) name.fail("the name of a panel");
  return {static_cast<std::size_t>(found - pattern.panels.begin()),
          side.member("edge").index_below(found->edges_m.size(), "an edge of that panel")};
}

}  // namespace

std::string SewingPattern::describe(const Stitch& stitch) const {
  return fmt::format("{}, edge {} with {}, edge {}", panels[stitch.first.panel].name, stitch.first.edge,
                     panels[stitch.second.panel].name, stitch.second.edge);
}

std::set<std::size_t> SewingPattern::sewn_with(std::set<std::size_t> together,
                                               const std::function<bool(std::size_t)>& may_be) const {
  for (std::size_t before = 0; before != together.size();) {
    before = together.size();
    for (const auto& [first, second] : stitches) {
      for (const auto& [a, b] : {std::pair(first.panel, second.panel), std::pair(second.panel, first.panel)}) {
        if (together.contains(a) && may_be(b)) together.insert(b);
      }
    }
  }
  return together;
}

std::pair<Vec3, Vec3> SewingPattern::placed_ends_m(const PanelEdge& edge) const {
  const std::vector<Vec2>& line = line_of(edge);
  return {panels[edge.panel].placed_m(line.front()), panels[edge.panel].placed_m(line.back())};
}

std::vector<PanelEdge> SewingPattern::edges() const {
  std::vector<PanelEdge> all;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t e = 0; e < panels[p].edges_m.size(); ++e) all.push_back({p, e});
  }
  return all;
}

std::vector<PanelEdge> SewingPattern::unsewn_edges() const {
  std::vector<PanelEdge> unsewn = edges();
  for (const Stitch& stitch : stitches) {
    std::erase_if(unsewn, [&](const PanelEdge& edge) { return edge == stitch.first || edge == stitch.second; });
  }
  return unsewn;
}

void add_pattern(const std::string& name, SewingPattern added, SewingPattern& pattern) {
  const std::size_t before = pattern.panels.size();
  for (PatternPanel& panel : added.panels) {
    panel.name = name + '.' + panel.name;
    pattern.panels.push_back(std::move(panel));
  }
  for (const auto& [first, second] : added.stitches) {
    pattern.stitches.push_back({{first.panel + before, first.edge}, {second.panel + before, second.edge}});
  }
}

SewingPattern read_sewing_pattern(const std::filesystem::path& path) {
  const std::string file = path.string();
  const auto json = parse_json<nlohmann::json>(read_text_file(path), '\'' + file + '\'',
                                               "a sewing pattern in the JSON of GarmentCode", true);
  const JsonPlace root(json, "", file);
  double metres = 0.01;
  bool is_relative = true;
  SewingPattern pattern;
  if (root.has("properties")) {
    const JsonPlace properties = root.member("properties");
    if (properties.has("joint")) pattern.joint = properties.member("joint").text();
    if (properties.has("units_in_meter")) {
      const JsonPlace unit = properties.member("units_in_meter");
      const double per_metre = unit.value().is_number() ? unit.value().get<double>() : 0.0;
      if (!(per_metre > 0.0) || !std::isfinite(per_metre)) unit.fail("how many units are a metre, a number above 0");
      metres = 1.0 / per_metre;
    }
    const std::string coords =
        properties.has("curvature_coords") ? properties.member("curvature_coords").text() : "relative";
    if (coords != "relative" && coords != "absolute") {
      properties.member("curvature_coords").fail("\"relative\" or \"absolute\"");
    }
    is_relative = coords == "relative";
  }
  const JsonPlace body = root.member("pattern"), panels = body.member("panels");
  if (!panels.value().is_object() || panels.value().empty() || panels.value().size() > max_panels) {
    panels.fail(fmt::format("1 to {} panels by their names", max_panels));
  }
  for (const auto& [name, value] : panels.value().items()) {
    pattern.panels.push_back(read_panel(panels.member(name), name, is_relative, metres));
  }
  const JsonPlace stitches = body.member("stitches");
  for (std::size_t s = 0; s < stitches.count(0, max_stitches, "stitches"); ++s) {
    const JsonPlace stitch = stitches.item(s);
    // Some files list after both sides the side that the cloth faces. The placement of panels says the same.
    stitch.count(2, 10, "sides");
    pattern.stitches.push_back({read_side(stitch.item(0), pattern), read_side(stitch.item(1), pattern)});
    const auto& [first, second] = pattern.stitches.back();
    if (first.panel == second.panel && first.edge == second.edge) stitch.fail("two different edges");
  }
  return pattern;
}

double polyline_length(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) length += glm::distance(line[k - 1], line[k]);
  return length;
}

std::vector<Vec2> evenly_along(const std::vector<Vec2>& line, std::size_t steps) {
  std::vector<Vec2> points = {line.front()};
  const double step = polyline_length(line) / static_cast<double>(steps);
  double before = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double length = glm::distance(line[k - 1], line[k]);
    while (points.size() < steps && static_cast<double>(points.size()) * step <= before + length) {
      const double share = (static_cast<double>(points.size()) * step - before) / length;
      points.push_back(line[k - 1] + share * (line[k] - line[k - 1]));
    }
    before += length;
  }
  points.resize(steps, line.back());
  points.push_back(line.back());
  return points;
}

}  // namespace taut::app
