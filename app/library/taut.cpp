#include "app/library/taut.h"

#include <cfenv>
#include <limits>
#include <string>

#include "app/base/files.hpp"
#include "app/base/version.hpp"
#include "app/library/failure.hpp"
#include "app/library/handles.hpp"
#include "app/library/structs.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::library {
namespace {

/// Rounding as the bits of a run need it, whatever the caller's program has chosen for itself.
class UsualRounding {
 public:
  UsualRounding() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~UsualRounding() { std::fesetenv(&callers_); }
  UsualRounding(const UsualRounding&) = delete;
  UsualRounding& operator=(const UsualRounding&) = delete;

 private:
  std::fenv_t callers_{};
};

/// Keeps a cloth to itself for a call.
class Turn {
 public:
  explicit Turn(Held& held) noexcept : held_(held), is_mine_(!held.is_busy.exchange(true)) {}
  ~Turn() {
    if (is_mine_) {
      held_.is_busy = false;
    }
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  bool is_mine() const { return is_mine_; }

 private:
  Held& held_;
  bool is_mine_;
};

/// The border: does it with the cloth, and makes a result of whatever is thrown.
template <class Work>
TautResult with(TautCloth cloth, const Work& work) noexcept {
  const std::shared_ptr<Held> held = find(cloth.id);
  if (!held) {
    return TAUT_ERROR_HANDLE;
  }
  const Turn turn(*held);
  if (!turn.is_mine()) {
    return TAUT_ERROR_BUSY;
  }
  const UsualRounding rounding;
  try {
    work(held->session);
    return TAUT_OK;
  } catch (...) {
    return describe_failure(held->error);
  }
}

/// The same for calls without a cloth.
template <class Work>
TautResult guarded(const Work& work) noexcept {
  char text[sizeof(TautError::text)];
  try {
    work();
    return TAUT_OK;
  } catch (...) {
    return describe_failure(text);
  }
}

TautFrame frame_of(const app::FrameRecord& record) {
  TautFrame frame{};
  frame.frame = record.frame;
  frame.time_s = record.time_s;
  frame.max_edge_stretch = record.stretch.max;
  frame.max_surface_stretch = record.surface_stretch.max;
  frame.smallest_distance_m = record.contact.smallest_distance_m;
  frame.crossing_pairs = record.crossing_pairs ? static_cast<std::int64_t>(*record.crossing_pairs) : -1;
  frame.state_hash = record.state_hash;
  frame.substeps = record.asleep ? 0 : record.substeps;
  frame.is_bound_kept = record.bound_kept ? 1 : 0;
  frame.is_contact_kept = record.blocked || record.crossing_pairs.value_or(0) > 0 ? 0 : 1;
  frame.is_asleep = record.asleep ? 1 : 0;
  return frame;
}

TautInfo info_of(const Session& session) {
  const sim::Simulation& simulation = session.simulation();
  const auto* bounded = std::get_if<sim::BoundedSettings>(&simulation.settings().solver.method);
  TautInfo info{};
  info.frame = session.frame();
  info.time_s = simulation.state().time_s;
  info.frame_rate_hz = simulation.settings().frame_rate_hz;
  info.max_stretch = bounded != nullptr ? bounded->max_stretch : std::numeric_limits<double>::infinity();
  info.vertex_count = session.vertex_count();
  info.triangle_count = simulation.garment().mesh.triangles.size();
  info.edge_count = simulation.garment().adjacency.edges.size();
  info.pin_count = simulation.pins().vertices.size();
  info.body_count = simulation.surroundings().bodies.size();
  return info;
}

sim::Body body_of(const TautBody& given) {
  sim::Body body;
  body.name = given.name != nullptr ? given.name : "";
  if (given.has_friction != 0) {
    require(given.friction >= 0.0 && given.friction <= 10.0, "friction: expected 0 to 10");
    body.friction = given.friction;
  }
  return body;
}

sim::Plane plane_of(const TautBody& given) {
  const sim::Vec3 normal = vector_of(given.plane_normal[0], given.plane_normal[1], given.plane_normal[2]);
  const double length = glm::length(normal);
  require(length > 0.0 && std::isfinite(length), "plane_normal: expected a vector that is not 0");
  return {vector_of(given.plane_point[0], given.plane_point[1], given.plane_point[2]), normal / length};
}

void require_room(const void* array, std::size_t found, std::size_t expected) {
  require(array != nullptr || expected == 0, "found an array of NULL");
  if (found != expected) {
    throw ArgumentError("found an array of " + std::to_string(found) + ", expected " +
                        std::to_string(expected));
  }
}

std::string text_of(const char* text, const char* message) {
  require(text != nullptr, message);
  return text;
}

std::vector<sim::Vec3> points_for(const Session& session, std::int32_t body, const TautPoints* points) {
  return points_from(points, session.positions_of_body(static_cast<std::size_t>(body)));
}

}  // namespace
}  // namespace taut::library

using namespace taut;
using namespace taut::library;

TautResult taut_error_init(TautError* error, size_t size) {
  return guarded([&] { init_struct(error, size); });
}
TautResult taut_mesh_init(TautMesh* mesh, size_t size) {
  return guarded([&] { init_struct(mesh, size); });
}
TautResult taut_options_init(TautOptions* options, size_t size) {
  return guarded([&] { init_struct(options, size); });
}
TautResult taut_body_init(TautBody* body, size_t size) {
  return guarded([&] { init_struct(body, size); });
}
TautResult taut_frame_init(TautFrame* frame, size_t size) {
  return guarded([&] { init_struct(frame, size); });
}
TautResult taut_info_init(TautInfo* info, size_t size) {
  return guarded([&] { init_struct(info, size); });
}

const char* taut_version(void) {
  static const std::string version = app::program_version();
  return version.c_str();
}

uint32_t taut_abi_version(void) {
  return TAUT_ABI_VERSION;
}

const char* taut_build_info(void) {
  static const std::string info = [] {
    std::string text = "taut " + app::program_version() + ", " + app::compiler_version() + ", vectors:";
    for (const sim::VectorUnit unit : sim::available_vector_units()) {
      text += unit == sim::VectorUnit::best ? "" : std::string(" ") + sim::name_of(unit);
    }
    return text;
  }();
  return info.c_str();
}

TautResult taut_create(const TautOptions* options, TautCloth* cloth, TautError* error) {
  char text[sizeof(TautError::text)] = "";
  TautResult result = TAUT_OK;
  const UsualRounding rounding;
  try {
    require(cloth != nullptr, "found a cloth of NULL");
    *cloth = {};
    const TautOptions read = read_struct(options);
    cloth->id = keep(std::make_shared<Held>(Session(read, load(read))));
  } catch (...) {
    result = describe_failure(text);
  }
  if (error != nullptr) {
    TautError told{};
    told.result = result;
    put_text(text, told.text);
    guarded([&] { put_struct(told, error); });
  }
  return result;
}

TautResult taut_destroy(TautCloth cloth) {
  const UsualRounding rounding;
  return release(cloth.id) ? TAUT_OK : TAUT_ERROR_HANDLE;
}

const char* taut_last_error(TautCloth cloth) {
  const std::shared_ptr<Held> held = find(cloth.id);
  return held ? held->error : "there is no such cloth";
}

TautResult taut_get_info(TautCloth cloth, TautInfo* info) {
  return with(cloth, [&](const Session& session) { put_struct(info_of(session), info); });
}

TautResult taut_step(TautCloth cloth, TautFrame* frame) {
  return with(cloth, [&](Session& session) {
    if (frame != nullptr) {
      read_struct(frame);
    }
    const TautFrame stepped = frame_of(session.step());
    if (frame != nullptr) {
      put_struct(stepped, frame);
    }
  });
}

TautResult taut_set(TautCloth cloth, const char* key, const char* value) {
  return with(cloth, [&](Session& session) {
    session.set(text_of(key, "found a key of NULL"), text_of(value, "found a value of NULL"));
  });
}

TautResult taut_set_wind(TautCloth cloth, double x, double y, double z) {
  return with(cloth, [&](Session& session) { session.set_wind(vector_of(x, y, z)); });
}

TautResult taut_set_gravity(TautCloth cloth, double x, double y, double z) {
  return with(cloth, [&](Session& session) { session.set_gravity(vector_of(x, y, z)); });
}

TautResult taut_set_forces(TautCloth cloth, const uint32_t* vertices, const TautPoints* forces) {
  return with(cloth, [&](Session& session) {
    const std::vector<sim::Vec3> forces_n = points_from(forces);
    session.set_forces(vertices_from(vertices, forces_n.size(), session.vertex_count()), forces_n);
  });
}

TautResult taut_set_pins(TautCloth cloth, const uint32_t* vertices, size_t count) {
  return with(cloth, [&](Session& session) {
    session.set_pins(vertices_from(vertices, count, session.vertex_count()));
  });
}

TautResult taut_get_pins(TautCloth cloth, uint32_t* vertices, size_t count) {
  return with(cloth, [&](const Session& session) {
    const std::vector<sim::Index> pins = session.pins();
    require_room(vertices, count, pins.size());
    std::copy(pins.begin(), pins.end(), vertices);
  });
}

TautResult taut_move_pins(TautCloth cloth, const uint32_t* vertices, const TautPoints* targets) {
  return with(cloth, [&](Session& session) {
    const std::vector<sim::Vec3> targets_m = points_from(targets);
    session.move_pins(vertices_from(vertices, targets_m.size(), session.vertex_count()), targets_m);
  });
}

TautResult taut_add_body(TautCloth cloth, const TautBody* body, int32_t* number) {
  return with(cloth, [&](Session& session) {
    const TautBody given = read_struct(body);
    sim::Body made = body_of(given);
    if (given.mesh == nullptr) {
      made.shape = plane_of(given);
    }
    const std::size_t added = given.mesh == nullptr
                                  ? session.add_body(std::move(made))
                                  : session.add_body(std::move(made), mesh_from(given.mesh));
    if (number != nullptr) {
      *number = static_cast<int32_t>(added);
    }
  });
}

TautResult taut_move_body(TautCloth cloth, int32_t number, const TautPoints* positions) {
  return with(cloth, [&](Session& session) {
    session.move_body(static_cast<std::size_t>(number), points_for(session, number, positions));
  });
}

TautResult taut_place_body(TautCloth cloth, int32_t number, const TautPoints* positions) {
  return with(cloth, [&](Session& session) {
    session.place_body(static_cast<std::size_t>(number), points_for(session, number, positions));
  });
}

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
    require(size != nullptr, "found a size of NULL");
    const std::string bytes = session.save();
    *size = bytes.size();
    if (buffer != nullptr) {
      require(capacity >= bytes.size(), "found a buffer that is smaller than the state");
      std::copy(bytes.begin(), bytes.end(), static_cast<char*>(buffer));
    }
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
