#include "renderer/passes/surface_pass.hpp"

namespace taut::renderer {

namespace {

// How far surfaces under marks are pushed back, in units of glPolygonOffset. Less lets the surface eat into
// wireframes, more lets the far side show through at a silhouette, where the near side is steeper.
constexpr float under_marks_factor = 1.5F;
constexpr float under_marks_units = 4.0F;

// Variants of the shading: the sum of these says which.
constexpr std::size_t several_samples = 1;
constexpr std::size_t scalars = 2;
constexpr std::size_t partial_shadow = 4;
// Instead of several samples.
constexpr std::size_t halved = 8;
constexpr std::size_t base_colour_maps = 16;
constexpr std::size_t variants = 32;

std::vector<std::string_view> defines(std::size_t variant) {
  std::vector<std::string_view> names;
  if ((variant & several_samples) != 0) names.emplace_back("MULTISAMPLED");
  if ((variant & scalars) != 0) names.emplace_back("SCALARS");
  if ((variant & partial_shadow) != 0) names.emplace_back("PARTIAL_SHADOW");
  if ((variant & halved) != 0) names.emplace_back("HALVED");
  if ((variant & base_colour_maps) != 0) names.emplace_back("BASE_COLOUR_MAPS");
  return names;
}

}  // namespace

SurfacePass::SurfacePass(const GladGLContext& context)
    : gl_(&context),
      visibility_(context, "visibility.vert", "visibility.frag"),
      corner_arrays_(context),
      corner_buffer_(context),
      colour_maps_(context),
      base_colour_maps_(context),
      surface_buffers_(context),
      square_arrays_(context),
      square_corners_(context),
      upscaling_(context, "squares.vert", "surface_halved.frag"),
      halved_(context, GL_RGBA8, halved_unit) {
  for (std::size_t variant = 0; variant < variants; ++variant) variant_defines_.push_back(defines(variant));
  for (const auto& names : variant_defines_) {
    shading_.emplace_back(context, "squares.vert", "surface.frag", names);
  }
  gl_->BindVertexArray(corner_arrays_.name());
  set_attribute(*gl_, 0, corner_buffer_, 3, 3, 0);
  gl_->BindVertexArray(square_arrays_.name());
  set_attribute(*gl_, 0, square_corners_, 2, 2, 0);
  gl_->BindVertexArray(0);
}

// Every triangle has corners of its own, so that a vertex knows the number of its triangle.
void SurfacePass::upload_positions(std::span<const SurfaceView> surfaces) {
  corner_positions_.clear();
  for (const SurfaceView& surface : surfaces) {
    for (const std::uint32_t corner : surface.triangles) corner_positions_.push_back(surface.positions[corner]);
  }
  taut::renderer::upload(*gl_, GL_ARRAY_BUFFER, corner_buffer_, std::span<const glm::vec3>(corner_positions_));
}

void SurfacePass::gather(std::span<const SurfaceView> surfaces, StudioLight& light) {
  surface_buffers_.clear();
  base_colour_maps_.clear();
  any_scalars_ = false;
  for (const SurfaceView& surface : surfaces) {
    light.gather(coarse_of(surface), surface_light_);
    if (surface.refinement) spread(surface, surface_light_);
    surface_buffers_.add(surface, surface_light_, surface.scalars ? colour_maps_.row_of(surface.scalars->map) : -1,
                         base_colour_maps_);
    any_scalars_ = any_scalars_ || surface.scalars;
  }
}

void SurfacePass::upload_surfaces() {
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

void SurfacePass::draw_squares(bool partial) {
  const std::vector<glm::vec2>& covered = squares_.corners(partial);
  gl_->BindVertexArray(square_arrays_.name());
  taut::renderer::upload(*gl_, GL_ARRAY_BUFFER, square_corners_, std::span<const glm::vec2>(covered));
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(covered.size()));
}

void SurfacePass::shade_squares(std::size_t kind, const VisibilityBuffer& visibility, const glm::ivec2& corner_px) {
  for (const bool partial : {false, true}) {
    if (squares_.corners(partial).empty()) continue;
    const Program& program = shading_[kind + (any_scalars_ ? scalars : 0) + (partial ? partial_shadow : 0) +
                                      (surface_buffers_.has_maps() ? base_colour_maps : 0)]
                                 .use();
    program.set("corner", glm::ivec4{corner_px, 0, 0});
    program.set("samples_x", visibility.samples_x());
    program.set("samples_y", visibility.samples_y());
    draw_squares(partial);
  }
}

void SurfacePass::shade_halved(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place) {
  halved_.begin({place.width_px / 2, place.height_px / 2});
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
  shade_squares(halved, visibility, {0, 0});
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  halved_.bind();
  const Program& program = upscaling_.use();
  program.set("corner", glm::ivec4{place.x_px, place.y_px, 0, 0});
  program.set("halved_part", glm::vec4{0.5F / glm::vec2{halved_.size_px()}, 0.0F, 0.0F});
  for (const bool partial : {false, true}) draw_squares(partial);
}

void SurfacePass::shade(const VisibilityBuffer& visibility, GLuint framebuffer, const FrameBlock& block,
                        const PixelRect& place, bool halve) {
  if (surface_buffers_.empty()) return;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  squares_.find(surface_buffers_, block.world_to_clip, {place.width_px, place.height_px});
  const bool several = visibility.samples() > 1;
  surface_buffers_.bind();
  // The map is made when it is first asked for, in the unit that happens to be active.
  if (any_scalars_) bind_texture(*gl_, scalar_maps_unit, GL_TEXTURE_2D, colour_maps_.texture());
  if (surface_buffers_.has_maps()) {
    bind_texture(*gl_, base_colour_maps_unit, GL_TEXTURE_2D_ARRAY, base_colour_maps_.texture());
  }
  visibility.bind();
  gl_->Disable(GL_DEPTH_TEST);
  // A single sample covers its pixel or does not: it is encoded by the shader, which is cheaper.
  if (several) begin_blending_over(*gl_);
  if (halve && !several && place.width_px % 2 == 0 && place.height_px % 2 == 0) {
    shade_halved(visibility, framebuffer, place);
  } else {
    shade_squares(several ? several_samples : 0, visibility, {place.x_px, place.y_px});
  }
  if (several) end_blending_over(*gl_);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
