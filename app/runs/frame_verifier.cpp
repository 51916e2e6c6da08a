#include "app/runs/frame_verifier.hpp"

#include "app/base/words.hpp"
#include "app/verify/crossing_pairs.hpp"

namespace taut::app {
namespace {

// Excess over the bound that counts as rounding, a fraction: the error of singular values in the thinnest triangles
// that have a surface.
constexpr double rounding = 1e-9;

using Pairs = std::vector<sim::CrossingPair>;

bool enters_shape(const Corners& triangle, const sim::Shape& shape) {
  if (const auto* plane = std::get_if<sim::Plane>(&shape)) {
    return enters_half_space(triangle, plane->point_m, plane->normal);
  }
  if (const auto* ball = std::get_if<sim::Sphere>(&shape)) {
    return enters_limb(triangle, {ball->centre_m, ball->centre_m, ball->radius_m, ball->radius_m});
  }
  const auto& limb = std::get<sim::Capsule>(shape);
  return enters_limb(triangle, {limb.start_m, limb.end_m, limb.start_radius_m, limb.end_radius_m});
}

Pairs judge_body(const sim::Surface& cloth, const sim::Body& body, double time_s) {
  if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
    const std::vector<sim::Vec3> positions_m = mesh_positions_m(body, time_s);
    return crossing_pairs(cloth, {positions_m, mesh->data->triangles});
  }
  const sim::Shape shape = sim::shape_at(body, time_s);
  Pairs entries;
  for (sim::Index t = 0; t < cloth.triangles.size(); ++t) {
    const sim::Triangle& v = cloth.triangles[t];
    const Corners corners = {cloth.positions_m[v[0]], cloth.positions_m[v[1]], cloth.positions_m[v[2]]};
    if (enters_shape(corners, shape)) entries.push_back({t, 0, (corners[0] + corners[1] + corners[2]) / 3.0});
  }
  return entries;
}

/// Returns what scene_crossings() does, judged exactly.
std::vector<SceneCrossings> judge_crossings(const sim::Surface& cloth, std::span<const sim::Body> bodies,
                                            double time_s) {
  std::vector<SceneCrossings> all = {{{}, crossing_pairs(cloth)}};
  for (std::size_t b = 0; b < bodies.size(); ++b) all.push_back({b, judge_body(cloth, bodies[b], time_s)});
  return all;
}

bool is_before(const sim::CrossingPair& a, const sim::CrossingPair& b) {
  return std::pair(a.first, a.second) < std::pair(b.first, b.second);
}

/// Returns `pairs` without those in `left_out`. Both must be sorted.
Pairs remove_pairs(const Pairs& pairs, const Pairs& left_out) {
  Pairs remaining;
  std::set_difference(pairs.begin(), pairs.end(), left_out.begin(), left_out.end(), std::back_inserter(remaining),
                      is_before);
  return remaining;
}

/// Returns the contact-free group of every triangle that contact leaves out, of the cloth or of a body.
std::map<sim::Index, sim::Index> map_groups(const sim::Simulation& simulation, std::optional<std::size_t> body) {
  std::map<sim::Index, sim::Index> groups;
  for (const sim::ExcludedTriangle& t : simulation.last_report().excluded_triangles) {
    if (t.body == body) groups[t.triangle] = t.group;
  }
  return groups;
}

/// Returns the pairs whose triangles are not in the same contact-free group.
Pairs counted_pairs(const Pairs& pairs, const sim::Simulation& simulation, std::optional<std::size_t> body) {
  std::map<sim::Index, sim::Index> first = map_groups(simulation, {}), second = map_groups(simulation, body);
  Pairs outside = pairs;
  std::erase_if(outside, [&](const sim::CrossingPair& pair) {
    return first[pair.first] > 0 && first[pair.first] == second[pair.second];
  });
  return outside;
}

}  // namespace

std::string describe_excess(const LargestStretch& stretch, const sim::SolverSettings& solver) {
  const auto* bounded = std::get_if<sim::BoundedSettings>(&solver.method);
  if (bounded == nullptr || bounded->allow_exceeding) return "";
  const double max_allowed = bounded->max_stretch + rounding;
  const auto text = [&](const char* what, double largest) {
    return fmt::format("{} stretched by {:.7f} %, more than solver.max_stretch = {:g} %", what, 100.0 * largest,
                       100.0 * bounded->max_stretch);
  };
  if (!(stretch.springs <= max_allowed)) return text("a spring is", stretch.springs);
  const bool holds_surface = bounded->bound == sim::BoundKind::surface;
  return holds_surface && !(stretch.surface <= max_allowed) ? text("a triangle is", stretch.surface) : "";
}

std::string FrameVerifier::begin(const sim::Simulation& simulation) {
  const sim::Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
  const std::vector<sim::Body>& bodies = simulation.surroundings().bodies;
  ignored_pairs_ = judge_crossings(cloth, bodies, simulation.state().time_s);
  std::vector<std::string> texts;
  crossing_at_start_ = 0;
  for (const SceneCrossings& crossings : ignored_pairs_) {
    crossing_at_start_ += crossings.pairs.size();
    if (!crossings.pairs.empty()) texts.push_back(describe(crossings, cloth, bodies));
  }
  return join(texts, "; ");
}

std::string FrameVerifier::check(const sim::Simulation& simulation, FrameRecord& record) {
  const sim::Mesh& mesh = simulation.garment().mesh;
  const sim::Surface cloth = {simulation.state().current, mesh.triangles};
  const LargestStretch stretch = largest_stretch(mesh, cloth.positions_m);
  ++frames_;
  largest_.springs = std::max(largest_.springs, stretch.springs);
  largest_.surface = std::max(largest_.surface, stretch.surface);

  record.crossing_pairs = 0;
  crossing_at_end_ = 0;
  std::vector<std::string> broken;
  const std::vector<sim::Body>& bodies = simulation.surroundings().bodies;
  std::vector<SceneCrossings> scene_pairs = judge_crossings(cloth, bodies, record.time_s);
  ignored_pairs_.resize(scene_pairs.size());
  for (std::size_t k = 0; k < scene_pairs.size(); ++k) {
    crossing_at_end_ += scene_pairs[k].pairs.size();
    const Pairs counting =
        counted_pairs(remove_pairs(scene_pairs[k].pairs, ignored_pairs_[k].pairs), simulation, scene_pairs[k].body);
    // Pairs that have separated count again from now on.
    ignored_pairs_[k].pairs = remove_pairs(scene_pairs[k].pairs, counting);
    scene_pairs[k].pairs = counting;
    *record.crossing_pairs += counting.size();
    if (!counting.empty()) broken.push_back(describe(scene_pairs[k], cloth, bodies));
  }
  const std::string excess = describe_excess(stretch, simulation.settings().solver);
  if (!excess.empty()) broken.push_back(excess);
  if (broken.empty()) return "";
  return fmt::format("frame {}, {:.4f} s: {}", record.frame, record.time_s, join(broken, "; "));
}

std::string FrameVerifier::summary() const {
  return fmt::format("verified {}: 0 crossing pairs{}, largest stretch {:.4f} %, of the surface {:.4f} %",
                     count_text(static_cast<std::size_t>(frames_), "frame"),
                     crossing_at_start_ + crossing_at_end_ == 0
                         ? ""
                         : fmt::format(" outside what crosses since the start: {} pairs then, {} at the end",
                                       crossing_at_start_, crossing_at_end_),
                     100.0 * largest_.springs, 100.0 * largest_.surface);
}

}  // namespace taut::app
