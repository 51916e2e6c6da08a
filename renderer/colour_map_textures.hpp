#pragma once

#include <map>

#include "renderer/colour.hpp"
#include "renderer/gl_objects.hpp"

namespace taut::renderer {

/// Colour maps as textures of one row, made when first asked for.
class ColourMapTextures {
 public:
  explicit ColourMapTextures(const GladGLContext& context) : gl(&context) {}
  /// May change what is bound to the active texture unit.
  const Texture& get(ColourMap map);

 private:
  const GladGLContext* gl;
  std::map<ColourMap, Texture> textures;
};

}  // namespace taut::renderer
