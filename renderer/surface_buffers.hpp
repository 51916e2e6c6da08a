#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl_objects.hpp"

namespace taut::renderer {

/// What light arrives at each position of a surface.
struct VertexLight {
  std::vector<float> key;      ///< 1 in the key light, 0 in its shadow, 0.5 for pixels to find out
  std::vector<glm::vec2> sky;  ///< of the studio all around; x outside, y inside
};

/// One surface on the graphics card, filled anew for each frame.
class SurfaceBuffers {
 public:
  explicit SurfaceBuffers(const GladGLContext& context);

  void fill(const SurfaceView& surface, const VertexLight& light);
  /// The triangles whose pixels have to find out whether they are in the light, and the others.
  void draw_open() const;
  void draw_decided() const;

 private:
  void draw_range(GLsizei first, GLsizei count) const;

  const GladGLContext* gl;
  VertexArray arrays;
  Buffer positions;
  Buffer normals;
  Buffer scalars;
  Buffer key_light;
  Buffer sky_light;
  Buffer materials;
  Buffer indices;
  GLsizei index_count = 0;
  GLsizei open_count = 0;
  std::vector<float> shown;           // scratch
  std::vector<std::uint32_t> open;    // scratch
  std::vector<std::uint32_t> agreed;  // scratch
};

}  // namespace taut::renderer
