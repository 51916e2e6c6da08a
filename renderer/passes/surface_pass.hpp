#pragma once

#include "renderer/gl/picture_target.hpp"
#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {

/// Returns the bounds of surfaces and marks in the picture, rounded outwards to blocks of 32 pixels; zero wide if there
/// are none. `world_to_clip` belongs to the whole picture. `surfaces`: the frame's surfaces and the meshes of its
/// spheres.
Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces, const glm::mat4& world_to_clip,
                   const PictureSettings& settings);

/// Returns whether any surface or mark has a point below y = height_m, metres.
bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces);

/// Draws surfaces: first their triangles into a visibility buffer, then the shading of visible ones. The block `Frame`
/// and the light's textures must be bound.
class SurfacePass {
 public:
  /// The context must be current and outlive this object.
  explicit SurfacePass(const GladGLContext& context);

  /// Uploads all surfaces and binds their buffers. Throws ContextError.
  void upload(std::span<const SurfaceView> surfaces);
  /// Returns the number of vertices of all surfaces.
  std::size_t vertex_count() const { return surface_buffers_.vertex_count(); }
  /// Draws the triangle numbers into the bound visibility buffer. `under_marks` pushes surfaces back slightly, so that
  /// marks on them are in front.
  void draw_visibility(bool under_marks);
  /// Shades the visibility buffer and blends it over a framebuffer, which is bound. `place`: the tile's rectangle
  /// there, which becomes the viewport. `halve`: squares of 2 by 2 pixels are shaded as one if there is one sample and
  /// the tile's sides are even; outlines are then spread over three pixels.
  void shade(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place, bool halve);
  /// Adds one pass of many to the lower left of a framebuffer, in linear light; otherwise like shade().
  void add_sampled(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place);
  /// Returns whether a surface shows data colours.
  bool has_data_colours() const { return any_scalars_; }

 private:
  void begin_shading(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place);
  void shade_tile(std::size_t kind, const VisibilityBuffer& visibility, const glm::ivec2& corner_px);
  void shade_halved(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place);

  const GladGLContext* gl_;
  LazyProgram visibility_;
  VertexArray corner_arrays_;
  Buffer corner_buffer_;
  std::vector<glm::vec3> corner_positions_;  // three for each triangle
  std::vector<LazyProgram> shading_;         // variants in the order of defines()
  ColourMapTexture colour_maps_;
  BaseColourMapTexture base_colour_maps_;
  SurfaceBuffers surface_buffers_;
  LazyProgram upscaling_;
  GrowingTarget halved_;
  bool any_scalars_ = false;
};

}  // namespace taut::renderer
