#include "app/models/mending/model_fitting.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/fitting/comparison.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "app/models/mending/tuning.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace mending;

namespace {

using sim::Index;
using sim::Vec2;
using sim::Vec3;

/// Axes in which a triangle is laid flat (sim::TriangleAtRest): along its first edge, and across.
struct FlatAxes {
  Vec3 along, across;

  explicit FlatAxes(const std::array<Vec3, 3>& corners) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    along = glm::normalize(corners[1] - corners[0]);
    across = glm::cross(glm::normalize(normal), along);
  }
};

/// Returns, per triangle of the simulation mesh, the nearest triangle of the model.
std::vector<Index> triangles_below(const sim::Mesh& simulated, const sim::Mesh& model) {
  const auto middle_m = [&](const sim::Triangle& t) { return triangle_middle(simulated.positions, t); };
  const auto middles_m = collect<Vec3>(simulated.triangles, middle_m);
  return collect<Index>(bonds_to(middles_m, model, unit_normals(simulated)), &Bond::triangle);
}

/// Returns the triangles in pieces, within which neighbours have the same coordinates at the vertices that they share.
sim::Groups find_texture_pieces(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv) {
  std::vector<std::tuple<Index, float, float, Index>> corners;  ///< vertex, coordinates, triangle
  for (Index corner = 0; corner < corner_uv.size(); ++corner) {
    const Index t = corner / 3;
    corners.emplace_back(mesh.triangles[t][corner % 3], corner_uv[corner].x, corner_uv[corner].y, t);
  }
  std::ranges::sort(corners);
  sim::Groups pieces(mesh.triangles.size());
  for (std::size_t c = 1; c < corners.size(); ++c) {
    const auto& [vertex, u, v, t] = corners[c];
    const auto& [other_vertex, other_u, other_v, other] = corners[c - 1];
    if (std::tuple(vertex, u, v) == std::tuple(other_vertex, other_u, other_v)) pieces.join(t, other);
  }
  return pieces;
}

/// Returns the coordinates of the model at the corners of the simulation mesh. Each triangle has coordinates of one
/// piece, to which the triangle `below` it belongs.
std::vector<glm::vec2> coordinates_below(const sim::Mesh& simulated, const sim::Mesh& model,
                                         std::span<const glm::vec2> corner_uv, std::span<const Index> below) {
  std::vector<glm::vec2> found(3 * simulated.triangles.size());
  sim::Groups pieces = find_texture_pieces(model, corner_uv);
  std::map<Index, std::pair<std::vector<Index>, std::vector<Index>>> by_piece;  ///< triangles: simulated, model's
  for (Index t = 0; t < below.size(); ++t) by_piece[pieces.find(below[t])].first.push_back(t);
  for (Index t = 0; t < model.triangles.size(); ++t) {
    if (const auto piece = by_piece.find(pieces.find(t)); piece != by_piece.end()) piece->second.second.push_back(t);
  }
  sim::Mesh part{model.positions, {}, {}};
  for (const auto& [piece, triangles] : by_piece) {
    const auto& [of_simulated, of_model] = triangles;
    part.triangles = collect<sim::Triangle>(of_model, [&](Index t) { return model.triangles[t]; });
    std::vector<Vec3> corners_m;
    for (const Index t : of_simulated) {
      for (const Index v : simulated.triangles[t]) corners_m.push_back(simulated.positions[v]);
    }
    const std::vector<Bond> bonds = bonds_to(corners_m, part);
    for (std::size_t c = 0; c < bonds.size(); ++c) {
      const std::size_t first = 3 * std::size_t{of_model[bonds[c].triangle]};
      glm::dvec2 uv(0.0);
      for (std::size_t k = 0; k < 3; ++k) uv += bonds[c].weights[k] * glm::dvec2(corner_uv[first + k]);
      found[3 * std::size_t{of_simulated[c / 3]} + c % 3] = uv;
    }
  }
  return found;
}

/// Returns a line for people: the mesh that is simulated instead of the model, and why.
std::string describe(const FittedModel& fitted) {
  const auto carried = static_cast<double>(std::ranges::count(fitted.is_simulated, 0));
  return fmt::format("a fitted mesh of {} is simulated, and the model follows it{}: {}{} (garment.mesh)",
                     count_text(fitted.mesh.triangles.size(), "triangle"),
                     carried > 0.0 ? fmt::format(", {:.0f} % of it carried",
                                                 100.0 * carried / static_cast<double>(fitted.is_simulated.size()))
                                   : "",
                     fitted.why,
                     fitted.dropped_sheets > 0 ? fmt::format("; {} with {:.1f} % of the area only follow what is near",
                                                             count_text(fitted.dropped_sheets, "small part"),
                                                             100.0 * fitted.dropped_area_fraction)
                                               : "");
}

}  // namespace

FittingOutcome fit_model(const GarmentSource& source, double thickness_m, const sim::Mesh& model_m) {
  const bool may_choose = source.mesh == MeshChoice::automatic && source.subdivisions == 0;
  if (source.mesh == MeshChoice::fitted && source.subdivisions > 0) {
    throw std::invalid_argument(
        "garment.subdivisions is of the model itself; garment.triangles says how fine a fitted mesh is");
  }
  if (!may_choose && source.mesh != MeshChoice::fitted) return {};
  const std::size_t crossings = sim::find_crossing_pairs({model_m.positions, model_m.triangles}).size();
  std::string why = may_choose ? why_not_fit_for_simulation(model_m, crossings, thickness_m).value_or("")
                               : "garment.mesh asks for it";
  if (may_choose && why.empty() && !source.given && is_coarse(model_m)) {
    why = fmt::format("it has {} triangles, which are too few for folds", model_m.triangles.size());
  }
  FittingOutcome outcome;
  if (why.empty()) return outcome;
  FittingSettings settings;
  settings.max_triangles = static_cast<std::size_t>(source.max_triangles);
  settings.min_edge_m = min_edge_thicknesses * thickness_m;
  for (const auto& fit : {fit_mesh, simplify_model}) {
    const bool is_first = outcome.refusal.empty();
    // A simplified mesh is worth it if it is smaller.
    if (!is_first && (!may_choose || model_m.triangles.size() <= settings.max_triangles)) break;
    std::string refusal;
    FittedModel fitted;
    try {
      fitted = {fit(model_m, settings), why};
      refusal = fitted.mesh.triangles.empty()
                    ? "all of it is too narrow"
                    : why_not_the_model(compare_with_model(model_m, crossings, fitted)).value_or("");
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    if (is_first) outcome.refusal = refusal;
    if (refusal.empty() || (!may_choose && !fitted.mesh.triangles.empty())) {
      outcome.fitted = std::move(fitted);
      return outcome;
    }
  }
  if (!may_choose) throw std::invalid_argument("no mesh can be fitted to it (garment.mesh): " + outcome.refusal);
  if (model_m.triangles.size() <= max_simulated_triangles && crossings <= max_model_crossings) return outcome;
  throw std::invalid_argument(
      fmt::format("no mesh fitted to it is its cloth: {}; nor can it be simulated itself: {} (garment.mesh)",
                  outcome.refusal, why));
}

std::vector<Vec3> FollowingModel::shown_m(std::span<const Vec3> positions_m,
                                          std::span<const sim::Triangle> simulated) const {
  std::vector<Vec3> model_m = follow(bonds, positions_m, simulated, fitting::normal_smoothing_rounds);
  shape_limits->apply(find_feet(bonds, positions_m, simulated), model_m);
  return model_m;
}

FollowingModel follow_fitted(sim::Mesh model_m, const FittedModel& fitted, double bound) {
  FollowingModel following;
  following.bonds = bonds_of_model(model_m, fitted.is_simulated, fitted.mesh);
  following.shape_limits = std::make_shared<const ShapeLimits>(model_m, following_stretch_ratio * bound,
                                                               find_rigid_parts(model_m, fitted.is_simulated));
  following.description = describe(fitted);
  following.mesh = std::move(model_m);
  return following;
}

std::vector<Vec2> warps_below(const sim::Mesh& simulated, const sim::Mesh& model,
                              std::span<const glm::vec2> corner_uv) {
  const std::vector<Index> below = triangles_below(simulated, model);
  const std::vector<Vec2> of_model = sim::warps_from_coordinates(model, corner_uv);
  std::vector<Vec2> warps;
  for (std::size_t t = 0; t < below.size(); ++t) {
    const FlatAxes from(sim::corner_positions(model.triangles[below[t]], model.positions));
    const FlatAxes to(sim::corner_positions(simulated.triangles[t], simulated.positions));
    const Vec3 warp = of_model[below[t]].x * from.along + of_model[below[t]].y * from.across;
    const Vec2 laid(glm::dot(warp, to.along), glm::dot(warp, to.across));
    warps.push_back(glm::length(laid) > 0.5
                        ? glm::normalize(laid)
                        : sim::upright_direction(sim::corner_positions(simulated.triangles[t], simulated.positions)));
  }
  return warps;
}

std::vector<Vec3> simulated_m(const FollowingModel& following, const sim::Mesh& simulated,
                              std::span<const Vec3> file_m) {
  std::vector<Vec3> model_m = following.mesh.positions;
  const std::vector<Index>& of_file = following.file_vertices.mesh_vertex;
  for (std::size_t v = of_file.size(); v-- > 0;) {
    if (of_file[v] != sim::no_vertex) model_m[of_file[v]] = file_m[v];
  }
  const std::vector<Vec3> normals = vertex_normals(simulated.positions, simulated.triangles);
  return follow(bonds_to(simulated.positions, following.mesh, normals), model_m, following.mesh.triangles);
}

void show_simulated(GarmentInScene& loaded) {
  const sim::Mesh& simulated = loaded.garment->mesh;
  const sim::Mesh& model = loaded.following->mesh;
  SurfaceColours& colours = loaded.colours;
  const std::vector<Index> below = triangles_below(simulated, model);
  if (!colours.corner_uv.empty()) {
    colours.corner_uv = coordinates_below(simulated, model, colours.corner_uv, below);
  }
  if (!colours.material_of_face.empty()) {
    colours.material_of_face = collect<Index>(below, [&](Index t) { return colours.material_of_face[t]; });
  }
  loaded.file_faces = {};
  loaded.following = nullptr;
}

LoadedGarment as_modelled(const LoadedGarment& loaded, const sim::MappingSettings& mapping) {
  LoadedGarment modelled = loaded;
  modelled.garment = sim::share(sim::make_garment(loaded.following->mesh, mapping, loaded.garment->material));
  modelled.file_vertices = loaded.following->file_vertices;
  modelled.following = nullptr;
  modelled.pins.clear();
  modelled.moving_pins.clear();
  modelled.hanger.clear();
  modelled.start_m.reset();
  modelled.untangling.reset();
  modelled.hanging.reset();
  return modelled;
}

const sim::Stretch& FollowingSummary::add(const FollowingModel& following, std::span<const Vec3> shown_m) {
  last = following.shape_limits->measure(shown_m);
  max_stretch = std::max(max_stretch, last->stretch.max);
  max_p99_stretch = std::max(max_p99_stretch, last->stretch.p99);
  max_new_crossings = std::max(max_new_crossings, last->new_crossings);
  return last->stretch;
}

void require_fit_to_show(const sim::Stretch& stretch) {
  if (stretch.p99 <= max_shown_stretch) return;
  throw ModelOverstretched("the model that follows is stretched by {:.1f} % in the 99th percentile, more than {:.0f} %",
                           100.0 * stretch.p99, 100.0 * max_shown_stretch);
}

std::string describe_simulated_shown(const std::string& reason) {
  return reason + ": the simulated mesh is shown instead, in its colours";
}

std::string FollowingSummary::describe() const {
  if (!last) return "";
  return fmt::format(
      "the promises are those of the fitted mesh; the model that follows it is stretched by up to {:.1f} % (99th "
      "percentile {:.1f} %, of its surface at the end {:.1f} %), and {} of its triangles cross at the end, {} of which "
      "do not as modelled (at most {} in a frame)",
      100.0 * max_stretch, 100.0 * max_p99_stretch, 100.0 * last->surface_p99, count_text(last->crossings, "pair"),
      last->new_crossings, max_new_crossings);
}

}  // namespace taut::app
