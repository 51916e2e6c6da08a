#include "renderer/passes/surface_pass.hpp"

#include "renderer/page/canvas.hpp"

namespace taut::renderer {
namespace {

// Side in px of the blocks to which bounds are rounded outwards. Higher values reallocate buffers less often while a
// garment moves, lower ones draw fewer pixels.
constexpr int block_px = 32;
// Margin around surfaces and marks, px, besides a mark's width: edges are antialiased half a pixel beyond it, and a
// line's corners stick out by less than its width. Lower values cut marks off.
constexpr float soft_px = 2.0F;

// Bounds of points in the picture, in pixels from its lower left corner.
class Bounds {
 public:
  Bounds(const glm::mat4& world_to_clip, const PictureSettings& settings)
      : to_clip_(world_to_clip), size_px_(settings.width_px, settings.height_px) {}

  void add(std::span<const glm::vec3> points, float margin_px) {
    for (const glm::vec3& point : points) {
      const glm::vec4 clip = to_clip_ * glm::vec4{point, 1.0F};
      if (clip.w < 1e-3F) {  // behind the eye: its surface may be anywhere
        lower_px_ = glm::vec2{0.0F};
        upper_px_ = size_px_;
        return;
      }
      const glm::vec2 place_px = (0.5F + 0.5F * glm::vec2{clip} / clip.w) * size_px_;
      lower_px_ = glm::min(lower_px_, place_px - margin_px);
      upper_px_ = glm::max(upper_px_, place_px + margin_px);
    }
  }

  Tile in_blocks() const {
    const glm::ivec2 size{size_px_};
    const auto within = [&](const glm::vec2& place) {
      return glm::ivec2{whole_within(place.x, 0, size.x), whole_within(place.y, 0, size.y)};
    };
    const glm::ivec2 lower = within(lower_px_) / block_px * block_px;
    const glm::ivec2 last = within(upper_px_) / block_px;
    const glm::ivec2 upper = glm::min((last + 1) * block_px, size);
    if (lower_px_.x > upper_px_.x || lower.x >= upper.x || lower.y >= upper.y) return {};
    return {lower.x, size.y - upper.y, upper.x - lower.x, upper.y - lower.y};
  }

 private:
  glm::mat4 to_clip_;
  glm::vec2 size_px_;
  glm::vec2 lower_px_{1e30F};
  glm::vec2 upper_px_{-1e30F};
};

// Depth offset of surfaces under marks, in units of glPolygonOffset. With lower values the surface hides parts of
// wireframes, with higher ones the far side shows through at a silhouette, where the near side is steeper.
constexpr float under_marks_factor = 1.5F;
constexpr float under_marks_units = 4.0F;

// Flags of the shading variants; a variant is their sum.
constexpr std::size_t several_samples = 1;
constexpr std::size_t scalars = 2;
// Excludes several samples.
constexpr std::size_t halved = 4;
constexpr std::size_t base_colour_maps = 8;
// Excludes several samples and halving.
constexpr std::size_t sampled = 16;
constexpr std::size_t variants = 32;

std::vector<std::string_view> defines(std::size_t variant) {
  std::vector<std::string_view> names;
  for (const char* name : {"MULTISAMPLED", "SCALARS", "HALVED", "BASE_COLOUR_MAPS", "SAMPLED"}) {
    if (variant % 2 != 0) names.emplace_back(name);
    variant /= 2;
  }
  return names;
}

}  // namespace

Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces, const glm::mat4& world_to_clip,
                   const PictureSettings& settings) {
  Bounds bounds(world_to_clip, settings);
  for (const SurfaceView& surface : surfaces) {
    bounds.add(surface.positions, soft_px + (surface.wireframe ? surface.wireframe->width_px : 0.0F));
  }
  for (const LineView& lines : frame.lines) bounds.add(lines.points, soft_px + lines.width_px);
  for (const PointView& points : frame.points) bounds.add(points.centres, soft_px + points.diameter_px);
  return bounds.in_blocks();
}

bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces) {
  const auto below = [&](std::span<const glm::vec3> points) {
    return std::ranges::any_of(points, [&](const glm::vec3& point) { return point.y < height_m; });
  };
  const auto any = [](const auto& views, const auto& holds) { return std::ranges::any_of(views, holds); };
  return any(surfaces, [&](const SurfaceView& surface) { return below(surface.positions); }) ||
         any(frame.lines, [&](const LineView& lines) { return below(lines.points); }) ||
         any(frame.points, [&](const PointView& points) { return below(points.centres); });
}

SurfacePass::SurfacePass(const GladGLContext& context)
    : gl_(&context),
      visibility_(context, "visibility.vert", "visibility.frag"),
      corner_arrays_(context),
      corner_buffer_(context),
      colour_maps_(context),
      base_colour_maps_(context),
      surface_buffers_(context),
      upscaling_(context, "fullscreen.vert", "surface_halved.frag"),
      halved_(context, GL_RGBA8, halved_unit) {
  for (std::size_t variant = 0; variant < variants; ++variant) {
    shading_.emplace_back(context, "fullscreen.vert", "surface.frag", defines(variant));
  }
  gl_->BindVertexArray(corner_arrays_.name());
  set_attribute(*gl_, 0, corner_buffer_, 3, 3, 0);
  gl_->BindVertexArray(0);
}

void SurfacePass::upload(std::span<const SurfaceView> surfaces) {
  // Separate corners for every triangle let a vertex know its triangle's number.
  corner_positions_.clear();
  surface_buffers_.clear();
  base_colour_maps_.clear();
  any_scalars_ = false;
  for (const SurfaceView& surface : surfaces) {
    for (const std::uint32_t corner : surface.triangles) corner_positions_.push_back(surface.positions[corner]);
    surface_buffers_.add(surface, surface.scalars ? colour_maps_.row_index(surface.scalars->map) : -1,
                         base_colour_maps_);
    any_scalars_ = any_scalars_ || surface.scalars;
  }
  taut::renderer::upload(*gl_, GL_ARRAY_BUFFER, corner_buffer_, std::span<const glm::vec3>(corner_positions_));
  if (surface_buffers_.empty()) return;
  surface_buffers_.upload();
  if (surface_buffers_.has_maps()) base_colour_maps_.upload();
}

void SurfacePass::draw_visibility(bool under_marks) {
  if (corner_positions_.empty()) return;
  if (under_marks) gl_->Enable(GL_POLYGON_OFFSET_FILL);
  gl_->PolygonOffset(under_marks_factor, under_marks_units);
  visibility_.use();
  gl_->BindVertexArray(corner_arrays_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corner_positions_.size()));
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
}

void SurfacePass::shade_tile(std::size_t kind, const VisibilityBuffer& visibility, const glm::ivec2& corner_px) {
  const Program& program =
      shading_[kind + (any_scalars_ ? scalars : 0) + (surface_buffers_.has_maps() ? base_colour_maps : 0)].use();
  program.set("corner", glm::ivec4{corner_px, 0, 0});
  program.set("samples_x", visibility.samples_x());
  program.set("samples_y", visibility.samples_y());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void SurfacePass::shade_halved(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place) {
  halved_.begin({place.width_px / 2, place.height_px / 2});
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
  shade_tile(halved, visibility, {0, 0});
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  halved_.bind();
  const Program& program = upscaling_.use();
  program.set("corner", glm::ivec4{place.x_px, place.y_px, 0, 0});
  program.set("halved_part", glm::vec4{0.5F / glm::vec2{halved_.size_px()}, 0.0F, 0.0F});
  // Encoded colours are blended as they are, which is cheaper; they are only at outlines.
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Disable(GL_BLEND);
}

void SurfacePass::begin_shading(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  surface_buffers_.bind();
  // OpenGL draws nothing without an array of vertices, though fullscreen.vert reads none.
  gl_->BindVertexArray(corner_arrays_.name());
  // The first call makes the map in the active texture unit.
  if (any_scalars_) bind_texture(*gl_, scalar_maps_unit, GL_TEXTURE_2D, colour_maps_.texture());
  if (surface_buffers_.has_maps()) {
    bind_texture(*gl_, base_colour_maps_unit, GL_TEXTURE_2D_ARRAY, base_colour_maps_.texture());
  }
  visibility.bind();
  gl_->Disable(GL_DEPTH_TEST);
}

void SurfacePass::shade(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place, bool halve) {
  if (surface_buffers_.empty()) return;
  begin_shading(visibility, framebuffer, place);
  const bool several = visibility.samples() > 1;
  if (halve && !several && place.width_px % 2 == 0 && place.height_px % 2 == 0) {
    shade_halved(visibility, framebuffer, place);
  } else {
    // Single samples cover their pixel or not, so the shader encodes them, which is cheaper.
    if (several) begin_blending_over(*gl_);
    shade_tile(several ? several_samples : 0, visibility, {place.x_px, place.y_px});
    if (several) end_blending_over(*gl_);
  }
  gl_->Enable(GL_DEPTH_TEST);
}

void SurfacePass::add_sampled(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place) {
  if (surface_buffers_.empty()) return;
  begin_shading(visibility, framebuffer, place);
  begin_adding(*gl_);
  shade_tile(sampled, visibility, {place.x_px, place.y_px});
  end_blending_over(*gl_);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
