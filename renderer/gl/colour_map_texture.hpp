#pragma once

#include <optional>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/colour.hpp"

namespace taut::renderer {

/// A texture with one colour map per row, made at the first call of texture().
class ColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit ColourMapTexture(const GladGLContext& context) : gl_(&context) {}
  /// Returns the row of a map, counted from 0.
  static int row_of(ColourMap map) { return static_cast<int>(map); }
  /// Returns the texture. The first call binds it to the active texture unit.
  const Texture& texture();

 private:
  const GladGLContext* gl_;
  std::optional<Texture> made_;
};

}  // namespace taut::renderer
