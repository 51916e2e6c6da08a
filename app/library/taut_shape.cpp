#include <algorithm>
#include <glm/geometric.hpp>

#include "app/base/files.hpp"
#include "app/library/arrays.hpp"
#include "app/library/border.hpp"

using namespace taut;
using namespace taut::library;

TautResult taut_get_positions(TautCloth cloth, const TautPointsOut* positions) {
  return with(cloth, [&](const Session& session) { put_points(session.positions_m(), positions); });
}

TautResult taut_set_positions(TautCloth cloth, const TautPoints* positions) {
  return with(cloth, [&](Session& session) {
    session.set_positions(points_from(positions, session.vertex_count()));
  });
}

TautResult taut_get_stretch(TautCloth cloth, double* stretch, size_t count) {
  return with(cloth, [&](const Session& session) {
    require_room(stretch, count, session.vertex_count());
    const std::vector<double> found = session.stretch();
    std::copy(found.begin(), found.end(), stretch);
  });
}

TautResult taut_get_triangles(TautCloth cloth, uint32_t* vertices, size_t count) {
  return with(cloth, [&](const Session& session) {
    const std::vector<sim::Triangle>& triangles = session.simulation().garment().mesh.triangles;
    require_room(vertices, count, 3 * triangles.size());
    for (const sim::Triangle& triangle : triangles) {
      vertices = std::transform(triangle.begin(), triangle.end(), vertices,
                                [&](sim::Index vertex) { return session.vertex_of(vertex); });
    }
  });
}

TautResult taut_get_edges(TautCloth cloth, uint32_t* vertices, double* rest_lengths, size_t count) {
  return with(cloth, [&](const Session& session) {
    const sim::Garment& garment = session.simulation().garment();
    const auto& edges = garment.adjacency.edges;
    require_room(&edges, count, edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges[e];
      if (vertices != nullptr) {
        vertices[2 * e] = session.vertex_of(a);
        vertices[2 * e + 1] = session.vertex_of(b);
      }
      if (rest_lengths != nullptr) {
        rest_lengths[e] = glm::distance(garment.mesh.positions[a], garment.mesh.positions[b]);
      }
    }
  });
}

TautResult taut_state_hash(TautCloth cloth, uint64_t* hash) {
  return with(cloth, [&](const Session& session) {
    require(hash != nullptr, "found a hash of NULL");
    *hash = sim::hash(session.simulation().state());
  });
}

TautResult taut_save(TautCloth cloth, void* buffer, size_t capacity, size_t* size) {
  return with(cloth, [&](const Session& session) {
    put_bytes(session.save(), static_cast<char*>(buffer), capacity, size);
  });
}

TautResult taut_restore(TautCloth cloth, const void* buffer, size_t size) {
  return with(cloth, [&](Session& session) {
    require(buffer != nullptr, "found a buffer of NULL");
    const std::string_view bytes(static_cast<const char*>(buffer), size);
    session.restore("buffer", app::run_checkpoint_of(bytes, "buffer"));
  });
}

TautResult taut_save_file(TautCloth cloth, const char* path) {
  return with(cloth, [&](const Session& session) {
    app::write_text_file(text_of(path, "found a path of NULL"), session.save());
  });
}

TautResult taut_restore_file(TautCloth cloth, const char* path) {
  return with(cloth, [&](Session& session) {
    const std::string file = text_of(path, "found a path of NULL");
    session.restore(file, app::read_run_checkpoint(file));
  });
}
