#pragma once

#include <span>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/gl/lazy_program.hpp"

namespace taut::renderer {

/// Lines, wireframes and points: widths in pixels, soft edges, blended over what is there already.
class MarkPass {
 public:
  MarkPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Expects blending and the depth test to be on and depth writes off.
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

  const GladGLContext* gl;
  LazyProgram line;
  LazyProgram point;
  VertexArray line_arrays;
  Buffer line_buffer;
  VertexArray point_arrays;
  Buffer point_buffer;
  std::vector<Segment> segments;  // scratch
  std::vector<Point> marks;       // scratch
};

}  // namespace taut::renderer
