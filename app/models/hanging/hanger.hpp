#pragma once

#include "app/models/hanging/garment_parts.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

struct LoadedGarment;

/// Name of the left bar. The hook goes up from its start.
inline constexpr const char* hanger_left = "hanger, left";

/// Returns a hanger for a part that is modelled as worn: bars from the middle to both sides, a little below its
/// shoulders and sloping like them, that do not touch it. Empty if there is space only for bars shorter than
/// `min_length_ratio` times the longest, or if the neckline is wider than `max_neckline` times the bars.
std::vector<sim::Body> hanger_for(const sim::Mesh& mesh, const GarmentPart& part, double min_length_ratio,
                                  double max_neckline);

/// Returns a hanger for the largest part of a garment. Throws InputError if there is no space for one.
std::vector<sim::Body> make_hanger(const sim::Mesh& mesh);

/// Returns a description for people: "it hangs on a hanger that is 40 cm wide". Requires a hanger.
std::string describe(const std::vector<sim::Body>& hanger);

/// Returns whether the scene asks for a hanger: pins.at = "hanger".
bool asks_for_hanger(const Scene& scene);

/// Adds the hanger that a garment was loaded with to the scene and to its loaded bodies. The scene then names its bars
/// and all its pins, so that it hangs on the same hanger, and on no second one, when it is read again. Does nothing
/// without a hanger.
void put_on_hanger(const LoadedGarment& loaded, Scene& scene, std::vector<sim::Body>& bodies);

/// Removes the hanger of another garment from the scene and its loaded bodies, with the pins that were named with it.
void take_off_hanger(Scene& scene, std::vector<sim::Body>& bodies);

/// Returns the vertices around the neck of a garment with a hood, just above the level at which it widens into
/// shoulders. `across` is the axis of its width, 0 or 2. Empty if there is no hood: a hood is high, and open over most
/// of its height for a face.
std::vector<sim::Index> neck_below_hood(const sim::Mesh& mesh, const GarmentPart& part, int across);

}  // namespace taut::app
