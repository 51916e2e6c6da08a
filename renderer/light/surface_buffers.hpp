#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/base_colour_map_texture.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/light/shadow_classifier.hpp"

namespace taut::renderer {

/// The light that arrives at a surface.
struct SurfaceLight {
  std::vector<KeyVisibility> key;  ///< one per triangle
  std::vector<glm::vec2> sky;      ///< ambient, one per vertex; x outside, y inside
};

/// Replaces the light at the coarse mesh of a refined surface by that at the surface. A vertex that faces
/// away from those it is between has their other side's.
void spread(const SurfaceView& surface, SurfaceLight& light);

/// All surfaces of one frame in buffer textures, laid out as shaders/surface_buffers.glsl says.
class SurfaceBuffers {
 public:
  /// Three texels of the vertex buffer.
  struct Vertex {
    glm::vec4 place;     ///< position, metres
    glm::vec4 facing;    ///< normal; w: ambient light outside
    glm::vec4 material;  ///< material coordinate, metres, or x: scalar; w: ambient light inside
  };

  /// The context must be current and outlive this object.
  explicit SurfaceBuffers(const GladGLContext& context);

  /// Removes all surfaces.
  void clear();
  /// Adds a surface with its light. `colour_map_row`: row of its colour map in ColourMapTexture; ignored
  /// without scalars. `maps` is asked for the layers of its base colour maps.
  void add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row,
           BaseColourMapTexture& maps);
  /// Uploads all surfaces. Throws ContextError when they exceed the context's largest buffer texture.
  void upload();

  /// Binds the buffer textures to their units.
  void bind() const;
  /// Returns whether a surface has a base colour map.
  bool has_maps() const { return !corners_.empty(); }
  /// Returns whether there are no triangles.
  bool empty() const { return triangles_.empty(); }

  /// Returns the vertices of all surfaces.
  std::span<const Vertex> all_vertices() const { return vertices_; }
  /// Returns one element per triangle: xyz its vertices, w as shaders/surface_buffers.glsl says.
  std::span<const glm::uvec4> all_triangles() const { return triangles_; }
  /// Returns whether a triangle's KeyVisibility is partial.
  static bool is_partial(const glm::uvec4& triangle) {
    return (triangle.w & 3U) == static_cast<std::uint32_t>(KeyVisibility::partial);
  }

 private:
  // Of a triangle that is trimmed.
  struct Trim {
    std::array<glm::vec4, 3> corners;
    glm::vec4 band;
  };
  struct Material {
    glm::vec4 outside;
    glm::vec4 inside;
    glm::vec4 rest;
    glm::vec4 threads;
  };
  // A buffer and the texture through which shaders read it.
  struct BufferTexture {
    explicit BufferTexture(const GladGLContext& context) : buffer(context), texture(context) {}
    Buffer buffer;
    Texture texture;
  };
  void add_materials(const SurfaceView& surface, float row, BaseColourMapTexture& maps);
  void add_corners(const SurfaceView& surface);
  template <typename Row>
  void upload_rows(BufferTexture& target, GLenum format, const std::vector<Row>& rows, unsigned unit) const;

  const GladGLContext* gl_;
  BufferTexture vertex_data_;
  BufferTexture triangle_data_;
  BufferTexture material_data_;
  BufferTexture corner_data_;
  BufferTexture trim_data_;
  std::vector<Vertex> vertices_;
  std::vector<glm::uvec4> triangles_;
  std::vector<Material> materials_;
  std::vector<glm::vec2> corners_;  // three per triangle up to the last that has a map
  std::vector<Trim> trims_;
  std::size_t most_texels_ = 0;
};

}  // namespace taut::renderer
