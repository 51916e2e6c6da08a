#pragma once

#include "app/garments/dressing/dressing.hpp"

namespace taut::app {

/// Puts the garment about the body that is to be dressed, the first of several, and returns a report for people.
/// A garment stays if it lies about the body and does not cross the thin body, or if it begins in a shape of its own
/// (garment.start). Other garments are moved and turned about the vertical, so that the neck opening lies about the
/// neck or the waist at the waist. The arms begin in the sleeves where they would cross them, which changes the body's
/// frames. Garments are moved at rest: nothing is stretched.
std::vector<std::string> put_on(LoadedGarment& loaded, const Scene& scene, LoadedBodies& bodies);

/// Puts the garment where the run begins: on its hanger, and about the body that is to be dressed. Returns what
/// put_on() returns.
std::vector<std::string> put_where_it_begins(LoadedGarment& loaded, Scene& scene, LoadedBodies& bodies);

/// The body that put_on() dresses.
struct Dressed {
  const Wearer* wearer = nullptr;  ///< null if no body is dressed
  std::size_t body = 0;            ///< index of the body
};

Dressed dressed_body(const LoadedBodies& bodies);

/// Returns how much higher the body is at the start of the run than in its stored pose, in m.
double compute_lift(const sim::Body& body, const Wearer& wearer);

/// Returns whether a garment is worn at the waist of this body, which is that much higher than in its stored pose. What
/// ends above the arms, as a poncho does, goes around the neck.
bool is_worn_at_waist(const GarmentMarks& marks, const BodyMeasures& measures, double lift_m);

/// Returns the direction in which the dressed body looks when the run begins, level and of length 1. It is z if the
/// joints are not known.
sim::Vec3 front_of_dressed(const LoadedBodies& bodies);

}  // namespace taut::app
