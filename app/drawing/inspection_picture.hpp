#pragma once

#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspection.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A page with the garment as it was understood, from the front and from behind: its springs by kind, what
/// holds it, its borders, edges where more than two triangles meet or neighbours disagree about the outside,
/// and places where vertices of the file were joined; with a legend, its counts and a bar of known length.
/// `backend` as in renderer::create_context. Throws renderer::ContextError.
renderer::Image draw_inspection(const Inspection& inspection, const LoadedGarment& loaded,
                                const DrawnScene& scene, const std::string& backend);

}  // namespace taut::app
