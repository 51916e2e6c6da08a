#include "app/output/run_checkpoint.hpp"

#include <sstream>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "sim/bytes.hpp"
#include "sim/checkpoint.hpp"

namespace taut::app {
namespace {

constexpr std::string_view magic = "TAUTRUN\n";
constexpr std::uint32_t version = 5;

int get_number(sim::ByteReader& in, int) {
  return in.get("a number of frames in the summary", -1, sim::most_counted);
}
double get_number(sim::ByteReader& in, double) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return in.get("a number of the summary", -infinity, infinity);
}

// With its section, and its value: "wind.speed = 4.0".
struct Line {
  std::string key;
  std::string value;
};

Line next_line(std::istream& text, std::string& section) {
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

}  // namespace

std::string bytes_of(const RunCheckpoint& checkpoint) {
  sim::ByteWriter out;
  for (const char c : magic) {
    out.put(c);
  }
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
  write_text_file(file, bytes_of(checkpoint));
}

RunCheckpoint read_run_checkpoint(const std::filesystem::path& file) {
  return run_checkpoint_of(read_text_file(file), file);
}

RunCheckpoint run_checkpoint_of(std::string_view bytes, const std::filesystem::path& file) {
  sim::ByteReader in(bytes);
  RunCheckpoint checkpoint;
  try {
    in.require_text("what the file is", magic);
    in.get("the version", version, version);
    checkpoint.scene_name = in.get_text("the scene's name");
    checkpoint.scene = in.get_text("the scene");
    checkpoint.frame = in.get("the frame", 0, sim::most_counted);
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
  std::string section;
  std::string expected_section;
  while (found || expected) {
    const Line line = next_line(found, section);
    const Line saved = next_line(expected, expected_section);
    if (line.key != saved.key || line.value != saved.value) {
      const auto said = [](const Line& l) { return l.key.empty() ? "nothing" : l.key + " = " + l.value; };
      refuse(file, "it was saved of the scene '" + checkpoint.scene_name + "', which has " + said(saved) +
                       "; found the scene '" + scene_name + "' with " + said(line));
    }
  }
}

void restore(const std::filesystem::path& file, const RunCheckpoint& checkpoint,
             sim::Simulation& simulation) {
  try {
    simulation.restore(sim::decode(checkpoint.simulation, simulation.garment()));
  } catch (const sim::BadBytes& error) {
    refuse(file, std::string("in what it says of the simulation, ") + error.what());
  }
}

}  // namespace taut::app
