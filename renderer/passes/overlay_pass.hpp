#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "renderer/context/context.hpp"

namespace taut::renderer {

/// A corner of a flat triangle.
struct OverlayVertex {
  glm::vec2 position_px;       ///< from the upper left corner of the picture
  glm::vec2 coverage_place;    ///< 0..1 in the coverage map
  std::uint32_t colour_rgba8;  ///< red in the lowest byte; sRGB-encoded, straight alpha
};

/// Consecutive triangles that share a clip rectangle.
struct OverlayPart {
  glm::ivec2 clip_lower_px;  ///< upper left corner
  glm::ivec2 clip_upper_px;  ///< lower right corner; nothing is drawn where it is not beyond the other
  std::size_t first_index = 0;
  std::size_t index_count = 0;
  std::size_t first_vertex = 0;  ///< added to every index
};

/// Triangles of a user interface, drawn over what is there. The spans belong to the caller.
struct OverlayView {
  std::span<const OverlayVertex> vertices;
  std::span<const std::uint16_t> indices;
  std::vector<OverlayPart> parts;
};

/// Draws user interfaces: triangles with blended colours and the letters of one coverage map. Blends encoded
/// colours, as user interfaces are designed.
class OverlayPass {
 public:
  /// The context has to outlive the pass. Throws ShaderError.
  explicit OverlayPass(Context& context);
  ~OverlayPass();
  OverlayPass(const OverlayPass&) = delete;
  OverlayPass& operator=(const OverlayPass&) = delete;

  /// One byte for each pixel, rows from the top; a vertex without letters points at a byte of 255.
  void set_coverage(int width_px, int height_px, std::span<const std::uint8_t> coverage);

  /// Draws to a framebuffer of the caller (0: the window) of this size. Throws ContextError.
  void draw(unsigned framebuffer, int width_px, int height_px, const OverlayView& overlay);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts;
};

}  // namespace taut::renderer
