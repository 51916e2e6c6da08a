#pragma once

#include <optional>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/colour.hpp"

namespace taut::renderer {

/// All colour maps as the rows of one texture, made when first asked for.
class ColourMapTexture {
 public:
  explicit ColourMapTexture(const GladGLContext& context) : gl(&context) {}
  static int row_of(ColourMap map) { return static_cast<int>(map); }
  /// May change what is bound to the active texture unit.
  const Texture& texture();

 private:
  const GladGLContext* gl;
  std::optional<Texture> made;
};

}  // namespace taut::renderer
