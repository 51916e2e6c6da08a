#pragma once

#include <cairo.h>

#include <memory>

#include "renderer/page/image.hpp"

namespace taut::renderer {

/// Owns a Cairo surface.
using SurfaceHandle = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

/// Takes ownership of a new surface. Throws std::runtime_error with Cairo's reason when it is in an error
/// state.
SurfaceHandle checked(cairo_surface_t* made);

/// Returns a Cairo image surface with the pixels of an RGB or RGBA image.
SurfaceHandle to_cairo(const Image& image);

/// Returns the pixels of a Cairo image surface as RGB.
Image from_cairo(cairo_surface_t* surface);

}  // namespace taut::renderer
