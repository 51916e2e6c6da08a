#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// Base colours on the triangles of a garment, as renderer::SurfaceView has them. No base colours: those of
/// the cloth. Its texture coordinates, if it has any, say where it is sewn too.
struct DrawnColours {
  std::vector<glm::vec2> corner_coordinates;
  std::vector<renderer::BaseColour> base_colours;
  std::vector<std::uint32_t> base_colour_of_triangle;
  std::vector<std::string> remarks = {};  ///< what of it is missing, one line each
  /// The model whose triangles these are, where it follows the garment; null: they are the garment's own.
  std::shared_ptr<const FollowingModel> following = {};
};

/// Returns what picture.texture asks for: an image over the cloth's colours, or the model's own colours if it
/// names images of them and the scene no outside colour of its own. Throws InputError if the image cannot be
/// read or the garment has no texture coordinates.
DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
