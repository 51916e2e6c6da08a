#pragma once

#include "renderer/gl/picture_target.hpp"
#include "renderer/light/studio_light.hpp"
#include "renderer/passes/covered_squares.hpp"

namespace taut::renderer {

/// Draws surfaces: first their triangles into a visibility buffer, then shades what is visible. The block
/// `Frame` and the light's textures must be bound.
class SurfacePass {
 public:
  /// The context must be current and outlive this object.
  explicit SurfacePass(const GladGLContext& context);

  /// Uploads the corners of all surfaces, which draw_visibility() needs.
  void upload_positions(std::span<const SurfaceView> surfaces);
  /// Draws the triangle numbers into the bound visibility buffer. `under_marks`: pushes surfaces back a
  /// little, so that marks on them are in front.
  void draw_visibility(bool under_marks);
  /// Gathers the light of the same surfaces. Calls no OpenGL, so that another thread may call it meanwhile.
  void gather(std::span<const SurfaceView> surfaces, StudioLight& light);
  /// Uploads surfaces and light, after gather(). Throws ContextError.
  void upload_surfaces();
  /// Shades what the visibility buffer holds and blends it over a framebuffer, which is bound. `place`: the
  /// tile's rectangle there, which becomes the viewport. `block`: the tile's. `halve`: squares of 2 by 2
  /// pixels are shaded as one, if there is one sample and the tile's sides are even.
  void shade(const VisibilityBuffer& visibility, GLuint framebuffer, const FrameBlock& block, const PixelRect& place,
             bool halve);

 private:
  void draw_squares(bool partial);
  void shade_squares(std::size_t kind, const VisibilityBuffer& visibility, const glm::ivec2& corner_px);
  void shade_halved(const VisibilityBuffer& visibility, GLuint framebuffer, const PixelRect& place);

  const GladGLContext* gl_;
  LazyProgram visibility_;
  VertexArray corner_arrays_;
  Buffer corner_buffer_;
  std::vector<glm::vec3> corner_positions_;  // three for each triangle
  std::vector<std::vector<std::string_view>> variant_defines_;
  std::vector<LazyProgram> shading_;  // by what defines() has
  ColourMapTexture colour_maps_;
  BaseColourMapTexture base_colour_maps_;
  SurfaceBuffers surface_buffers_;
  CoveredSquares squares_;
  VertexArray square_arrays_;
  Buffer square_corners_;
  LazyProgram upscaling_;
  GrowingTarget halved_;
  SurfaceLight surface_light_;  // scratch
  bool any_scalars_ = false;
};

}  // namespace taut::renderer
