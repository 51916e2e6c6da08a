#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Base colours of a garment's triangles, as in renderer::SurfaceView; empty: the cloth's colours. Texture coordinates
/// also define its seams.
struct DrawnColours {
  std::vector<glm::vec2> corner_coordinates;
  std::vector<renderer::BaseColour> base_colours;
  std::vector<std::uint32_t> base_colour_of_triangle;
  std::vector<std::string> remarks = {};  ///< missing colours or images, a line each
  /// Model that follows the garment and owns these triangles; null: the garment's own triangles.
  std::shared_ptr<const FollowingModel> following = {};
};

/// Returns the colours for picture.texture. An image covers the cloth's colours. By default the model's own colours are
/// used if it has images and the scene sets no outside colour. Throws InputError if the image cannot be read or the
/// garment has no texture coordinates.
DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
