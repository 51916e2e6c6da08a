#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// The names that messages use for settings. A program passes the names that its users know.
struct PromiseNames {
  const char* bound = "max_stretch";
  const char* gusts = "gusts";
  const char* allow_exceeding = "allow_exceeding = true";
  const char* thickness = "thickness";
};

/// The smallest bound on stretch that is promised.
inline constexpr double smallest_promised_bound = 1e-4;

/// A frame ends, kept or refused, within so many times the work of the median frame.
inline constexpr double most_work = 30.0;

/// A frame that fails is halved, and its halves are, into no more parts than this.
inline constexpr int most_parts = 16;

/// Returns why `bounded` does not promise its bound in these surroundings, as a message for the user. Returns
/// nothing if it does promise it, and if the settings allow exceeding it.
std::optional<std::string> beyond_promise(const BoundedSettings& settings, const Surroundings& surroundings,
                                          const PromiseNames& names = {});

/// The thickest cloth that is kept apart, as a part of its mean edge. Neighbours are told apart by half of
/// their distance at rest at most, and get in each other's way as soon as the thickness is more. T-shirts of
/// 1028 and 5280 triangles take 2.4 and 1.5 times as long at 0.4 as at 1 mm, in a wind of 10 m/s, and never
/// end at 0.5.
inline constexpr double thickest_part_of_edge = 0.42;

/// Returns why `bounded` does not keep layers of this cloth apart, as a message for the user: it is thinner
/// than least_thickness_m or thicker than its mesh allows. Returns nothing if it does, and without contact.
std::optional<std::string> beyond_contact(const BoundedSettings& settings, const Garment& garment,
                                          const PromiseNames& names = {});

}  // namespace taut::sim
