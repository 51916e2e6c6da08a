#pragma once

#include "renderer/light/colour_textures.hpp"

namespace taut::renderer {

/// Texels in a row of a texture that holds numbers; the shaders have it too.
inline constexpr int texels_per_row = 1024;

/// All surfaces of one frame in textures, in the layout of shaders/surface_buffers.glsl.
class SurfaceBuffers {
 public:
  /// The context must be current and outlive this object.
  explicit SurfaceBuffers(const GladGLContext& context);

  /// Removes all surfaces.
  void clear();
  /// Adds a surface. `colour_map_row`: row of its colour map in ColourMapTexture; ignored without scalars. `maps`
  /// provides the layers of its base colour maps.
  void add(const SurfaceView& surface, int colour_map_row, BaseColourMapTexture& maps);
  /// Uploads all surfaces. Throws ContextError when they exceed the context's largest texture.
  void upload();

  /// Binds the textures to their units.
  void bind() const;
  /// Returns whether a surface has a base colour map.
  bool has_maps() const { return !corners_.empty(); }
  /// Returns whether there are no triangles.
  bool empty() const { return triangles_.empty(); }

  /// Returns the number of vertices of all surfaces.
  std::size_t vertex_count() const { return vertices_.size(); }

 private:
  // Three texels of the vertex buffer.
  struct Vertex {
    glm::vec4 place;     // position, metres
    glm::vec4 facing;    // normal
    glm::vec4 material;  // material coordinate, metres, or x: scalar
  };
  // Trim of one triangle.
  struct Trim {
    std::array<glm::vec4, 3> corners;
    glm::vec4 band;
  };
  struct MaterialTexels {
    glm::vec4 outside;
    glm::vec4 inside;
    glm::vec4 properties;
    glm::vec4 threads;
    glm::vec4 stitches;
  };
  void add_materials(const SurfaceView& surface, float row, BaseColourMapTexture& maps);
  void add_corners(const SurfaceView& surface);
  template <typename Row>
  void upload_rows(const Texture& target, GLint format, std::vector<Row>& rows, unsigned unit) const;

  const GladGLContext* gl_;
  Texture vertex_data_;
  Texture triangle_data_;
  Texture material_data_;
  Texture corner_data_;
  Texture trim_data_;
  std::vector<Vertex> vertices_;
  std::vector<glm::uvec4> triangles_;  // xyz: vertices, w: see shaders/surface_buffers.glsl
  std::vector<MaterialTexels> materials_;
  std::vector<glm::vec2> corners_;  // three per triangle, up to the last triangle with a map
  std::vector<Trim> trims_;
  std::size_t max_rows_ = 0;
};

}  // namespace taut::renderer
