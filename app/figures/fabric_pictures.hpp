#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/figures/experiments/recording.hpp"
#include "app/figures/pictures.hpp"
#include "app/scene/fabric.hpp"

namespace taut::app {

/// Returns `scene`, named in its title, made of a fabric of this name or file. Throws UsageError if there is
/// none.
DrawnScene made_of(DrawnScene scene, const std::string& fabric);

/// Pictures of all last moments with the captions below.
Drawing sheet_of_last(std::span<const Recording> recordings, std::span<const Caption> captions,
                      const PictureSize& size, const SheetStyle& style, bool has_floor,
                      LazyOffscreenRenderer& offscreen);

/// One scene made of several fabrics, at the end of each recording. The scenes' titles stand below.
Drawing draw_fabrics(std::span<const Recording> recordings, LazyOffscreenRenderer& offscreen);

}  // namespace taut::app
