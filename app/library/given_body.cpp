#include "app/library/given_body.hpp"

#include "app/bodies/body_loading.hpp"
#include "app/library/border.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/models/scene_crossings.hpp"

namespace taut::library {
namespace {

sim::Plane plane_of(const TautBody& given) {
  const sim::Vec3 normal = vector_of(given.plane_normal[0], given.plane_normal[1], given.plane_normal[2]);
  const double length = glm::length(normal);
  require(length > 0.0 && std::isfinite(length), "plane_normal: expected a vector that is not 0");
  return {vector_of(given.plane_point[0], given.plane_point[1], given.plane_point[2]), normal / length};
}

void take_mesh(const TautBody& given, const app::Scene& scene, GivenBody& taken) {
  app::BodySource source;
  source.file = taken.body.name.empty() ? "body" : taken.body.name;
  source.dress = taken.source.dress = given.dress;
  const double rate_hz = scene.simulation.frame_rate_hz;
  app::ReadBody read = app::body_of(source, model_from(given.mesh), {scene.frames / rate_hz, rate_hz});
  taken.body.shape = std::move(read.mesh);
  taken.wearer = std::move(read.wearer);
  taken.lent = LentBody{std::move(read.places), read.file_vertices};
  for (const std::string& remark : read.remarks) {
    taken.remarks.push_back("body '" + source.file.string() + "': " + remark);
  }
}

}  // namespace

GivenBody take_body(const TautBody* body, const app::Scene& scene) {
  const TautBody given = read_struct(body);
  GivenBody taken;
  taken.body.name = given.name != nullptr ? given.name : "";
  if (given.has_friction != 0) {
    require(given.friction >= 0.0 && given.friction <= 10.0, "friction: expected 0 to 10");
    taken.body.friction = given.friction;
  }
  require(given.dress >= 0 && given.dress <= 10000, "dress: expected 0 to 10000 frames");
  if (given.mesh != nullptr) {
    take_mesh(given, scene, taken);
  } else {
    require(given.dress == 0, "dress: expected 0 for a plane");
    taken.body.shape = plane_of(given);
  }
  return taken;
}

std::size_t put_in(const GivenBody& given, app::Scene& scene) {
  std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  const std::size_t number = bodies.size();
  bodies.push_back(given.body);
  scene.body_sources.resize(number);
  scene.body_sources.push_back(given.source);
  scene.wearers.resize(number);
  scene.wearers.push_back(given.wearer);
  return number;
}

std::size_t Session::add_body(const TautBody* body) {
  GivenBody given = take_body(body, scene_);
  require(given.source.dress == 0, "dress: expected 0 of a body that is added later");
  app::Scene next = scene_;
  const std::size_t number = put_in(given, next);
  change(std::move(next));
  if (given.lent) lent_[number] = std::move(*given.lent);
  const sim::State& state = simulation_.state();
  const app::StartRemarks remarks =
      app::remarks_on_body(scene_.surroundings.bodies, number, state.time_s,
                           {state.current, simulation_.garment().mesh.triangles}, simulation_.pins().vertices);
  crossings_at_start_ += remarks.crossings;
  begin_again();
  listener_.tell(given.remarks);
  listener_.tell(remarks.lines);
  return number;
}

const LentBody& Session::lent_body(std::size_t body) const {
  const auto found = lent_.find(body);
  if (found == lent_.end()) throw ArgumentError("found body {}, expected one that was added as a mesh", body);
  return found->second;
}

std::size_t Session::positions_of_body(std::size_t body) const { return lent_body(body).vertices; }

std::vector<sim::Vec3> Session::in_body(const LentBody& lent, const std::vector<sim::Vec3>& positions_m) const {
  std::vector<sim::Vec3> in_body_m;
  for (const std::size_t vertex : lent.places.file_vertex) {
    in_body_m.push_back(lent.places.placement(positions_m[vertex]));
  }
  const std::size_t lost = sim::first_lost(in_body_m);
  if (lost < in_body_m.size()) {
    throw ArgumentError("found vertex {} beyond all bounds", lent.places.file_vertex[lost]);
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
      throw ArgumentError("found vertex {} {:.3g} m from where it is, expected at most {:g} m in a frame",
                          lent.places.file_vertex[v], way_m, app::furthest_in_frame_m);
    }
  }
  // To stand still is no change: it would wake cloth at rest.
  lent_[body].target_m = target_m == now_m ? std::nullopt : std::optional(std::move(target_m));
}

void Session::place_body(std::size_t body, const std::vector<sim::Vec3>& positions_m) {
  set_shape(body, in_body(lent_body(body), positions_m));
  lent_[body].target_m.reset();
  simulation_.set_surroundings(surroundings_of(scene_));
  begin_again();
}

}  // namespace taut::library
