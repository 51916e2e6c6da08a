#include "app/output/frame_verifier.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include "app/base/counted.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "app/verify/solid_bodies.hpp"

namespace taut::app {
namespace {

// How much more than the bound a length may be, a fraction: the rounding of singular values in the thinnest
// triangles that have a surface.
constexpr double rounding = 1e-9;

struct Enters {
  const Corners& triangle;

  bool operator()(const sim::Plane& plane) const {
    return enters_half_space(triangle, plane.point_m, plane.normal);
  }
  bool operator()(const sim::Sphere& ball) const {
    return enters_limb(triangle, {ball.centre_m, ball.centre_m, ball.radius_m, ball.radius_m});
  }
  bool operator()(const sim::Capsule& limb) const {
    return enters_limb(triangle, {limb.start_m, limb.end_m, limb.start_radius_m, limb.end_radius_m});
  }
  bool operator()(const sim::BodyMesh&) const { return false; }
};

/// Crossing pairs of one kind: how many, and a text about them; empty: none.
struct Finding {
  std::size_t pairs = 0;
  std::string text;
};

Finding crossings_of(const Surface& cloth) {
  const std::vector<CrossingPair> pairs = crossing_pairs(cloth);
  return {pairs.size(), pairs.empty() ? "" : describe(cloth, pairs)};
}

Finding crossings_with(const sim::BodyMesh& mesh, std::span<const sim::Vec3> positions_m,
                       const std::string& name, const Surface& cloth) {
  const Surface body = {positions_m, mesh.data->triangles};
  const std::vector<CrossingPair> pairs = crossing_pairs(cloth, body);
  if (pairs.empty()) {
    return {};
  }
  const CrossingPair& first = pairs.front();
  return {pairs.size(),
          fmt::format("{} with {}, the first: {} and its {} at {}",
                      counted(pairs.size(), "pair of triangles crosses", "pairs of triangles cross"), name,
                      describe_triangle(cloth, first.first), describe_triangle(body, first.second),
                      describe_place(first.place_m))};
}

Finding entries_into(const sim::Shape& shape, const std::string& name, const Surface& cloth) {
  std::vector<CrossingPair> entries;
  for (sim::Index t = 0; t < cloth.triangles.size(); ++t) {
    const sim::Triangle& v = cloth.triangles[t];
    const Corners corners = {cloth.positions_m[v[0]], cloth.positions_m[v[1]], cloth.positions_m[v[2]]};
    if (std::visit(Enters{corners}, shape)) {
      entries.push_back({t, 0, (corners[0] + corners[1] + corners[2]) / 3.0});
    }
  }
  if (entries.empty()) {
    return {};
  }
  return {entries.size(),
          fmt::format("{} {}, the first: {} near {}",
                      counted(entries.size(), "triangle enters", "triangles enter"), name,
                      describe_triangle(cloth, entries[0].first), describe_place(entries[0].place_m))};
}

Finding contact_with(const sim::Body& body, std::size_t number, double time_s, const Surface& cloth) {
  const std::string name =
      body.name.empty() ? fmt::format("body {}", number) : fmt::format("the body '{}'", body.name);
  const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape);
  if (mesh == nullptr) {
    return entries_into(sim::shape_at(body, time_s), name, cloth);
  }
  std::vector<sim::Vec3> positions_m(mesh->data->positions_m.size());
  sim::positions_at(body, time_s, positions_m);
  return crossings_with(*mesh, positions_m, name, cloth);
}

}  // namespace

std::string describe_excess(const LargestStretch& stretch, const sim::SolverSettings& solver) {
  const auto* bounded = std::get_if<sim::BoundedSettings>(&solver.method);
  if (bounded == nullptr || bounded->allow_exceeding) {
    return "";
  }
  const double most = bounded->max_stretch + rounding;
  const auto text = [&](const char* what, double largest) {
    return fmt::format("{} stretched by {:.7f} %, more than solver.max_stretch = {:g} %", what,
                       100.0 * largest, 100.0 * bounded->max_stretch);
  };
  if (!(stretch.springs <= most)) {
    return text("a spring is", stretch.springs);
  }
  const bool holds_surface = bounded->bound == sim::BoundKind::surface;
  return holds_surface && !(stretch.surface <= most) ? text("a triangle is", stretch.surface) : "";
}

std::string FrameVerifier::check(const sim::Simulation& simulation, FrameRecord& record) {
  const sim::Mesh& mesh = simulation.garment().mesh;
  const Surface cloth = {simulation.state().current, mesh.triangles};
  const LargestStretch stretch = largest_stretch(mesh, cloth.positions_m);
  ++frames_;
  largest_.springs = std::max(largest_.springs, stretch.springs);
  largest_.surface = std::max(largest_.surface, stretch.surface);

  std::vector<Finding> findings = {crossings_of(cloth)};
  const std::vector<sim::Body>& bodies = simulation.surroundings().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    findings.push_back(contact_with(bodies[b], b, record.time_s, cloth));
  }
  findings.push_back({0, describe_excess(stretch, simulation.settings().solver)});

  record.crossing_pairs = 0;
  std::string broken;
  for (const Finding& finding : findings) {
    *record.crossing_pairs += finding.pairs;
    broken += (broken.empty() || finding.text.empty() ? "" : "; ") + finding.text;
  }
  return broken.empty() ? "" : fmt::format("frame {}, {:.4f} s: {}", record.frame, record.time_s, broken);
}

std::string FrameVerifier::summary() const {
  return fmt::format("verified {}: 0 crossing pairs, largest stretch {:.4f} %, of the surface {:.4f} %",
                     counted(static_cast<std::size_t>(frames_), "frame"), 100.0 * largest_.springs,
                     100.0 * largest_.surface);
}

}  // namespace taut::app
