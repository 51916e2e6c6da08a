#pragma once

#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl_objects.hpp"

namespace taut::renderer {

/// One surface on the graphics card, filled anew for each frame.
class SurfaceBuffers {
 public:
  explicit SurfaceBuffers(const GladGLContext& context);

  void fill(const SurfaceView& surface);
  void draw() const;

 private:
  const GladGLContext* gl;
  VertexArray arrays;
  Buffer positions;
  Buffer normals;
  Buffer scalars;
  Buffer indices;
  GLsizei index_count = 0;
  std::vector<float> shown;  // scratch
};

}  // namespace taut::renderer
