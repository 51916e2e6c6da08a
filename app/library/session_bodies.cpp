#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <utility>

#include "app/library/arrays.hpp"
#include "app/library/session.hpp"
#include "app/library/way_of_body.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/models/scene_crossings.hpp"

namespace taut::library {

std::size_t Session::add_body(const TautBody* body) {
  GivenBody given = take_body(body, scene_);
  require(given.source.dress == 0, "dress: expected 0 of a body that is added later");
  app::Scene next = scene_;
  const std::size_t number = put_in(given, next);
  change(std::move(next));
  if (given.lent) {
    lent_[number] = std::move(*given.lent);
  }
  const sim::State& state = simulation_.state();
  const app::StartRemarks remarks = app::remarks_on_body(
      scene_.surroundings.bodies, number, state.time_s, {state.current, simulation_.garment().mesh.triangles},
      simulation_.pins().vertices);
  crossings_at_start_ += remarks.crossings;
  begin_again();
  listener_.tell(given.remarks);
  listener_.tell(remarks.lines);
  return number;
}

const LentBody& Session::lent_body(std::size_t body) const {
  const auto found = lent_.find(body);
  if (found == lent_.end()) {
    throw ArgumentError(fmt::format("found body {}, expected one that was added as a mesh", body));
  }
  return found->second;
}

std::size_t Session::positions_of_body(std::size_t body) const {
  return lent_body(body).vertices;
}

std::vector<sim::Vec3> Session::in_body(const LentBody& lent,
                                        const std::vector<sim::Vec3>& positions_m) const {
  std::vector<sim::Vec3> in_body_m;
  for (const std::size_t vertex : lent.places.file_vertex) {
    in_body_m.push_back(lent.places.placement(positions_m[vertex]));
  }
  const std::size_t lost = sim::first_lost(in_body_m);
  if (lost < in_body_m.size()) {
    throw ArgumentError(fmt::format("found vertex {} beyond all bounds", lent.places.file_vertex[lost]));
  }
  return in_body_m;
}

std::vector<sim::Vec3> Session::shape_m(std::size_t body) const {
  return app::mesh_positions_m(scene_.surroundings.bodies[body], simulation_.state().time_s);
}

// Its data stay those that were given, as those of a file do: the last bits hang on them.
void Session::set_shape(std::size_t body, std::vector<sim::Vec3> positions_m) {
  std::get<sim::BodyMesh>(scene_.surroundings.bodies[body].shape).frames =
      std::make_shared<const StillBody>(std::move(positions_m));
}

void Session::move_body(std::size_t body, const std::vector<sim::Vec3>& positions_m) {
  const LentBody& lent = lent_body(body);
  std::vector<sim::Vec3> target_m = in_body(lent, positions_m);
  const std::vector<sim::Vec3> now_m = shape_m(body);
  for (std::size_t v = 0; v < target_m.size(); ++v) {
    const double way_m = glm::distance(target_m[v], now_m[v]);
    if (!(way_m <= app::furthest_in_frame_m)) {
      throw ArgumentError(
          fmt::format("found vertex {} {:.3g} m from where it is, expected at most {:g} m in a frame",
                      lent.places.file_vertex[v], way_m, app::furthest_in_frame_m));
    }
  }
  lent_[body].target_m = std::move(target_m);
}

void Session::place_body(std::size_t body, const std::vector<sim::Vec3>& positions_m) {
  set_shape(body, in_body(lent_body(body), positions_m));
  lent_[body].target_m.reset();
  simulation_.set_surroundings(surroundings_of(scene_));
  begin_again();
}

}  // namespace taut::library
