#include "app/caches/written_cloth.hpp"

#include <numeric>

#include "app/drawing/mesh_arrays.hpp"
#include "app/models/obj_writing.hpp"
#include "renderer/mesh_normals.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

WrittenCloth::WrittenCloth(const GarmentInScene& loaded) : loaded_(loaded) {
  if (!loaded.file_faces.empty()) {
    faces_ = loaded.file_faces;
    mesh_vertex_ =
        loaded.following ? loaded.following->file_vertices.mesh_vertex : loaded.file_vertices.mesh_vertex;
    return;
  }
  faces_ = faces_of(loaded.shown_mesh(), loaded.colours.corner_uv);
  mesh_vertex_.resize(loaded.shown_mesh().positions.size());
  std::iota(mesh_vertex_.begin(), mesh_vertex_.end(), 0U);
}

std::vector<sim::Vec3> WrittenCloth::positions(std::span<const sim::Vec3> mesh_m) const {
  return written(loaded_.shown_m(mesh_m));
}

std::vector<sim::Vec3> WrittenCloth::written(std::span<const sim::Vec3> shown_m) const {
  std::vector<sim::Vec3> written_m(vertices());
  for (std::size_t v = 0; v < written_m.size(); ++v) {
    const sim::Index vertex = mesh_vertex_[v];
    written_m[v] = vertex == sim::no_vertex ? loaded_.file_rest_m[v] : shown_m[vertex];
  }
  return written_m;
}

std::string WrittenCloth::obj(std::span<const sim::Vec3> mesh_m) const {
  return text(loaded_.shown_m(mesh_m));
}

std::string WrittenCloth::text(std::span<const sim::Vec3> shown_m) const {
  std::vector<glm::vec3> normals;
  if (faces_.has_normals) {
    const std::vector<glm::vec3> of_mesh = mesh_normals(loaded_.shown_mesh(), shown_m);
    for (const sim::Index vertex : mesh_vertex_) {
      normals.push_back(vertex == sim::no_vertex ? glm::vec3(0.0F, 1.0F, 0.0F) : of_mesh[vertex]);
    }
  }
  return obj_text(faces_, written(shown_m), normals);
}

std::vector<glm::vec3> mesh_normals(const sim::Mesh& mesh, std::span<const sim::Vec3> mesh_m) {
  std::vector<glm::vec3> normals(mesh_m.size());
  const std::vector<glm::vec3> places(mesh_m.begin(), mesh_m.end());
  renderer::vertex_normals(places, flat(mesh.triangles), normals);
  return normals;
}

}  // namespace taut::app
