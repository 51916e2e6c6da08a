#include "app/garment/garment_remarks.hpp"

#include <fmt/core.h>

namespace taut::app {
namespace {

void append_repairs(const sim::MeshReport& repairs, std::vector<std::string>& lines) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) {
      lines.push_back(fmt::format("{} {}", count, what));
    }
  };
  say(repairs.degenerate_triangles, "triangles without area removed");
  say(repairs.duplicate_triangles, "repeated triangles removed");
  say(repairs.turned_triangles, "triangles turned to the side of their neighbours");
  say(repairs.parted_vertices, "vertices of layers that touch kept apart");
  say(repairs.near_vertices, "vertices welded to near ones");
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

void print_remarks(const Scene& scene, const LoadedGarment& loaded) {
  const std::string file = scene.garment.file.filename().string();
  for (const std::string& line : remarks_of(loaded)) {
    fmt::print("{}: {}\n", file, line);
  }
}

}  // namespace taut::app
