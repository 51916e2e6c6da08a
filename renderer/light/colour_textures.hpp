#pragma once

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// Base colour maps of a frame as layers of one array texture, in premultiplied linear light. Smaller maps are enlarged
/// to the size of the largest. It is uploaded if the set of maps changes.
class BaseColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit BaseColourMapTexture(const GladGLContext& context) : gl_(&context) {}

  /// Begins a frame.
  void clear() { maps_.clear(); }
  /// Returns the layer of a map, counted from 0. Calls no OpenGL.
  int add_layer(const BaseColourMap& map);
  /// Uploads the maps requested since clear(), unless they are unchanged.
  void upload();
  /// Returns the texture of the last upload(), which must have been called.
  const Texture& texture() const { return *made_; }

 private:
  const GladGLContext* gl_;
  std::vector<BaseColourMap> maps_;
  std::vector<BaseColourMap> uploaded_;
  std::optional<Texture> made_;
};

/// Texture with one colour map per row, made at the first call of texture().
class ColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit ColourMapTexture(const GladGLContext& context) : gl_(&context) {}
  /// Returns the row of a map, counted from 0.
  static int row_index(ColourMap map) { return static_cast<int>(map); }
  /// Returns the texture. The first call binds it to the active texture unit.
  const Texture& texture();

 private:
  const GladGLContext* gl_;
  std::optional<Texture> made_;
};

}  // namespace taut::renderer
