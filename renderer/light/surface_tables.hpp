#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/light/key_decision.hpp"

namespace taut::renderer {

/// What light arrives at a surface.
struct SurfaceLight {
  std::vector<KeyLight> key;   ///< one for each triangle
  std::vector<glm::vec2> sky;  ///< of the studio all around, one for each position; x outside, y inside
};

/// All surfaces of one frame on the graphics card, as shaders/tables.glsl describes them.
class SurfaceTables {
 public:
  struct Vertex {
    glm::vec4 place;     ///< position
    glm::vec4 facing;    ///< normal, sky light outside
    glm::vec4 material;  ///< material coordinate or scalar, sky light inside
  };

  explicit SurfaceTables(const GladGLContext& context);

  void clear();
  /// `colour_map_row`: where the texture of colour maps has that of the surface's scalars, if it has any.
  void add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row);
  /// Hands over what was added since clear(). Throws ContextError when it is more than the context can take.
  void upload();

  void bind() const;
  bool empty() const { return triangles.empty(); }

  std::span<const Vertex> all_vertices() const { return vertices; }
  /// Three vertices, and four times the surface plus the triangle's KeyLight.
  std::span<const glm::uvec4> all_triangles() const { return triangles; }
  static bool is_open(const glm::uvec4& triangle) {
    return (triangle.w & 3U) == static_cast<std::uint32_t>(KeyLight::open);
  }

 private:
  struct Look {
    glm::vec4 outside;
    glm::vec4 inside;
    glm::vec4 rest;
  };
  // A table is a buffer and the texture through which shaders read it.
  struct Table {
    explicit Table(const GladGLContext& context) : buffer(context), texture(context) {}
    Buffer buffer;
    Texture texture;
  };
  template <typename Row>
  void upload_table(Table& table, GLenum format, const std::vector<Row>& rows, unsigned unit) const;

  const GladGLContext* gl;
  Table vertex_table;
  Table triangle_table;
  Table look_table;
  std::vector<Vertex> vertices;
  std::vector<glm::uvec4> triangles;
  std::vector<Look> looks;
  std::size_t most_texels = 0;
};

}  // namespace taut::renderer
