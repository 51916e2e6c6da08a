#pragma once

#include "app/models/garment_parts.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

struct LoadedGarment;

/// The name of the bar to its left, from whose start its hook goes up.
inline constexpr const char* hanger_left = "hanger, left";

/// Returns a hanger for a part that is modelled as worn: bars from the middle to both sides, a little below
/// its shoulders and sloping like them, that do not touch it. Empty if there is no room for one.
std::vector<sim::Body> hanger_for(const sim::Mesh& mesh, const GarmentPart& part);

/// Returns a hanger for the largest part of a garment. Throws InputError that says so if there is no room.
std::vector<sim::Body> make_hanger(const sim::Mesh& mesh);

/// Returns what it is, for people: "it hangs on a hanger that is 40 cm wide". Requires one.
std::string describe(const std::vector<sim::Body>& hanger);

/// Returns whether the scene asks for a hanger: pins.at = "hanger".
bool asks_for_hanger(const Scene& scene);

/// Puts the hanger that a garment was loaded with among the bodies of the scene, which then names its bars
/// and all its pins: read again, it hangs on the same hanger and on no second one. Without a hanger it does
/// nothing.
void put_on_hanger(const LoadedGarment& loaded, Scene& scene);

/// Removes a hanger that another garment was put on, with the pins that were named with it.
void take_off_hanger(Scene& scene);

/// Returns the vertices around the neck of a garment with a hood: those just above the level at which it
/// widens into shoulders. `across` is the axis of its width, 0 or 2. Empty if there is no hood: what is above
/// that level has to be high, and open over most of its height, as at a face.
std::vector<sim::Index> neck_below_hood(const sim::Mesh& mesh, const GarmentPart& part, int across);

}  // namespace taut::app
