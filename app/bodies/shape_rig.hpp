#pragma once

#include "app/bodies/body_girths.hpp"
#include "app/models/rig.hpp"

namespace taut::app {

/// Returns joints for a body that has none, such as a scan: from the hips to the neck and the head, to the
/// hands and to the feet, where its shape says that they are; each vertex follows the bone that is nearest,
/// along the trunk none of the arms. Good enough to grow from, not to be moved by. Positions are in m, with y
/// up, as they were measured. Empty if the shape is not that of someone with a neck and two arms.
std::optional<Rig> rig_by_shape(const Surface& body, const BodyMeasures& measures);

/// Measures a body with its arms, whose joints are those that its shape shows where it has none.
BodyMeasures measures_of(const Surface& body, const JointPlaces& joints);

}  // namespace taut::app
