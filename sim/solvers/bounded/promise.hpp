#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// Names of settings in messages. A program passes the names that its users know.
struct PromiseNames {
  const char* bound = "max_stretch";
  const char* gusts = "gusts";
  const char* allow_exceeding = "allow_exceeding = true";
  const char* thickness = "thickness";
};

/// Smallest promised bound on stretch.
inline constexpr double min_promised_bound = 1e-4;

/// Largest work of a frame, kept or refused, over the work of the median frame.
inline constexpr double max_work_ratio = 30.0;

/// Largest number of parts into which a failed frame is halved repeatedly.
inline constexpr int max_frame_parts = 16;

/// Returns a message for the user if `bounded` does not promise its bound in these surroundings. Returns nothing if it
/// does, or if the settings allow exceeding it.
std::optional<std::string> unpromised_bound_reason(const BoundedSettings& settings, const Surroundings& surroundings,
                                                   const PromiseNames& names = {});

/// Largest thickness for contact, as a fraction of the mean edge. Neighbours keep at most half of their rest distance,
/// and obstruct each other as soon as the thickness is more. In a wind of 10 m/s, T-shirts of 1028 and 5280 triangles
/// take 2.4 and 1.5 times as long at 0.4 as at 1 mm, and never end at 0.5.
inline constexpr double max_thickness_per_edge = 0.42;

/// Returns a message for the user if `bounded` does not keep layers of this cloth apart: it is thinner than
/// min_thickness_m or too thick for its mesh. Returns nothing if it does, or without contact.
std::optional<std::string> missing_contact_reason(const BoundedSettings& settings, const Garment& garment,
                                                  const PromiseNames& names = {});

}  // namespace taut::sim
