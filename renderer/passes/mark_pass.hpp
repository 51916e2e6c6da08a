#pragma once

#include <span>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/gl/lazy_program.hpp"

namespace taut::renderer {

/// Draws marks: lines, wireframes and points of constant width in pixels, with antialiased edges.
class MarkPass {
 public:
  /// The context must be current and outlive this object. `files`: all shaders.
  MarkPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Draw marks over the bound framebuffer. Blending must be on and depth writes off; the block `Frame` must
  /// be bound. They switch the depth test.
  void draw_wireframe(std::span<const glm::vec3> positions, const Wireframe& wireframe);
  void draw_lines(const LineView& lines);
  void draw_points(const PointView& points);

 private:
  struct Segment {
    glm::vec3 start;
    glm::vec3 end;
    Colour start_colour;
    Colour end_colour;
  };
  struct Point {
    glm::vec3 centre;
    Colour colour;
  };
  void draw_segments(float width_px, float opacity);

  const GladGLContext* gl_;
  LazyProgram line_;
  LazyProgram point_;
  VertexArray line_arrays_;
  Buffer line_buffer_;
  VertexArray point_arrays_;
  Buffer point_buffer_;
  std::vector<Segment> segments_;  // scratch
  std::vector<Point> marks_;       // scratch
};

}  // namespace taut::renderer
