#include "app/models/inspecting/scene_crossings.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "sim/contact/contact_measure.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

std::vector<sim::CrossingPair> entries_into(const sim::Shape& shape, const sim::Surface& cloth) {
  std::vector<sim::CrossingPair> entries;
  for (sim::Index t = 0; t < cloth.triangles.size(); ++t) {
    const sim::Triangle& v = cloth.triangles[t];
    const sim::Corners corners = {cloth.positions_m[v[0]], cloth.positions_m[v[1]], cloth.positions_m[v[2]]};
    if (sim::enters(corners, shape)) entries.push_back({t, 0, (corners[0] + corners[1] + corners[2]) / 3.0});
  }
  return entries;
}

std::string describe_triangle(const sim::Surface& surface, sim::Index triangle) {
  const sim::Triangle& t = surface.triangles[triangle];
  return fmt::format("triangle {} (vertices {}, {}, {})", triangle, t[0], t[1], t[2]);
}

}  // namespace

SceneCrossings crossings_with(std::span<const sim::Body> bodies, std::size_t body, double time_s,
                              const sim::Surface& cloth) {
  const auto* mesh = std::get_if<sim::BodyMesh>(&bodies[body].shape);
  if (mesh == nullptr) return {body, entries_into(sim::shape_at(bodies[body], time_s), cloth)};
  const std::vector<sim::Vec3> positions_m = mesh_positions_m(bodies[body], time_s);
  return {body, sim::find_crossing_pairs(cloth, {positions_m, mesh->data->triangles})};
}

std::vector<SceneCrossings> scene_crossings(const sim::Surface& cloth, std::span<const sim::Body> bodies,
                                            double time_s) {
  std::vector<SceneCrossings> all = {{{}, sim::find_crossing_pairs(cloth)}};
  for (std::size_t b = 0; b < bodies.size(); ++b) all.push_back(crossings_with(bodies, b, time_s, cloth));
  return all;
}

std::string describe(const sim::Surface& cloth, std::span<const sim::CrossingPair> pairs) {
  const sim::CrossingPair& first = pairs.front();
  return fmt::format("{}, the first: {} and {} at {}",
                     count_text(pairs.size(), "pair of triangles crosses", "pairs of triangles cross"),
                     describe_triangle(cloth, first.first), describe_triangle(cloth, first.second),
                     describe_place(first.place_m));
}

std::string describe(const SceneCrossings& crossings, const sim::Surface& cloth, std::span<const sim::Body> bodies) {
  if (!crossings.body) return describe(cloth, crossings.pairs);
  const std::size_t count = crossings.pairs.size();
  const sim::CrossingPair& first = crossings.pairs.front();
  const std::string name = describe_body(bodies, *crossings.body);
  const std::string triangle = describe_triangle(cloth, first.first);
  const std::string place = describe_place(first.place_m);
  if (const auto* mesh = std::get_if<sim::BodyMesh>(&bodies[*crossings.body].shape)) {
    return fmt::format("{} with {}, the first: {} and its {} at {}",
                       count_text(count, "pair of triangles crosses", "pairs of triangles cross"), name, triangle,
                       describe_triangle({{}, mesh->data->triangles}, first.second), place);
  }
  return fmt::format("{} {}, the first: {} near {}", count_text(count, "triangle enters", "triangles enter"), name,
                     triangle, place);
}

std::string describe_body(std::span<const sim::Body> bodies, std::size_t body) {
  const std::string& name = bodies[body].name;
  return name.empty() ? fmt::format("body {}", body) : fmt::format("the body '{}'", name);
}

std::vector<sim::Vec3> mesh_positions_m(const sim::Body& body, double time_s) {
  std::vector<sim::Vec3> positions_m(std::get<sim::BodyMesh>(body.shape).data->positions_m.size());
  sim::positions_at(body, time_s, positions_m);
  return positions_m;
}

std::optional<UntangleReport> untangle_start(const Scene& scene, const sim::Garment& garment, bool is_cut_anew,
                                             std::vector<sim::Vec3>& start_m,
                                             const std::function<void(const std::string&)>& tell) {
  int round = 0;
  sim::UntangleSettings settings;
  settings.bounded = scene.simulation.solver.bounded;
  settings.distance_m = garment.material.thickness_m;
  settings.is_cut_anew = is_cut_anew;
  sim::UntangleResult untangled =
      sim::untangle(garment, start_m, settings, [&](std::span<const sim::Vec3> positions_m) {
        throw_if_interrupted();
        const auto to_triangles = [](const sim::CrossingPair& p) { return sim::TrianglePair{p.first, p.second}; };
        const auto pairs =
            collect<sim::TrianglePair>(sim::find_crossing_pairs({positions_m, garment.mesh.triangles}), to_triangles);
        tell(fmt::format("untangling it, round {}: {} cross", ++round, count_text(pairs.size(), "pair")));
        return pairs;
      });
  if (untangled.pairs_before == 0 && untangled.max_move_m == 0.0) return std::nullopt;
  start_m = std::move(untangled.positions_m);
  return untangled;
}

std::string describe(const UntangleReport& u) {
  if (u.pairs_before == 0) {
    return fmt::format("where layers were as one it was parted and evened out, no vertex by more than {:.3g} mm",
                       1e3 * u.max_move_m);
  }
  return fmt::format("of {} that crossed at the start {} left, and no vertex was moved by more than {:.3g} mm{}",
                     count_text(u.pairs_before, "pair of triangles", "pairs of triangles"),
                     u.pairs_left == 1 ? "1 is" : fmt::format("{} are", u.pairs_left), 1e3 * u.max_move_m,
                     u.is_given_up ? "; untangling was given up, as so much of it crosses" : "");
}

}  // namespace taut::app
