#include "renderer/frame_check.hpp"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "renderer/frame_view.hpp"

namespace taut::renderer {
namespace {

[[noreturn]] void fail(const std::string& part, const std::string& what) {
  throw std::invalid_argument(part + ": " + what);
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_finite(const std::string& part, const char* name, std::span<const glm::vec3> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!is_finite(values[i])) fail(part, std::string(name) + " " + std::to_string(i) + " is not finite");
  }
}

void check_indices(const std::string& part, const char* name, std::span<const std::uint32_t> indices,
                   std::size_t group, std::size_t count) {
  if (indices.size() % group != 0) {
    fail(part, std::to_string(indices.size()) + " indices in " + name + ", expected a multiple of " +
                   std::to_string(group));
  }
  for (const std::uint32_t index : indices) {
    if (index >= count) {
      fail(part, "index " + std::to_string(index) + " in " + name + ", there are " + std::to_string(count) +
                     " positions");
    }
  }
}

void check_count(const std::string& part, const char* name, std::size_t found, std::size_t expected) {
  if (found != expected) {
    fail(part, std::to_string(found) + " " + name + ", expected " + std::to_string(expected));
  }
}

void check_colours(const std::string& part, std::span<const Colour> colours, std::size_t count) {
  if (colours.size() != 1) check_count(part, "colours", colours.size(), count);
  check_finite(part, "colour", colours);
}

void check_map(const std::string& part, const SurfaceView& surface, const BaseColourMap& map) {
  if (map.rgba == nullptr) return;
  if (surface.corner_coordinates.empty()) fail(part, "a base colour map without corner coordinates");
  if (map.width_px < 1 || map.width_px > 16384 || map.height_px < 1 || map.height_px > 16384) {
    fail(part, "a base colour map of " + std::to_string(map.width_px) + " x " +
                   std::to_string(map.height_px) + " pixels, expected 1 to 16384 each");
  }
  check_count(
      part, "bytes of a base colour map", map.rgba->size(),
      std::size_t{4} * static_cast<std::size_t>(map.width_px) * static_cast<std::size_t>(map.height_px));
}

void check_base_colours(const std::string& part, const SurfaceView& surface) {
  if (!surface.corner_coordinates.empty()) {
    check_count(part, "corner coordinates", surface.corner_coordinates.size(), surface.triangles.size());
  }
  for (const glm::vec2& place : surface.corner_coordinates) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) fail(part, "a corner coordinate is not finite");
  }
  for (const BaseColour& colour : surface.base_colours) check_map(part, surface, colour.map);
  if (surface.base_colour_of_triangle.empty()) return;
  check_count(part, "base colours of triangles", surface.base_colour_of_triangle.size(),
              surface.triangles.size() / 3);
  for (const std::uint32_t colour : surface.base_colour_of_triangle) {
    if (colour >= surface.base_colours.size()) {
      fail(part, "a triangle has base colour " + std::to_string(colour) + ", there are " +
                     std::to_string(surface.base_colours.size()));
    }
  }
}

void check_refinement(const std::string& part, const SurfaceView& surface) {
  const Refinement& refinement = *surface.refinement;
  check_count(part, "coarse vertices and vertices with parents",
              refinement.coarse_vertices + refinement.parents.size(), surface.positions.size());
  check_indices(part, "coarse triangles", refinement.coarse_triangles, 3, refinement.coarse_vertices);
  for (std::size_t i = 0; i < refinement.parents.size(); ++i) {
    check_indices(part, "parents", refinement.parents[i], 2, refinement.coarse_vertices + i);
  }
  check_count(part, "parent triangles", refinement.parent_triangles.size(), surface.triangles.size() / 3);
  check_indices(part, "parent triangles", refinement.parent_triangles, 1,
                refinement.coarse_triangles.size() / 3);
}

void check_surface(const std::string& part, const SurfaceView& surface) {
  const std::size_t count = surface.positions.size();
  check_finite(part, "position", surface.positions);
  check_count(part, "normals", surface.normals.size(), count);
  check_finite(part, "normal", surface.normals);
  if (!surface.material_coordinates.empty()) {
    check_count(part, "material coordinates", surface.material_coordinates.size(), count);
    check_finite(part, "material coordinate", surface.material_coordinates);
  }
  check_indices(part, "triangles", surface.triangles, 3, count);
  check_base_colours(part, surface);
  if (surface.refinement) check_refinement(part, surface);
  for (const TrimmedTriangle& trim : surface.trims) {
    check_indices(part, "trims", std::span(&trim.triangle, 1), 1, surface.triangles.size() / 3);
  }
  if (surface.wireframe) check_indices(part, "wireframe edges", surface.wireframe->edges, 2, count);
  if (surface.scalars) {
    check_count(part, "scalars", surface.scalars->values.size(), count);
    if (!(surface.scalars->maximum > surface.scalars->minimum)) {
      fail(part, "the scalar range is empty, maximum has to be above minimum");
    }
  }
}

void check_range(const char* name, int found, int lowest, int highest) {
  if (found >= lowest && found <= highest) return;
  fail("picture settings", std::string(name) + " is " + std::to_string(found) + ", expected " +
                               std::to_string(lowest) + " to " + std::to_string(highest));
}

void check_camera(const Camera& camera) {
  if (!is_near({camera.eye, camera.eye}) || !is_near({camera.target, camera.target}) ||
      camera.eye == camera.target) {
    fail("camera", "eye and target have to be different and no farther than 1e9 m");
  }
  if (!(camera.vertical_fov_rad > 0.0F && camera.vertical_fov_rad < 3.1F)) {
    fail("camera", "vertical_fov_rad has to be above 0 and below 3.1");
  }
  if (!(camera.near_m > 0.0F && camera.far_m > camera.near_m && std::isfinite(camera.far_m))) {
    fail("camera", "near_m has to be above 0 and below far_m, which has to be finite");
  }
}

}  // namespace

void check_frame(const FrameView& frame) {
  check_camera(frame.camera);
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) {
    check_surface("surface " + std::to_string(i), frame.surfaces[i]);
  }
  for (std::size_t i = 0; i < frame.lines.size(); ++i) {
    const std::string part = "line " + std::to_string(i);
    const LineView& line = frame.lines[i];
    if (line.points.size() % 2 != 0) fail(part, "an odd number of points, a segment has two");
    check_finite(part, "point", line.points);
    check_colours(part, line.colours, line.points.size());
  }
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const std::string part = "points " + std::to_string(i);
    check_finite(part, "centre", frame.points[i].centres);
    check_colours(part, frame.points[i].colours, frame.points[i].centres.size());
  }
  for (std::size_t i = 0; i < frame.spheres.size(); ++i) {
    const std::string part = "spheres " + std::to_string(i);
    check_finite(part, "centre", frame.spheres[i].centres);
    const float radius_m = frame.spheres[i].radius_m;
    if (!(radius_m > 0.0F && std::isfinite(radius_m))) fail(part, "radius_m has to be above 0");
  }
}

void check_settings(const PictureSettings& settings) {
  check_range("width_px", settings.width_px, 1, 16384);
  check_range("height_px", settings.height_px, 1, 16384);
  check_range("samples", settings.samples, 1, 64);
  check_range("supersampling", settings.supersampling, 1, 8);
  check_range("shadow_map_px", settings.shadow_map_px, 256, 8192);
  check_range("shading_px", settings.shading_px, 1, 2);
  check_range("shadow_taps", settings.shadow_taps, 1, 64);
  check_range("sky_directions", settings.sky_directions, 0, 64);
}

}  // namespace taut::renderer
