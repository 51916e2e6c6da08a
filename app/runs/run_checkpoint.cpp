#include "app/runs/run_checkpoint.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/garments/dressing/fit.hpp"

namespace taut::app {

namespace {

constexpr std::string_view magic = "TAUTRUN\n";
constexpr std::uint32_t version = 5;

int get_number(sim::ByteReader& in, int) { return in.get("a number of frames in the summary", -1, sim::max_counter); }
double get_number(sim::ByteReader& in, double) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return in.get("a number of the summary", -infinity, infinity);
}

// A line of a scene file. The key includes its section: "wind.speed = 4.0".
struct RecordLine {
  std::string key;
  std::string value;
};

RecordLine next_line(std::istream& text, std::string& section) {
  for (std::string line; std::getline(text, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("[")) {
      section = line.substr(1, line.size() - 2) + '.';
    } else if (equals != std::string::npos && section + line.substr(0, equals) != "garment.file") {
      return {section + line.substr(0, equals), line.substr(equals + 3)};
    }
  }
  return {};
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw InputError("cannot go on from '" + file.string() + "': " + reason);
}

/// Number of consecutive frames over the bound during dressing after which the garment is too tight.
constexpr int max_tight_frames = 8;

/// Requires that the dressed bodies cross no cloth, unless the scene allows it.
void require_worn(const Scene& scene, const sim::Simulation& simulation) {
  const SolverChoice& solver = scene.simulation.solver;
  const bool is_kept_apart = solver.kind == sim::SolverKind::bounded && !solver.bounded.allow_crossing;
  if (scene.dressing_frames() == 0 || !is_kept_apart) return;
  const std::vector<sim::Body>& bodies = simulation.surroundings().bodies;
  const sim::Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
  for (const SceneCrossings& crossings : scene_crossings(cloth, bodies, 0.0)) {
    if (crossings.body && !crossings.pairs.empty()) {
      throw PromiseBroken("when it is dressed, " + describe(crossings, cloth, bodies));
    }
  }
}

}  // namespace

std::string to_bytes(const RunCheckpoint& checkpoint) {
  sim::ByteWriter out;
  for (const char c : magic) out.put(c);
  out.put(version);
  out.put_text(checkpoint.scene_name);
  out.put_text(checkpoint.scene);
  out.put(checkpoint.frame);
  for_each_field(checkpoint.summary, [&](const char*, const auto& number) { out.put(number); });
  out.put_text(checkpoint.simulation);
  out.seal();
  return out.bytes();
}

void write_run_checkpoint(const std::filesystem::path& file, const RunCheckpoint& checkpoint) {
  write_text_file(file, to_bytes(checkpoint));
}

RunCheckpoint read_run_checkpoint(const std::filesystem::path& file) {
  return parse_run_checkpoint(read_text_file(file, max_run_bytes), file);
}

RunCheckpoint parse_run_checkpoint(std::string_view bytes, const std::filesystem::path& file) {
  sim::ByteReader in(bytes);
  RunCheckpoint checkpoint;
  try {
    in.require_text("what the file is", magic);
    in.get("the version", version, version);
    checkpoint.scene_name = in.get_text("the scene's name");
    checkpoint.scene = in.get_text("the scene");
    checkpoint.frame = in.get("the frame", 0, sim::max_counter);
    for_each_field(checkpoint.summary, [&](const char*, auto& number) { number = get_number(in, number); });
    checkpoint.simulation = in.get_text("the simulation");
    in.require_seal();
  } catch (const sim::BadBytes& error) {
    refuse(file, error.what());
  }
  return checkpoint;
}

void require_same_scene(const std::filesystem::path& file, const RunCheckpoint& checkpoint,
                        const std::string& scene_name, const std::string& scene) {
  std::istringstream found(scene);
  std::istringstream expected(checkpoint.scene);
  std::string section, expected_section;
  while (found || expected) {
    const RecordLine line = next_line(found, section);
    const RecordLine saved = next_line(expected, expected_section);
    if (line.key != saved.key || line.value != saved.value) {
      const auto said = [](const RecordLine& l) { return l.key.empty() ? "nothing" : l.key + " = " + l.value; };
      refuse(file, "it was saved of the scene '" + checkpoint.scene_name + "', which has " + said(saved) +
                       "; found the scene '" + scene_name + "' with " + said(line));
    }
  }
}

void restore(const std::filesystem::path& file, const RunCheckpoint& checkpoint, sim::Simulation& simulation) {
  try {
    simulation.restore(sim::decode(checkpoint.simulation, simulation.garment()));
  } catch (const sim::BadBytes& error) {
    refuse(file, std::string("in what it says of the simulation, ") + error.what());
  }
}

sim::ExternalForces without_gravity_and_wind(sim::ExternalForces forces) {
  forces.gravity_m_per_s2 = sim::Vec3(0.0);
  forces.gravity_path.clear();
  forces.wind.speed_m_per_s = 0.0;
  return forces;
}

void dress(const Scene& scene, sim::Simulation& simulation, const StageReport& begin) {
  const int frames = scene.dressing_frames();
  if (frames == 0) return;
  const sim::Surroundings surroundings = simulation.surroundings();
  // Gravity, wind and friction are off: clothes would fall off a thin body or slide to where they have space.
  sim::Surroundings still = surroundings;
  still.forces = without_gravity_and_wind(std::move(still.forces));
  for (sim::Body& body : still.bodies) body.friction = 0.0;
  simulation.set_surroundings(still);
  simulation.set_time(-frames * simulation.frame_time_s());
  int tight_frames = 0;
  const Stopwatch since_start;
  for (int frame = 1; frame <= frames; ++frame) {
    throw_if_interrupted();
    if (begin) {
      begin(fmt::format("being put on, frame {} of {}{}", frame, frames,
                        time_left(1e-3 * since_start.elapsed_ms(), frame - 1, frames)));
    }
    const auto give_up = [&](const std::string& why) {
      throw PromiseBroken("while it is dressed, in frame {} of {}: {}", frame, frames, why);
    };
    try {
      simulation.advance_frame(throw_if_interrupted);
    } catch (const sim::ContactBlocked& error) {
      give_up(error.what());
    }
    const sim::BoundedSettings& bounded = scene.simulation.solver.bounded;
    tight_frames = simulation.last_report().bound_kept ? 0 : tight_frames + 1;
    if (tight_frames == max_tight_frames && !bounded.allow_exceeding) {
      give_up(fmt::format("it would have to stretch by more than solver.max_stretch = {:g}", bounded.max_stretch));
    }
  }
  simulation.set_surroundings(surroundings);
  simulation.set_time(0.0);
}

int start_frame(const Scene& scene) {
  return scene.checkpoint.empty() ? 0 : read_run_checkpoint(scene.checkpoint).frame;
}

int go_to_start(const Scene& scene, const LoadedBodies& bodies, sim::Simulation& simulation, const StageReport& begin) {
  if (scene.checkpoint.empty()) {
    const std::vector<FitRow> fit = scene.dressing_frames() == 0
                                        ? std::vector<FitRow>{}
                                        : compute_fit(bodies, simulation.garment(), simulation.state().current);
    require_wearable(scene, fit);
    try {
      dress(scene, simulation, begin);
      require_worn(scene, simulation);
    } catch (const PromiseBroken& error) {
      throw PromiseBroken(error.what() + describe_misfit(fit));
    }
    return 0;
  }
  const RunCheckpoint checkpoint = read_run_checkpoint(scene.checkpoint);
  restore(scene.checkpoint, checkpoint, simulation);
  return checkpoint.frame;
}

}  // namespace taut::app
