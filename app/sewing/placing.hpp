#pragma once

#include <vector>

#include "app/scene/scene.hpp"
#include "app/sewing/cutting.hpp"

namespace taut::app {

/// Places the pieces about the body of the scene that is dressed, which begins thin, its arms where sleeves are, or level.
/// Their pattern places them about a body that is about as large, with its feet or its chest at the origin: all go up or
/// down together, so that shoulder seams lie above its shoulders, or the upper border where it is as wide. Pieces that
/// cross it or each other go outwards. Requires that the bodies are loaded (load_bodies()). Returns what was done, for
/// people. Throws InputError if nobody is dressed or cannot be told up from down.
std::vector<std::string> place_pieces(const SewingPattern& pattern, CutPieces& pieces, Scene& scene);

/// How many frames after 0 s a body takes to its own shape, where parts of it that are near each other had stayed back to
/// leave room for cloth.
inline constexpr int frames_to_own_shape = 30;

/// A time at which the body that is dressed is thin, in s.
double thin_time_s(const Scene& scene);

}  // namespace taut::app
