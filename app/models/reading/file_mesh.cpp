#include "app/models/reading/file_mesh.hpp"

#include <fmt/format.h>

#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

/// Writes each pair of coordinates at its first use. Returns, per corner, the number of its pair, counted from 1.
std::vector<std::size_t> put_texture_vertices(std::span<const glm::vec2> corner_uv, const std::string& number,
                                              std::string& text) {
  const std::string line = "vt " + number + ' ' + number + '\n';
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> vertices;
  for (const glm::vec2& uv : corner_uv) {
    std::string written = fmt::format(fmt::runtime(line), uv.x, uv.y);
    const auto [place, is_new] = known.try_emplace(std::move(written), known.size() + 1);
    text += is_new ? place->first : "";
    vertices.push_back(place->second);
  }
  return vertices;
}

template <class Vectors>
void put_vectors(const std::string& kind, const Vectors& vectors, const std::string& number, std::string& text) {
  const std::string line = kind + ' ' + number + ' ' + number + ' ' + number + '\n';
  for (const auto& v : vectors) fmt::format_to(std::back_inserter(text), fmt::runtime(line), v.x, v.y, v.z);
}

}  // namespace

std::optional<sim::Index> FileVertices::find(std::size_t number) const {
  const bool is_kept = number < mesh_vertex.size() && mesh_vertex[number] != sim::no_vertex;
  return is_kept ? std::optional(mesh_vertex[number]) : std::nullopt;
}

std::string FileVertices::why_missing(std::size_t number) const {
  if (number >= mesh_vertex.size()) {
    return fmt::format("found vertex {}, expected one of the {}", number, describe());
  }
  return fmt::format(
      "vertex {} of the file belongs to no face, or only to faces that were removed because they have no "
      "area or repeat others",
      number);
}

std::optional<sim::Index> FileVertices::number_of(sim::Index vertex) const {
  const auto found = std::ranges::find(mesh_vertex, vertex);
  return found != mesh_vertex.end() ? std::optional(static_cast<sim::Index>(found - mesh_vertex.begin()))
                                    : std::nullopt;
}

std::string FileVertices::describe() const {
  return fmt::format("{}, 0 to {}",
                     are_corners ? "corners of the file's faces, which share no vertices" : "vertices of the file",
                     mesh_vertex.size() - 1);
}

FileFaces make_faces(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv) {
  assert(corner_uv.empty() || (mesh.quads.empty() && corner_uv.size() == 3 * mesh.triangles.size()));
  FileFaces faces;
  const auto add = [&](const auto& corners) {
    faces.corner_counts.push_back(static_cast<std::uint32_t>(corners.size()));
    faces.corners.insert(faces.corners.end(), corners.begin(), corners.end());
  };
  for (const sim::Quad& quad : mesh.quads) add(quad);
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) add(mesh.triangles[t]);
  faces.corner_uv.assign(corner_uv.begin(), corner_uv.end());
  return faces;
}

std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions, std::span<const glm::vec2> corner_uv,
                     const std::string& comment, const std::string& number) {
  assert(positions.size() == mesh.positions.size());
  return obj_text(make_faces(mesh, corner_uv), positions, {}, comment, number);
}

std::string obj_text(const FileFaces& faces, std::span<const sim::Vec3> positions, std::span<const glm::vec3> normals,
                     const std::string& comment, const std::string& number) {
  assert(normals.empty() || normals.size() == positions.size());
  std::string text = comment;
  put_vectors("v", positions, number, text);
  const std::vector<std::size_t> texture_vertices = put_texture_vertices(faces.corner_uv, number, text);
  put_vectors("vn", normals, number, text);
  auto section = faces.sections.begin();
  std::size_t corner = 0;
  for (std::uint32_t face = 0; face < faces.corner_counts.size(); ++face) {
    for (; section != faces.sections.end() && section->first_face <= face; ++section) {
      text += section->line + '\n';
    }
    text += 'f';
    for (const std::size_t end = corner + faces.corner_counts[face]; corner < end; ++corner) {
      const auto vertex = std::size_t{faces.corners[corner]} + 1;
      const std::string uv = texture_vertices.empty() ? "" : std::to_string(texture_vertices[corner]);
      text += ' ' + std::to_string(vertex) + (uv.empty() && normals.empty() ? "" : "/" + uv) +
              (normals.empty() ? "" : '/' + std::to_string(vertex));
    }
    text += '\n';
  }
  return text;
}

}  // namespace taut::app
