#pragma once

#include "renderer/page/colour.hpp"
#include "sim/springs.hpp"

namespace taut::app {

/// Told apart by colour-blind eyes as well (Okabe and Ito 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  switch (kind) {
    case sim::SpringKind::structural:
      return renderer::rgb(0x0072B2);
    case sim::SpringKind::shear:
      return renderer::rgb(0xE69F00);
    case sim::SpringKind::flexural:
      break;
  }
  return renderer::rgb(0xCC3377);
}

}  // namespace taut::app
