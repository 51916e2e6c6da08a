#include "app/library/border.hpp"

// Calls that a page needs beside those of taut.h: where the bodies of a scene are, to draw them.
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

/// Fills in how many corners of triangles and how many vertices the mesh of a body has, and the corners, unless NULL.
TAUT_API TautResult taut_page_body(TautCloth cloth, std::size_t body, std::uint32_t* corners, std::size_t* counts) {
  return with(cloth, [&](const Session& session) {
    const sim::BodyMeshData& data = *body_mesh(session, body).data;
    counts[0] = 3 * data.triangles.size();
    counts[1] = data.positions_m.size();
    if (corners != nullptr) std::memcpy(corners, data.triangles.data(), counts[0] * sizeof(std::uint32_t));
  });
}

/// Where the body's vertices are when the last frame ends, in m.
TAUT_API TautResult taut_page_body_positions(TautCloth cloth, std::size_t body, const TautPointsOut* out) {
  return with(cloth, [&](const Session& session) {
    std::vector<sim::Vec3> positions_m(body_mesh(session, body).data->positions_m.size());
    const sim::Simulation& simulation = session.simulation();
    sim::positions_at(simulation.surroundings().bodies[body], simulation.state().time_s, positions_m);
    put_points(positions_m, out);
  });
}
}
