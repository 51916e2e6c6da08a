#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

constexpr std::string_view magic = "TAUTSAVE";
/// Raised with every change of the format or of a solver's memory.
constexpr std::uint32_t version = 7;

constexpr double max_finite = std::numeric_limits<double>::max();
/// Largest time: about thirty years. The number of gust periods still fits.
constexpr double max_interval_s = 1e9;

std::uint64_t hash_of_rest(const Garment& garment) {
  ByteWriter rest;
  rest.put_positions(garment.mesh.positions);
  for (const Triangle& triangle : garment.mesh.triangles) rest.put(triangle);
  for (std::size_t s = 0; s < garment.springs.ends.size(); ++s) {
    rest.put(garment.springs.ends[s]);
    rest.put(garment.springs.rest_lengths_m[s]);
  }
  for (const double mass_kg : garment.masses_kg) rest.put(mass_kg);
  return fnv1a(fnv1a_of_nothing, rest.bytes());
}

struct Identity {
  const char* what;
  std::uint64_t value;
};

std::array<Identity, 4> garment_identity(const Garment& garment) {
  return {{{"the garment's number of vertices", garment.mesh.positions.size()},
           {"the garment's number of triangles", garment.mesh.triangles.size()},
           {"the garment's number of springs", garment.springs.ends.size()},
           {"the hash of the garment at rest", hash_of_rest(garment)}}};
}

void put_state(const State& state, ByteWriter& out) {
  out.put(state.time_s);
  out.put(state.time_step_s);
  out.put(state.step_count);
  out.put(state.quiet_frames);
  out.put<std::uint8_t>(state.asleep ? 1 : 0);
  out.put_positions(state.previous);
  out.put_positions(state.current);
}

/// Reads positions and requires that none is lost.
std::vector<Vec3> get_shape(const char* what, std::size_t count, ByteReader& in) {
  std::vector<Vec3> positions_m = in.get_positions(what, count);
  if (const std::size_t lost = first_lost(positions_m); lost < count) {
    throw BadBytes(std::string(what) + ": found vertex " + std::to_string(lost) + " further away than " +
                   std::to_string(max_coordinate_m) + " m, expected nearer ones");
  }
  return positions_m;
}

State get_state(std::size_t vertex_count, ByteReader& in) {
  State state;
  state.time_s = in.get("the time", 0.0, max_interval_s);
  state.time_step_s = in.get("the time step", 0.0, max_interval_s);
  state.step_count = in.get<std::uint64_t>("the number of steps");
  state.quiet_frames = in.get("the number of quiet frames", 0, max_counter);
  state.asleep = in.get_bool("whether the cloth sleeps");
  state.previous = get_shape("the previous positions", vertex_count, in);
  state.current = get_shape("the current positions", vertex_count, in);
  return state;
}

void put_report(const FrameReport& report, ByteWriter& out) {
  out.put(report.substeps);
  out.put<std::uint8_t>(report.bound_promised ? 1 : 0);
  out.put<std::uint8_t>(report.bound_kept ? 1 : 0);
  out.put(report.raw_max_stretch);
  out.put(report.sweeps);
  out.put(report.followed_compression_n_per_m);
  out.put(report.contact.detections);
  out.put(report.contact.partial_detections);
  out.put(report.contact.max_pairs);
  out.put(report.contact.min_distance_m);
  out.put<std::uint64_t>(report.contact.crossing_pairs);
  out.put(report.contact.excluded_area_fraction);
}

ContactReport get_contact(ByteReader& in) {
  ContactReport contact;
  contact.detections = in.get("the number of detections", 0, max_counter);
  contact.partial_detections = in.get("the number of partial detections", 0, max_counter);
  contact.max_pairs = in.get("the number of near pairs", 0, max_counter);
  contact.min_distance_m = in.get("the smallest distance", -max_finite, std::numeric_limits<double>::infinity());
  contact.crossing_pairs = in.get<std::uint64_t>("the number of crossing pairs");
  contact.excluded_area_fraction = in.get("the part of the area that is left out", 0.0, 1.0);
  return contact;
}

FrameReport get_report(ByteReader& in) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  FrameReport report;
  report.substeps = in.get("the number of substeps", 0, max_counter);
  report.bound_promised = in.get_bool("whether a bound was promised");
  report.bound_kept = in.get_bool("whether the bound was kept");
  report.raw_max_stretch = in.get("the stretch before the last correction", -1.0, max_finite);
  report.sweeps = in.get("the number of sweeps", 0.0, max_finite);
  report.followed_compression_n_per_m = in.get("the stiffness that was followed", 0.0, infinity);
  report.contact = get_contact(in);
  return report;
}

}  // namespace

bool is_rest_judged(const State& state) { return state.quiet_frames > 0 && !state.asleep; }

std::string encode(const Checkpoint& checkpoint, const Garment& garment) {
  ByteWriter out;
  for (const char c : magic) out.put(c);
  out.put(version);
  for (const Identity& part : garment_identity(garment)) out.put(part.value);
  put_state(checkpoint.state, out);
  out.put_positions(checkpoint.before_m);
  out.put_positions(checkpoint.quiet_since_m);
  put_report(checkpoint.report, out);
  out.put_text(checkpoint.solver);
  out.put_text(checkpoint.solver_memory);
  out.seal();
  return out.bytes();
}

Checkpoint decode(std::string_view bytes, const Garment& garment) {
  ByteReader in(bytes);
  in.require_text("what the bytes are", magic);
  in.get("the version", version, version);
  for (const Identity& part : garment_identity(garment)) in.get(part.what, part.value, part.value);
  const std::size_t count = garment.mesh.positions.size();
  Checkpoint checkpoint;
  checkpoint.state = get_state(count, in);
  checkpoint.before_m = get_shape("the positions one frame ago", count, in);
  checkpoint.quiet_since_m = get_shape("the positions of rest", is_rest_judged(checkpoint.state) ? count : 0, in);
  checkpoint.report = get_report(in);
  checkpoint.solver = in.get_text("the solver");
  checkpoint.solver_memory = in.get_text("the solver's memory");
  in.require_seal();
  return checkpoint;
}

}  // namespace taut::sim
