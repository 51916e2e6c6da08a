#pragma once

#include <cairo.h>

#include <memory>

#include "renderer/page/image.hpp"

namespace taut::renderer {

using SurfaceHandle = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

/// Takes over a surface just made. Throws std::runtime_error with Cairo's reason where it could not be.
SurfaceHandle checked(cairo_surface_t* made);

/// The same picture as Cairo keeps it.
SurfaceHandle to_cairo(const Image& image);

/// The pixels of an image surface as RGB.
Image from_cairo(cairo_surface_t* surface);

}  // namespace taut::renderer
