#include "renderer/passes/merged_spheres.hpp"

namespace taut::renderer {

namespace {

// Segments of each sphere. A few large ones need a round outline, many small ones need to be cheap: a row of
// pins has more triangles than the garment it holds.
int segments_of_each(std::size_t count) {
  if (count <= 8) return 64;
  return count <= 24 ? 20 : 12;
}

}  // namespace

TriangleMesh merged_spheres(const SphereView& spheres) {
  const TriangleMesh one =
      make_sphere(glm::vec3{0.0F}, spheres.radius_m, segments_of_each(spheres.centres.size()));
  TriangleMesh all;
  for (const glm::vec3& centre : spheres.centres) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3& position : one.positions) all.positions.push_back(position + centre);
    all.normals.insert(all.normals.end(), one.normals.begin(), one.normals.end());
    for (const std::uint32_t index : one.triangles) all.triangles.push_back(first + index);
  }
  return all;
}

SurfaceView view_of(const TriangleMesh& mesh, const SphereView& spheres) {
  SurfaceView view;
  view.positions = mesh.positions;
  view.normals = mesh.normals;
  view.triangles = mesh.triangles;
  view.style.outside_colour = spheres.colour;
  view.style.inside_colour = spheres.colour;
  view.style.roughness = 0.45F;
  view.style.sheen = 0.0F;
  view.style.translucency = 0.0F;
  view.casts_shadow = spheres.casts_shadow;
  return view;
}

}  // namespace taut::renderer
