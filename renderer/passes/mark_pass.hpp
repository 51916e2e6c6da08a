#pragma once

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// Returns the spheres of one group as one mesh.
TriangleMesh merged_spheres(const SphereView& spheres);

/// Returns the mesh as a surface with the spheres' colour. The mesh must outlive the view.
SurfaceView make_sphere_view(const TriangleMesh& mesh, const SphereView& spheres);

/// Draws marks: lines, wireframes and points of constant width in pixels, with antialiased edges.
class MarkPass {
 public:
  /// The context must be current and outlive this object.
  explicit MarkPass(const GladGLContext& context);

  /// Draw marks over the bound framebuffer. Blending must be on and depth writes off; the block `Frame` must
  /// be bound. They switch the depth test.
  void draw_wireframe(std::span<const glm::vec3> positions, const Wireframe& wireframe);
  void draw_lines(const LineView& lines);
  void draw_points(const PointView& points);

 private:
  struct MarkSegment {
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
  std::vector<MarkSegment> segments_;  // scratch
  std::vector<Point> marks_;       // scratch
};

/// Averages samples and supersampled pixels and blends the result over the bound framebuffer.
class ResolvePass {
 public:
  /// The context must be current and outlive this object.
  explicit ResolvePass(const GladGLContext& context);

  /// Averages `drawn` in linear light over its `samples` and over squares of `supersampling` pixels. `drawn` is
  /// sRGB-encoded and premultiplied in linear light. The viewport must be its rectangle in the framebuffer; `corner_px`
  /// is the viewport's lower left corner.
  void draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px);
  /// Adds `drawn`, one sample per pixel, to the lower left of the bound framebuffer.
  void add(const Texture& drawn);

 private:
  void draw_mean(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px);

  const GladGLContext* gl_;
  LazyProgram one_;
  LazyProgram many_;
  VertexArray no_arrays_;
};

}  // namespace taut::renderer
