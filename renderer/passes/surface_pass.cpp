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

// Returns the square of a coordinate, within one pixel's rounding.
int square_index(float coordinate_px, int count) {
  const float square = std::floor(coordinate_px / static_cast<float>(CoveredSquares::side_px));
  return whole_within(square, -1, count);
}

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

void CoveredSquares::find(const SurfaceBuffers& surfaces, const glm::mat4& world_to_clip, const glm::ivec2& size_px) {
  tile_px_ = size_px;
  squares_ = (size_px + side_px - 1) / side_px;
  are_covered_.assign(static_cast<std::size_t>(squares_.x) * static_cast<std::size_t>(squares_.y), 0);
  projected_.clear();
  for (const SurfaceBuffers::Vertex& vertex : surfaces.all_vertices()) {
    const glm::vec4 clip = world_to_clip * glm::vec4{glm::vec3{vertex.place}, 1.0F};
    const bool seen = clip.w > 1e-6F;
    const glm::vec2 place = seen ? (0.5F + 0.5F * glm::vec2{clip} / clip.w) * glm::vec2{size_px} : glm::vec2{0};
    projected_.emplace_back(place, seen ? 1.0F : 0.0F);
  }
  for (const glm::uvec4& triangle : surfaces.all_triangles()) {
    const glm::vec3& a = projected_[triangle.x];
    const glm::vec3& b = projected_[triangle.y];
    const glm::vec3& c = projected_[triangle.z];
    if (a.z + b.z + c.z == 0.0F) continue;
    if (a.z * b.z * c.z == 0.0F) return mark_all();
    const glm::vec2 lower = glm::vec2{glm::min(a, glm::min(b, c))} - 1.0F;
    const glm::vec2 upper = glm::vec2{glm::max(a, glm::max(b, c))} + 1.0F;
    mark({square_index(lower.x, squares_.x), square_index(lower.y, squares_.y), square_index(upper.x, squares_.x),
          square_index(upper.y, squares_.y)});
  }
}

void CoveredSquares::mark(const glm::ivec4& box) {
  for (int y = std::max(box.y, 0); y <= std::min(box.w, squares_.y - 1); ++y) {
    for (int x = std::max(box.x, 0); x <= std::min(box.z, squares_.x - 1); ++x) {
      are_covered_[static_cast<std::size_t>(y * squares_.x + x)] = 1;
    }
  }
}

// Marks all squares: a triangle that reaches behind the eye may be anywhere.
void CoveredSquares::mark_all() { std::ranges::fill(are_covered_, std::uint8_t{1}); }

void CoveredSquares::add_run(int first, int end, int row) {
  const auto clip = [&](int x, int y) {
    return 2.0F * glm::vec2{std::min(x * side_px, tile_px_.x), std::min(y * side_px, tile_px_.y)} /
               glm::vec2{tile_px_} -
           1.0F;
  };
  const glm::vec2 lower_left = clip(first, row);
  const glm::vec2 lower_right = clip(end, row);
  const glm::vec2 upper_left = clip(first, row + 1);
  const glm::vec2 upper_right = clip(end, row + 1);
  triangles_.insert(triangles_.end(), {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left});
}

const std::vector<glm::vec2>& CoveredSquares::corners() {
  triangles_.clear();
  for (int row = 0; row < squares_.y; ++row) {
    const std::uint8_t* own = are_covered_.data() + static_cast<std::ptrdiff_t>(row) * squares_.x;
    for (int x = 0; x < squares_.x;) {
      const int first = x;
      while (x < squares_.x && own[x] != 0) ++x;
      if (x > first) {
        add_run(first, x, row);
      } else {
        ++x;
      }
    }
  }
  return triangles_;
}

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
  for (std::size_t variant = 0; variant < variants; ++variant) {
    shading_.emplace_back(context, "squares.vert", "surface.frag", defines(variant));
  }
  gl_->BindVertexArray(corner_arrays_.name());
  set_attribute(*gl_, 0, corner_buffer_, 3, 3, 0);
  gl_->BindVertexArray(square_arrays_.name());
  set_attribute(*gl_, 0, square_corners_, 2, 2, 0);
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

void SurfacePass::draw_squares() {
  const std::vector<glm::vec2>& covered = squares_.corners();
  gl_->BindVertexArray(square_arrays_.name());
  taut::renderer::upload(*gl_, GL_ARRAY_BUFFER, square_corners_, std::span<const glm::vec2>(covered));
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(covered.size()));
}

void SurfacePass::shade_squares(std::size_t kind, const VisibilityBuffer& visibility, const glm::ivec2& corner_px) {
  const Program& program =
      shading_[kind + (any_scalars_ ? scalars : 0) + (surface_buffers_.has_maps() ? base_colour_maps : 0)].use();
  program.set("corner", glm::ivec4{corner_px, 0, 0});
  program.set("samples_x", visibility.samples_x());
  program.set("samples_y", visibility.samples_y());
  draw_squares();
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
  // Encoded colours are blended as they are, which is cheaper; they are only at outlines.
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_squares();
  gl_->Disable(GL_BLEND);
}

void SurfacePass::begin_shading(const VisibilityBuffer& visibility, GLuint framebuffer, const FrameBlock& block,
                                const PixelRect& place) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  squares_.find(surface_buffers_, block.world_to_clip, {place.width_px, place.height_px});
  surface_buffers_.bind();
  // The first call makes the map in the active texture unit.
  if (any_scalars_) bind_texture(*gl_, scalar_maps_unit, GL_TEXTURE_2D, colour_maps_.texture());
  if (surface_buffers_.has_maps()) {
    bind_texture(*gl_, base_colour_maps_unit, GL_TEXTURE_2D_ARRAY, base_colour_maps_.texture());
  }
  visibility.bind();
  gl_->Disable(GL_DEPTH_TEST);
}

void SurfacePass::shade(const VisibilityBuffer& visibility, GLuint framebuffer, const FrameBlock& block,
                        const PixelRect& place, bool halve) {
  if (surface_buffers_.empty()) return;
  begin_shading(visibility, framebuffer, block, place);
  const bool several = visibility.samples() > 1;
  if (halve && !several && place.width_px % 2 == 0 && place.height_px % 2 == 0) {
    shade_halved(visibility, framebuffer, place);
  } else {
    // Single samples cover their pixel or not, so the shader encodes them, which is cheaper.
    if (several) begin_blending_over(*gl_);
    shade_squares(several ? several_samples : 0, visibility, {place.x_px, place.y_px});
    if (several) end_blending_over(*gl_);
  }
  gl_->Enable(GL_DEPTH_TEST);
}

void SurfacePass::add_sampled(const VisibilityBuffer& visibility, GLuint framebuffer, const FrameBlock& block,
                              const PixelRect& place) {
  if (surface_buffers_.empty()) return;
  begin_shading(visibility, framebuffer, block, place);
  begin_adding(*gl_);
  shade_squares(sampled, visibility, {place.x_px, place.y_px});
  end_blending_over(*gl_);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
