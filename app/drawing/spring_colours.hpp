#pragma once

#include <array>

#include "renderer/page/colour.hpp"
#include "sim/springs.hpp"

namespace taut::app {

/// The colour of one kind of spring. People with any kind of colour vision can tell them apart (Okabe and Ito
/// 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  constexpr std::array colours = {renderer::rgb(0x0072B2), renderer::rgb(0xE69F00), renderer::rgb(0xCC3377)};
  return colours[static_cast<std::size_t>(kind)];
}

/// Of a surface that lines are drawn over.
inline const renderer::Colour pale_outside = renderer::rgb(0xE8EDF2);
inline const renderer::Colour pale_inside = renderer::rgb(0xF3DFC0);

}  // namespace taut::app
