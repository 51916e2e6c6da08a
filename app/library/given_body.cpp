#include "app/library/given_body.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/bodies/body_loading.hpp"
#include "app/library/arrays.hpp"
#include "app/library/structs.hpp"

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

}  // namespace taut::library
