#include "drape_meter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "app/base/errors.hpp"
#include "sim/mesh/elementary.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

/// Side of the squares in which the shadow is counted.
constexpr double square_m = 2.5e-4;
constexpr int side_squares = 1280;
/// Number of directions in which the outline is measured, and of directions to each side over which it is smoothed.
constexpr int direction_count = 720;
constexpr int evened_directions = 12;
/// Minimum height of a fold above the dents beside it.
constexpr double min_fold_m = 0.003;
/// Frames after which a disc that still moves is measured.
constexpr int max_frames = 600;
constexpr double air_drag_per_s = 6.0;
/// Time in which the cloth gets its weight, as the instrument's plate is lowered slowly. A disc that is dropped at once
/// has more folds at rest.
constexpr double lowered_in_s = 3.0;

/// Returns twice the area of a triangle, above 0 if it turns counter-clockwise.
double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Marks the squares whose middles lie in a triangle, whose corners are in squares.
void mark_shadow(glm::dvec2 a, glm::dvec2 b, const glm::dvec2& c, std::vector<char>& squares) {
  if (doubled_area(a, b, c) < 0.0) std::swap(a, b);
  const glm::dvec2 lower = glm::clamp(glm::min(a, glm::min(b, c)), 0.0, side_squares - 1.0);
  const glm::dvec2 upper = glm::clamp(glm::max(a, glm::max(b, c)), 0.0, side_squares - 1.0);
  for (int row = static_cast<int>(lower.y); row <= static_cast<int>(upper.y); ++row) {
    for (int column = static_cast<int>(lower.x); column <= static_cast<int>(upper.x); ++column) {
      const glm::dvec2 middle(column + 0.5, row + 0.5);
      const double inside =
          std::min({doubled_area(a, b, middle), doubled_area(b, c, middle), doubled_area(c, a, middle)});
      if (inside >= 0.0) squares[static_cast<std::size_t>(row * side_squares + column)] = 1;
    }
  }
}

std::vector<char> shadow_squares(std::span<const sim::Triangle> triangles, std::span<const sim::Vec3> positions_m) {
  std::vector<char> squares(static_cast<std::size_t>(side_squares) * side_squares, 0);
  const auto place = [&](sim::Index v) {
    return glm::dvec2(positions_m[v].x, positions_m[v].z) / square_m + 0.5 * side_squares;
  };
  for (const sim::Triangle& t : triangles) mark_shadow(place(t[0]), place(t[1]), place(t[2]), squares);
  return squares;
}

/// Returns the radius of the shadow in each direction, in metres.
std::vector<double> outline_m(const std::vector<char>& squares) {
  std::vector<double> radii_m;
  for (int k = 0; k < direction_count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / direction_count;
    double radius = 0.5 * side_squares - 1.0;
    const auto is_lit = [&] {
      const int column = static_cast<int>(0.5 * side_squares + radius * std::cos(angle));
      const int row = static_cast<int>(0.5 * side_squares + radius * std::sin(angle));
      return squares[static_cast<std::size_t>(row * side_squares + column)] == 0;
    };
    while (radius > 0.0 && is_lit()) {
      radius -= 0.5;
    }
    radii_m.push_back(radius * square_m);
  }
  return radii_m;
}

std::vector<double> even_out(const std::vector<double>& around) {
  const auto count = static_cast<int>(around.size());
  std::vector<double> means;
  for (int k = 0; k < count; ++k) {
    double sum = 0.0;
    for (int d = -evened_directions; d <= evened_directions; ++d) {
      sum += around[static_cast<std::size_t>((k + d + count) % count)];
    }
    means.push_back(sum / (2 * evened_directions + 1));
  }
  return means;
}

/// Counts how often the outline rises from a dent to a fold in one turn.
int fold_count(const std::vector<double>& radii_m) {
  const auto lowest = std::min_element(radii_m.begin(), radii_m.end());
  std::vector<double> around = radii_m;
  std::rotate(around.begin(), around.begin() + (lowest - radii_m.begin()), around.end());
  int folds = 0;
  bool rises = false;
  double turned_m = around.front();
  for (const double radius_m : around) {
    turned_m = rises ? std::max(turned_m, radius_m) : std::min(turned_m, radius_m);
    if (rises ? radius_m < turned_m - min_fold_m : radius_m > turned_m + min_fold_m) {
      folds += rises ? 0 : 1;
      rises = !rises;
      turned_m = radius_m;
    }
  }
  return folds;
}

sim::SimulationSettings drape_settings() {
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.max_stretch = 0.01};
  return settings;
}

using Points = std::vector<glm::dvec2>;

/// Largest distance of a point from its lattice position, as a fraction of the edge length.
constexpr double scatter = 0.25;
/// Smallest distance of a lattice point from the circles, as a fraction of the edge length.
constexpr double clearance = 0.65;
/// Size of the triangle around all points, in radii of the disc. It is so large that circles through the border are not
/// affected.
constexpr double far_away = 50.0;
/// Random shift of all points before they are joined, as a fraction of the edge length: otherwise more than three
/// points of the border would lie on one circle.
constexpr double aside = 1e-3;

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// Returns a number in [low, high), with the same bits on every machine.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 bits_;
};

void add_circle(double radius_m, double edge_m, Random& random, Points& points) {
  const double count = std::round(2.0 * std::numbers::pi * radius_m / edge_m);
  const double first = random.between(0.0, 1.0);
  for (double k = 0.0; k < count; k += 1.0) {
    const double turns = (k + first) / count;
    points.push_back({radius_m * sim::cosine_of_turns(turns), radius_m * sim::sine_of_turns(turns)});
  }
}

/// Adds points of equilateral triangles, turned and shifted at random.
void add_lattice(double inner_m, double radius_m, double edge_m, Random& random, Points& points) {
  const double turns = random.between(0.0, 1.0);
  const glm::dvec2 along{sim::cosine_of_turns(turns), sim::sine_of_turns(turns)};
  const glm::dvec2 across{-along.y, along.x};
  const int most = static_cast<int>(std::ceil(1.2 * radius_m / edge_m)) + 1;
  for (int row = -most; row <= most; ++row) {
    for (int column = -most; column <= most; ++column) {
      const double x = column + (row % 2 == 0 ? 0.0 : 0.5) + random.between(-scatter, scatter);
      const double y = 0.8660254037844386 * row + random.between(-scatter, scatter);
      const glm::dvec2 point = edge_m * (x * along + y * across);
      const double from_middle_m = glm::length(point);
      if (from_middle_m < radius_m - clearance * edge_m && std::abs(from_middle_m - inner_m) > clearance * edge_m) {
        points.push_back(point);
      }
    }
  }
}

/// Returns true if p lies in the circle through a, b and c, which are counter-clockwise.
bool is_in_circle(const glm::dvec2& p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  a -= p;
  b -= p;
  c -= p;
  return glm::dot(a, a) * (b.x * c.y - b.y * c.x) - glm::dot(b, b) * (a.x * c.y - a.y * c.x) +
             glm::dot(c, c) * (a.x * b.y - a.y * b.x) >
         0.0;
}

/// Adds a point to the triangles: triangles whose circumcircle contains it are replaced by a fan around it.
void insert(const Points& points, sim::Index p, std::vector<sim::Triangle>& triangles) {
  std::map<sim::Edge, int> edges;
  std::vector<sim::Triangle> kept;
  for (const sim::Triangle& t : triangles) {
    if (!is_in_circle(points[p], points[t[0]], points[t[1]], points[t[2]])) {
      kept.push_back(t);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge[1], edge[0]})) {
      kept.push_back({edge[0], edge[1], p});
    }
  }
  triangles = std::move(kept);
}

std::vector<sim::Triangle> triangulate(Points points, double radius_m) {
  const auto count = static_cast<sim::Index>(points.size());
  const double far_m = far_away * radius_m;
  points.insert(points.end(), {{-far_m, -far_m}, {far_m, -far_m}, {0.0, far_m}});
  std::vector<sim::Triangle> triangles = {{count, count + 1, count + 2}};
  for (sim::Index p = 0; p < count; ++p) {
    insert(points, p, triangles);
  }
  std::erase_if(triangles, [&](const sim::Triangle& t) {
    return t[0] >= count || t[1] >= count || t[2] >= count ||
           doubled_area(points[t[0]], points[t[1]], points[t[2]]) < 1e-4 * radius_m * radius_m / count;
  });
  return triangles;
}

constexpr float from_above_rad = 1.55F;
constexpr float narrow_view_rad = 0.2F;

/// Returns "from-to", or one number if both are equal.
std::string range_text(int from, int to) {
  return from == to ? fmt::format("{}", from) : fmt::format("{}-{}", from, to);
}

Recording seen_from_above(const DrapedFabric& draped) {
  Recording recording;
  recording.scene = draped.scene;
  recording.scene.camera.framing = {
      .azimuth_rad = 0.0F, .elevation_rad = from_above_rad, .vertical_fov_rad = narrow_view_rad};
  recording.scene.picture.show_pins = false;
  const DrapeRun& run = draped.runs.back();
  recording.garment = run.garment;
  recording.pins = run.pins;
  recording.moments.push_back({{}, run.positions_m});
  return recording;
}

std::string measured_text(const DrapedFabric& draped) {
  const std::string published = draped.fabric.published_drape_text();
  return fmt::format("{:.0f} ± {:.0f} %{}; {} folds", draped.mean_percent(), draped.spread_percent(),
                     published.empty() ? "" : ", published " + published + " %", draped.folds());
}

}  // namespace

DrapeShadow drape_shadow(std::span<const sim::Triangle> triangles, std::span<const sim::Vec3> positions_m) {
  const std::vector<char> squares = shadow_squares(triangles, positions_m);
  const double shadow_m2 = square_m * square_m * static_cast<double>(std::count(squares.begin(), squares.end(), 1));
  const double clamped_m2 = std::numbers::pi * clamped_radius_m * clamped_radius_m;
  const double flat_m2 = std::numbers::pi * draped_radius_m * draped_radius_m;
  return {(shadow_m2 - clamped_m2) / (flat_m2 - clamped_m2), fold_count(even_out(outline_m(squares)))};
}

DrapeRun run_drape(const sim::Material& fabric, const DiscMesh& mesh, const ProgressCallback& report_progress) {
  DrapeRun run;
  run.garment = sim::share(sim::make_garment(make_disc(clamped_radius_m, draped_radius_m, mesh), {}, fabric));
  const std::vector<sim::Vec3>& flat_m = run.garment->mesh.positions;
  for (sim::Index v = 0; v < flat_m.size(); ++v) {
    if (glm::length(flat_m[v]) < clamped_radius_m + 1e-6) {
      run.pins.push_back(v);
    }
  }
  sim::Surroundings air;
  air.forces.air_drag_per_s = air_drag_per_s;
  air.forces.gravity_path = {{0.0, -air.forces.gravity_m_per_s2}, {lowered_in_s, sim::Vec3(0.0)}};
  sim::Simulation simulation(run.garment, run.pins, drape_settings(), air);
  while (run.frames < max_frames && !simulation.state().asleep) {
    report_progress(static_cast<double>(run.frames) / max_frames);
    simulation.advance_frame(throw_if_interrupted);
    ++run.frames;
  }
  run.at_rest = simulation.state().asleep;
  run.positions_m = simulation.state().current;
  run.shadow = drape_shadow(run.garment->mesh.triangles, run.positions_m);
  run.max_stretch = sim::measure_surface_stretch(*run.garment, run.positions_m).max;
  return run;
}

sim::Mesh make_disc(double inner_radius_m, double radius_m, const DiscMesh& mesh) {
  Random random(mesh.seed);
  Points points;
  add_circle(inner_radius_m, mesh.edge_m, random, points);
  add_circle(radius_m, mesh.edge_m, random, points);
  add_lattice(inner_radius_m, radius_m, mesh.edge_m, random, points);
  sim::Mesh disc;
  for (const glm::dvec2& p : points) {
    disc.positions.push_back({p.x, 0.0, -p.y});
  }
  for (glm::dvec2& p : points) {
    // Separate statements, because compilers choose the order of a call's arguments.
    const double up = random.between(-aside, aside);
    const double right = random.between(-aside, aside);
    p += mesh.edge_m * glm::dvec2(right, up);
  }
  disc.triangles = triangulate(std::move(points), radius_m);
  return disc;
}

double DrapedFabric::mean_percent() const {
  const double sum = std::accumulate(runs.begin(), runs.end(), 0.0, [](double before, const DrapeRun& run) {
    return before + run.shadow.coefficient;
  });
  return 100.0 * sum / static_cast<double>(runs.size());
}

double DrapedFabric::spread_percent() const {
  const auto [least, most] = std::minmax_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.shadow.coefficient < b.shadow.coefficient;
  });
  return 50.0 * (most->shadow.coefficient - least->shadow.coefficient);
}

std::string DrapedFabric::folds() const {
  const auto [fewest, most] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.shadow.folds < b.shadow.folds; });
  return range_text(fewest->shadow.folds, most->shadow.folds);
}

Drawing draw_drapes(std::span<const DrapedFabric> fabrics, LazyOffscreenRenderer& offscreen) {
  std::vector<Recording> recordings;
  std::vector<Caption> captions;
  for (const DrapedFabric& draped : fabrics) {
    recordings.push_back(seen_from_above(draped));
    captions.push_back({'\0', draped.fabric.name, measured_text(draped)});
  }
  const SheetStyle style{.columns = 4, .gap_px = 16.0F, .caption = {.text_px = 30.0F, .measured_px = 22.0F}};
  return sheet_of_last(recordings, captions, {460, 460}, style, false, offscreen);
}

}  // namespace taut::app
