#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// A garment with the vertices and faces of its file, in their order, as other programs know it. Of a grid,
/// and of a garment that was subdivided, those of the simulated mesh.
class WrittenCloth {
 public:
  /// `loaded` must outlive this object.
  explicit WrittenCloth(const GarmentInScene& loaded);

  std::size_t vertices() const { return mesh_vertex_.size(); }
  /// Returns the position of every vertex, in m, from those of the mesh. What no remaining triangle uses is
  /// where the file has it.
  std::vector<sim::Vec3> positions(std::span<const sim::Vec3> mesh_m) const;
  /// Returns the garment as an OBJ file, with normals of this shape where the file has some.
  std::string obj(std::span<const sim::Vec3> mesh_m) const;
  /// Returns it at rest.
  std::string obj_at_rest() const { return text(loaded_.shown_mesh().positions); }

 private:
  std::vector<sim::Vec3> written(std::span<const sim::Vec3> shown_m) const;
  std::string text(std::span<const sim::Vec3> shown_m) const;

  const GarmentInScene& loaded_;
  FileFaces faces_;
  std::vector<sim::Index> mesh_vertex_;  ///< per vertex written; sim::no_vertex: none
};

/// Returns unit normals per vertex of the mesh in this shape, in m.
std::vector<glm::vec3> mesh_normals(const sim::Mesh& mesh, std::span<const sim::Vec3> mesh_m);

}  // namespace taut::app
