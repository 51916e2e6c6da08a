#pragma once

#include "app/bodies/dressing.hpp"

namespace taut::app {

/// Puts the garment about the body that is to be dressed, the first if there are several, and returns what
/// was done, for people. A garment that lies about the body and crosses nothing there when the body is thin
/// stays as it is, and so does one that begins in a shape of its own (garment.start). Others are moved, and
/// turned about the vertical, so that the neck opening lies about the neck, or a waist at the waist; and the
/// arms begin in its sleeves where it would cross them, which changes the body's frames. Garments are moved
/// at rest: nothing is stretched. Requires a scene whose bodies are loaded.
std::vector<std::string> put_on(LoadedGarment& loaded, Scene& scene);

/// Puts the garment where the run begins: on the hanger that it was loaded with, and about the body that is
/// to be dressed. Returns what put_on() does.
std::vector<std::string> put_where_it_begins(LoadedGarment& loaded, Scene& scene);

/// The body that put_on() dresses.
struct Dressed {
  const Wearer* wearer = nullptr;  ///< null: no body is dressed
  std::size_t body = 0;            ///< its place among the bodies
};

/// Returns the first body that is dressed.
Dressed dressed_body(const Scene& scene);

/// Returns where the body that is dressed looks when the run begins, level and of length 1: z if its joints
/// do not say.
sim::Vec3 front_of_dressed(const Scene& scene);

}  // namespace taut::app
