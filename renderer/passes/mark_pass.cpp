#include "renderer/passes/mark_pass.hpp"

namespace taut::renderer {
namespace {

// Returns the segments of each sphere. A few large ones need a round outline, many small ones have to be cheap: a row
// of pins has more triangles than the garment it holds.
int segments_of_each(std::size_t count) {
  if (count <= 8) return 64;
  return count <= 24 ? 20 : 12;
}

// Motion of marks towards the eye, as a fraction of the distance. With lower values the surface hides parts of them,
// with higher ones they show through a layer of cloth in front.
constexpr float lift = 0.0008F;
// Points are wider than lines, so a slanted surface needs more.
constexpr float point_lift = 0.004F;

void set_depth_test(const GladGLContext& gl, bool hidden) { (hidden ? gl.Enable : gl.Disable)(GL_DEPTH_TEST); }

}  // namespace

TriangleMesh merged_spheres(const SphereView& spheres) {
  const TriangleMesh one = make_sphere(glm::vec3{0.0F}, spheres.radius_m, segments_of_each(spheres.centres.size()));
  TriangleMesh all;
  for (const glm::vec3& centre : spheres.centres) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3& position : one.positions) all.positions.push_back(position + centre);
    all.normals.insert(all.normals.end(), one.normals.begin(), one.normals.end());
    for (const std::uint32_t index : one.triangles) all.triangles.push_back(first + index);
  }
  return all;
}

SurfaceView make_sphere_view(const TriangleMesh& mesh, const SphereView& spheres) {
  SurfaceView view;
  view.positions = mesh.positions;
  view.normals = mesh.normals;
  view.triangles = mesh.triangles;
  view.style.inside_colour = view.style.outside_colour = spheres.colour;
  view.style.roughness = 0.45F;
  view.style.sheen = 0.0F;
  view.style.translucency = 0.0F;
  view.casts_shadow = spheres.casts_shadow;
  return view;
}

MarkPass::MarkPass(const GladGLContext& context)
    : gl_(&context),
      line_(context, "line.vert", "line.frag"),
      point_(context, "point.vert", "point.frag"),
      line_arrays_(context),
      line_buffer_(context),
      point_arrays_(context),
      point_buffer_(context) {
  constexpr int line_floats = sizeof(MarkSegment) / sizeof(float);
  gl_->BindVertexArray(line_arrays_.name());
  for (int i = 0; i < 4; ++i) set_attribute(*gl_, static_cast<GLuint>(i), line_buffer_, 3, line_floats, 3 * i, 1);
  constexpr int point_floats = sizeof(Point) / sizeof(float);
  gl_->BindVertexArray(point_arrays_.name());
  for (int i = 0; i < 2; ++i) set_attribute(*gl_, static_cast<GLuint>(i), point_buffer_, 3, point_floats, 3 * i, 1);
  gl_->BindVertexArray(0);
}

void MarkPass::draw_wireframe(std::span<const glm::vec3> positions, const Wireframe& wireframe) {
  segments_.clear();
  for (const auto& [a, b] : wireframe.edges) {
    segments_.push_back({positions[a], positions[b], wireframe.colour, wireframe.colour});
  }
  set_depth_test(*gl_, true);
  draw_segments(wireframe.width_px, wireframe.opacity);
}

void MarkPass::draw_lines(const LineView& lines) {
  segments_.clear();
  for (std::size_t i = 0; i + 1 < lines.points.size(); i += 2) {
    segments_.push_back({lines.points[i], lines.points[i + 1], lines.colour, lines.colour});
  }
  set_depth_test(*gl_, lines.hidden_by_surfaces);
  draw_segments(lines.width_px, lines.opacity);
}

void MarkPass::draw_segments(float width_px, float opacity) {
  if (segments_.empty()) return;
  gl_->BindVertexArray(line_arrays_.name());
  upload(*gl_, GL_ARRAY_BUFFER, line_buffer_, std::span<const MarkSegment>(segments_));
  line_.use().set("mark", glm::vec4{width_px, opacity, lift, 0.0F});
  gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments_.size()));
}

void MarkPass::draw_points(const PointView& points) {
  if (points.centres.empty()) return;
  marks_.clear();
  for (const glm::vec3& centre : points.centres) marks_.push_back({centre, points.colour});
  set_depth_test(*gl_, points.hidden_by_surfaces);
  gl_->BindVertexArray(point_arrays_.name());
  upload(*gl_, GL_ARRAY_BUFFER, point_buffer_, std::span<const Point>(marks_));
  point_.use().set("mark", glm::vec4{points.diameter_px, 1.0F, point_lift, 0.0F});
  gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(marks_.size()));
}

ResolvePass::ResolvePass(const GladGLContext& context)
    : gl_(&context),
      one_(context, "fullscreen.vert", "resolve.frag"),
      many_(context, "fullscreen.vert", "resolve.frag", {"MULTISAMPLED"}),
      no_arrays_(context) {}

void ResolvePass::draw_mean(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px) {
  bind_texture(*gl_, drawn_unit, samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, drawn);
  const Program& program = (samples > 1 ? many_ : one_).use();
  program.set("resolve", glm::ivec4{samples, supersampling, corner_px});
  gl_->Disable(GL_DEPTH_TEST);
  gl_->BindVertexArray(no_arrays_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Enable(GL_DEPTH_TEST);
}

void ResolvePass::draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px) {
  begin_blending_over(*gl_);
  draw_mean(drawn, samples, supersampling, corner_px);
  end_blending_over(*gl_);
}

void ResolvePass::add(const Texture& drawn) {
  begin_adding(*gl_);
  draw_mean(drawn, 1, 1, {0, 0});
  end_blending_over(*gl_);
}

}  // namespace taut::renderer
