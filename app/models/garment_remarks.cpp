#include "app/models/garment_remarks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "app/base/counted.hpp"

namespace taut::app {
namespace {

void append_repairs(const sim::MeshReport& repairs, std::vector<std::string>& lines) {
  const auto say = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) {
      lines.push_back(counted(count, one, many));
    }
  };
  say(repairs.degenerate_triangles, "triangle without area removed", "triangles without area removed");
  say(repairs.duplicate_triangles, "repeated triangle removed", "repeated triangles removed");
  say(repairs.turned_triangles, "triangle turned to the side of its neighbours",
      "triangles turned to the side of their neighbours");
  say(repairs.parted_vertices, "vertex of layers that touch kept apart",
      "vertices of layers that touch kept apart");
  say(repairs.near_vertices, "vertex welded to a near one", "vertices welded to near ones");
}

bool has_numbers(const std::optional<std::vector<PinSelector>>& pins) {
  const auto is_number = [](const PinSelector& pin) { return std::holds_alternative<sim::Index>(pin); };
  return pins && std::any_of(pins->begin(), pins->end(), is_number);
}

}  // namespace

std::vector<std::string> remarks_of(const LoadedGarment& loaded) {
  std::vector<std::string> lines;
  if (loaded.placement && loaded.placement->guessed) {
    lines.push_back("its unit is the " + loaded.placement->unit_text + " (--units)");
    lines.push_back("up is " + loaded.placement->up_text + " (--up)");
  }
  if (loaded.placement && loaded.placement->moved_m != sim::Vec3(0.0)) {
    lines.emplace_back("it is very far from the origin and was moved there");
  }
  if (loaded.repairs) {
    append_repairs(*loaded.repairs, lines);
  }
  if (loaded.hanging) {
    const std::vector<std::string> parts = describe(*loaded.hanging);
    lines.insert(lines.end(), parts.begin(), parts.end());
  }
  return lines;
}

std::string remark_on_crossings(const GarmentInScene& loaded) {
  const Surface start = surface_at_start(loaded);
  const std::vector<CrossingPair> pairs = crossing_pairs(start);
  return pairs.empty() ? "" : "at the start " + describe(start, pairs);
}

void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output) {
  const std::string file = loaded.model ? scene.garment.file.filename().string() : scene.name;
  std::vector<std::string> lines = remarks_of(loaded);
  if (loaded.file_vertices.are_corners && has_numbers(scene.pins)) {
    lines.push_back("pins.at counts " + loaded.file_vertices.describe());
  }
  if (std::string crossings = remark_on_crossings(loaded); !crossings.empty()) {
    lines.push_back(std::move(crossings));
  }
  for (const std::string& line : lines) {
    fmt::print(output, "{}: {}\n", file, line);
  }
}

}  // namespace taut::app
