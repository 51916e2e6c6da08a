#include "app/library/border.hpp"
#include "app/library/drawing.hpp"
#include "app/scene/fabric.hpp"

namespace taut::library {
namespace {

TautFrame to_frame(const app::FrameRecord& record) {
  TautFrame frame{};
  frame.frame = record.frame;
  frame.time_s = record.time_s;
  frame.max_edge_stretch = record.stretch.max;
  frame.max_surface_stretch = record.surface_stretch.max;
  frame.smallest_distance_m = record.contact.min_distance_m;
  frame.crossing_pairs = record.crossing_pairs ? static_cast<std::int64_t>(*record.crossing_pairs) : -1;
  frame.state_hash = record.state_hash;
  frame.substeps = record.asleep ? 0 : record.substeps;
  frame.is_bound_kept = record.bound_kept ? 1 : 0;
  frame.is_contact_kept = record.blocked || record.crossing_pairs.value_or(0) > 0 ? 0 : 1;
  frame.is_asleep = record.asleep ? 1 : 0;
  frame.measured_crossings = record.contact.crossing_pairs;
  frame.left_out_share = record.contact.excluded_area_fraction;
  frame.wind_force_n = glm::length(record.wind.force_n);
  frame.wind_power_w = record.wind.power_w;
  return frame;
}

TautInfo to_info(const Session& session) {
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
  info.crossings_at_start = session.crossings_at_start();
  return info;
}

std::string list_names(std::int32_t kind) {
  require(kind == TAUT_SCENES || kind == TAUT_FABRICS, "found an unknown kind of names");
  const auto names = kind == TAUT_FABRICS ? app::built_in_fabrics()
                                          : app::collect<std::string>(app::built_in_scenes(), &app::BuiltInScene::name);
  std::string lines;
  for (const std::string& name : names) lines += name + '\n';
  return lines;
}

std::vector<sim::Vec3> points_for(const Session& session, std::int32_t body, const TautPoints* points) {
  return points_from(points, session.positions_of_body(static_cast<std::size_t>(body)));
}

}  // namespace
}  // namespace taut::library

using namespace taut;
using namespace taut::library;

#define TAUT_INIT(name, Struct)                               \
  TautResult taut_##name##_init(Struct* given, size_t size) { \
    return guard([&] { init_struct(given, size); });          \
  }
TAUT_INIT(error, TautError)
TAUT_INIT(mesh, TautMesh)
TAUT_INIT(options, TautOptions)
TAUT_INIT(body, TautBody)
TAUT_INIT(frame, TautFrame)
TAUT_INIT(info, TautInfo)

const char* taut_version(void) {
  static const std::string version = app::program_version();
  return version.c_str();
}

uint32_t taut_abi_version(void) { return TAUT_ABI_VERSION; }

const char* taut_build_info(void) {
  static const std::string info = [] {
    std::string text = "taut " + app::program_version() + ", " + app::compiler_version() + ", vectors:";
    for (const sim::VectorUnit unit : sim::available_vector_units()) {
      text += unit == sim::VectorUnit::best ? "" : std::string(" ") + sim::to_name(unit);
    }
    return text;
  }();
  return info.c_str();
}

TautResult taut_list(int32_t kind, char* buffer, size_t capacity, size_t* size) {
  return guard([&] {
    const std::string names = list_names(kind);
    put_bytes({names.c_str(), names.size() + 1}, buffer, capacity, size);
  });
}

TautResult taut_create(const TautOptions* options, TautCloth* cloth, TautError* error) {
  char text[sizeof(TautError::text)] = "";
  TautResult result = TAUT_OK;
  const DefaultRounding rounding;
  try {
    require(cloth != nullptr, "found a cloth of NULL");
    *cloth = {};
    const TautOptions read = read_struct(options);
    cloth->id = add_cloth(std::make_shared<CallerCloth>(Session(read, load(read))));
  } catch (...) {
    result = describe_failure(text);
  }
  if (error != nullptr) {
    TautError told{};
    told.result = result;
    put_text(text, told.text);
    guard([&] { put_struct(told, error); });
  }
  return result;
}

TautResult taut_destroy(TautCloth cloth) {
  const DefaultRounding rounding;
  return remove_cloth(cloth.id) ? TAUT_OK : TAUT_ERROR_HANDLE;
}

const char* taut_last_error(TautCloth cloth) {
  // Copies the text for this thread: another thread may destroy the cloth or fail with it at any moment.
  static thread_local char text[sizeof(TautError::text)];
  const std::shared_ptr<CallerCloth> slot = find(cloth.id);
  if (!slot) return "there is no such cloth";
  const std::lock_guard lock(slot->error_mutex);
  put_text(slot->error, text);
  return text;
}

TautResult taut_get_info(TautCloth cloth, TautInfo* info) {
  return with(cloth, [&](const Session& session) { put_struct(to_info(session), info); });
}

TautResult taut_step(TautCloth cloth, TautFrame* frame) {
  return with(cloth, [&](Session& session) {
    if (frame != nullptr) read_struct(frame);
    const TautFrame stepped = to_frame(session.step());
    if (frame != nullptr) put_struct(stepped, frame);
  });
}

TautResult taut_set(TautCloth cloth, const char* key, const char* value) {
  return with(cloth, [&](Session& session) {
    session.set(require_text(key, "found a key of NULL"), require_text(value, "found a value of NULL"));
  });
}

TautResult taut_set_wind(TautCloth cloth, double x, double y, double z) {
  return with(cloth, [&](Session& session) { session.set_wind(to_vector(x, y, z)); });
}

TautResult taut_set_gravity(TautCloth cloth, double x, double y, double z) {
  return with(cloth, [&](Session& session) { session.set_gravity(to_vector(x, y, z)); });
}

TautResult taut_set_forces(TautCloth cloth, const uint32_t* vertices, const TautPoints* forces) {
  return with(cloth, [&](Session& session) {
    const std::vector<sim::Vec3> forces_n = points_from(forces);
    session.set_forces(vertices_from(vertices, forces_n.size(), session.vertex_count()), forces_n);
  });
}

TautResult taut_set_pins(TautCloth cloth, const uint32_t* vertices, size_t count) {
  return with(cloth,
              [&](Session& session) { session.set_pins(vertices_from(vertices, count, session.vertex_count())); });
}

TautResult taut_get_pins(TautCloth cloth, uint32_t* vertices, size_t count) {
  return with(cloth, [&](const Session& session) {
    const std::vector<sim::Index> pins = session.pins();
    require_array_length(vertices, count, pins.size());
    std::ranges::copy(pins, vertices);
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
    const std::size_t added = session.add_body(body);
    if (number != nullptr) *number = static_cast<int32_t>(added);
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
  return with(cloth, [&](Session& session) { session.set_positions(points_from(positions, session.vertex_count())); });
}

TautResult taut_get_stretch(TautCloth cloth, double* stretch, size_t count) {
  return with(cloth, [&](const Session& session) {
    require_array_length(stretch, count, session.vertex_count());
    const std::vector<double> found = session.stretch();
    std::ranges::copy(found, stretch);
  });
}

TautResult taut_get_triangles(TautCloth cloth, uint32_t* vertices, size_t count) {
  return with(cloth, [&](const Session& session) {
    const std::vector<sim::Triangle>& triangles = session.simulation().garment().mesh.triangles;
    require_array_length(vertices, count, 3 * triangles.size());
    for (const sim::Triangle& triangle : triangles) {
      for (const sim::Index vertex : triangle) *vertices++ = session.vertex_of(vertex);
    }
  });
}

TautResult taut_get_edges(TautCloth cloth, uint32_t* vertices, double* rest_lengths, size_t count) {
  return with(cloth, [&](const Session& session) {
    const sim::Garment& garment = session.simulation().garment();
    const auto& edges = garment.adjacency.edges;
    require_array_length(&edges, count, edges.size());
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

TautResult taut_draw(TautCloth cloth, int32_t width_px, int32_t height_px, uint8_t* rgb, size_t size) {
  return with(cloth, [&](const Session& session) {
    for (const int32_t side_px : {width_px, height_px}) {
      if (side_px < 16 || side_px > 16384) throw ArgumentError("found {} pixels, expected 16 to 16384", side_px);
    }
    require(session.scene().picture.background.kind != app::BackgroundKind::transparent,
            "picture.background: found none, expected a background");
    require_array_length(rgb, size, std::size_t{3} * width_px * height_px);
    std::ranges::copy(draw(session, width_px, height_px).pixels, rgb);
  });
}

TautResult taut_state_hash(TautCloth cloth, uint64_t* hash) {
  return with(cloth, [&](const Session& session) {
    require(hash != nullptr, "found a hash of NULL");
    *hash = sim::hash(session.simulation().state());
  });
}

TautResult taut_save(TautCloth cloth, void* buffer, size_t capacity, size_t* size) {
  return with(cloth,
              [&](const Session& session) { put_bytes(session.save(), static_cast<char*>(buffer), capacity, size); });
}

TautResult taut_restore(TautCloth cloth, const void* buffer, size_t size) {
  return with(cloth, [&](Session& session) {
    require(buffer != nullptr, "found a buffer of NULL");
    const std::string_view bytes(static_cast<const char*>(buffer), size);
    session.restore("buffer", app::parse_run_checkpoint(bytes, "buffer"));
  });
}

TautResult taut_save_file(TautCloth cloth, const char* path) {
  return with(cloth, [&](const Session& session) {
    const std::filesystem::path file = require_text(path, "found a path of NULL");
    std::error_code error;
    // Writing to a pipe without a reader would end the caller's program by a signal.
    if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) {
      throw app::InputError("cannot write '{}': found what is no file, expected a file or a free name", file.string());
    }
    app::write_text_file(file, session.save());
  });
}

TautResult taut_restore_file(TautCloth cloth, const char* path) {
  return with(cloth, [&](Session& session) {
    const std::string file = require_text(path, "found a path of NULL");
    session.restore(file, app::read_run_checkpoint(file));
  });
}
