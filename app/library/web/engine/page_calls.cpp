#include "app/library/border.hpp"
#include "app/runs/shirt_choice.hpp"

// Calls that a page needs in addition to taut.h.
namespace taut::library {
namespace {

const sim::BodyMesh& body_mesh(const Session& session, std::size_t body) {
  const std::vector<sim::Body>& bodies = session.simulation().surroundings().bodies;
  require(body < bodies.size(), "found the number of a body that does not exist");
  const auto* mesh = std::get_if<sim::BodyMesh>(&bodies[body].shape);
  require(mesh != nullptr, "found a body that is no mesh");
  return *mesh;
}

}  // namespace
}  // namespace taut::library

using namespace taut;
using namespace taut::library;

extern "C" {

/// Gets the number of triangle corners and of vertices of a body's mesh, and its corners unless `corners` is NULL.
TAUT_API TautResult taut_page_body(TautCloth cloth, std::size_t body, std::uint32_t* corners, std::size_t* counts) {
  return with(cloth, [&](const Session& session) {
    const sim::BodyMeshData& data = *body_mesh(session, body).data;
    counts[0] = 3 * data.triangles.size();
    counts[1] = data.positions_m.size();
    if (corners != nullptr) std::memcpy(corners, data.triangles.data(), counts[0] * sizeof(std::uint32_t));
  });
}

/// Gets the positions of the body's vertices at the end of the last frame, in metres.
TAUT_API TautResult taut_page_body_positions(TautCloth cloth, std::size_t body, const TautPointsOut* out) {
  return with(cloth, [&](const Session& session) {
    std::vector<sim::Vec3> positions_m(body_mesh(session, body).data->positions_m.size());
    const sim::Simulation& simulation = session.simulation();
    sim::positions_at(simulation.surroundings().bodies[body], simulation.state().time_s, positions_m);
    put_points(positions_m, out);
  });
}

/// Gets the number of triangles of the largest T-shirt in real time, of which this cloth is one. Advances it.
TAUT_API TautResult taut_page_shirt(TautCloth cloth, std::int32_t* triangles) {
  return with(cloth, [&](Session& session) {
    *triangles = app::find_shirt_in_real_time(session.simulation(), [&] { session.step(); });
  });
}
}
