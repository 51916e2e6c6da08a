#pragma once

#include "renderer/context/context.hpp"

namespace taut::renderer {

/// Vertex of a user interface's triangles.
struct OverlayVertex {
  glm::vec2 position_px;       ///< pixels right of and below the picture's upper left corner
  glm::vec2 sheet_place;       ///< texture coordinates in the sheet, 0..1
  std::uint32_t colour_rgba8;  ///< red in the lowest byte; sRGB-encoded, not premultiplied
};

/// Consecutive triangles with one clip rectangle.
struct OverlayPart {
  glm::ivec2 clip_lower_px;      ///< upper left corner, pixels
  glm::ivec2 clip_upper_px;      ///< lower right corner, excluded; no larger than the other: nothing is drawn
  std::size_t first_index = 0;   ///< index into OverlayView::indices
  std::size_t index_count = 0;   ///< three per triangle
  std::size_t first_vertex = 0;  ///< index into OverlayView::vertices; added to every index
};

/// Triangles of a user interface. The spans belong to the caller and must live until draw() returns.
struct OverlayView {
  std::span<const OverlayVertex> vertices;
  std::span<const std::uint16_t> indices;
  std::vector<OverlayPart> parts;
};

/// Draws a user interface over a picture: coloured triangles multiplied by a sheet of white letters and small pictures.
/// It blends sRGB-encoded colours, for which user interfaces are designed.
class OverlayPass {
 public:
  /// Makes the context current. The context must outlive the pass. Throws ContextError and ShaderError.
  explicit OverlayPass(Context& context);
  ~OverlayPass();

  /// Sets the sheet: width_px * height_px pixels of four bytes, top row first. Throws ContextError.
  void set_sheet(int width_px, int height_px, std::span<const std::uint8_t> rgba);

  /// Draws to a framebuffer of the caller (0: the window) of width_px by height_px. Throws ContextError.
  void draw(unsigned framebuffer, int width_px, int height_px, const OverlayView& overlay);

 private:
  struct OverlayResources;
  std::unique_ptr<OverlayResources> parts_;
};

}  // namespace taut::renderer
