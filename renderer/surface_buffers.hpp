#pragma once

#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl_objects.hpp"

namespace taut::renderer {

/// One surface on the graphics card, filled anew for each frame.
class SurfaceBuffers {
 public:
  explicit SurfaceBuffers(const GladGLContext& context);

  /// Triangles near `eye` are drawn first, so that little is shaded that is hidden afterwards. `decided` says
  /// for each position whether the key light reaches it, as KeyDecision does.
  void fill(const SurfaceView& surface, std::span<const float> decided, const glm::vec3& eye);
  void draw() const;
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
  Buffer decisions;
  Buffer materials;
  Buffer indices;
  GLsizei index_count = 0;
  GLsizei open_count = 0;
  std::vector<float> shown;            // scratch
  std::vector<std::uint32_t> ordered;  // scratch
  std::vector<std::uint32_t> open;     // scratch
  std::vector<std::uint32_t> agreed;   // scratch
};

}  // namespace taut::renderer
