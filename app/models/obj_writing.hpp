#pragma once

#include "app/models/file_mesh.hpp"

namespace taut::app {

/// The comment that such a file begins with.
inline constexpr const char* obj_comment = "# Taut; metres, y up\n";

/// The mesh as a Wavefront OBJ file, with its vertices at `positions`: in metres, one per vertex of the mesh.
/// The file begins with the comment. `number` is a format of fmt; the default keeps every bit of the
/// positions, so that a reader measures the same lengths. `corner_uv` as in faces_of(); equal ones are
/// written once.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::span<const glm::vec2> corner_uv = {}, const std::string& comment = obj_comment,
                     const std::string& number = "{}");

/// The same of the faces of a file, with positions per vertex of that file. `normals`: unit vectors, one per
/// vertex, or none.
std::string obj_text(const FileFaces& faces, std::span<const sim::Vec3> positions, std::span<const glm::vec3> normals,
                     const std::string& comment = obj_comment, const std::string& number = "{}");

}  // namespace taut::app
