#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bodies/placed_frames.hpp"
#include "app/library/taut.h"
#include "app/scene/scene.hpp"

namespace taut::library {

/// A mesh of a caller that is a body.
struct LentBody {
  app::FileVertexPlaces places;
  std::size_t vertices = 0;                             ///< that the caller's mesh has
  std::optional<std::vector<sim::Vec3>> target_m = {};  ///< of the next frame, per vertex of the body
};

/// A body of a caller as a scene has it.
struct GivenBody {
  sim::Body body;
  app::BodySource source = {};
  std::shared_ptr<const app::Wearer> wearer = {};  ///< null: it is not dressed
  std::optional<LentBody> lent = {};               ///< empty: a plane
  std::vector<std::string> remarks = {};           ///< what was guessed and repaired
};

/// Takes a body, for a scene with these frames. Throws ArgumentError, and InputError on a mesh that is not
/// closed.
GivenBody take_body(const TautBody* body, const app::Scene& scene);

/// Adds it to the bodies of the scene and returns its number.
std::size_t put_in(const GivenBody& given, app::Scene& scene);

}  // namespace taut::library
