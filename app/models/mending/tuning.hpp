#pragma once

#include <cstddef>

/// Tuned numbers of mending. The area means that of the whole model.
namespace taut::app::mending {

// Strays: pieces far from the rest (mending.cpp).

/// Largest fraction of the area that is outlying on each side of each axis. More leaves out straps, less keeps several
/// strays.
inline constexpr double max_outlying_fraction = 0.005;
/// Smallest distance of strays from the rest, over its size. More keeps buttons beside it, less leaves out tassels.
inline constexpr double min_stray_distance = 0.25;

// Rigid parts: closed and thick, such as a stand, a head or a body (mending.cpp).

/// Smallest volume of a rigid part, as a fraction of the volume of a ball of the same area. Two walls of one cloth have
/// less than 0.01, bodies 0.08 and more, thin stands 0.02. More simulates stands, less takes padded cloth for bodies.
inline constexpr double min_compactness = 0.015;
/// Largest length of the openings of a closed part, over the square root of its area. More takes gloves for bodies.
inline constexpr double max_holes_length = 0.3;
/// Largest such length of a part with an open end, such as a bust without a base. More takes hats for busts.
inline constexpr double max_end_length = 1.3;
/// Smallest fraction of a part with an open end that lies below cloth. Less takes gloves below sleeves for busts.
inline constexpr double min_below_cloth_fraction = 0.3;
/// Largest distance of cloth from a part below it, over the part's size. More takes sleeves beside it for its clothes.
inline constexpr double max_below_cloth_distance = 0.12;
/// Smallest area fraction of cloth; less is no garment. More simulates stands of small clothes.
inline constexpr double min_cloth_area_fraction = 0.1;
/// Smallest area fraction of a rigid part that lies on cloth. More lets stands be carried, less takes buttons for them.
inline constexpr double min_rigid_area_on_cloth = 0.02;
/// Smallest area fraction of a rigid part with an open end. Less takes socks and gloves for busts.
inline constexpr double min_rigid_area_with_end = 0.1;
/// Count of tested vertices of a part that may lie below cloth. More takes longer, fewer are less certain.
inline constexpr std::size_t max_places_below_cloth = 1000;

// Sides and trims (mending.cpp).

/// Smallest sum of an open surface's normals along the directions from its middle, over the sum of their lengths.
/// Collars and cuffs that are turned down point inwards. More turns these, less leaves garments inside out.
inline constexpr double min_outward_fraction = -0.5;
/// Largest area fraction of a trim. More sews panels on, less leaves belts loose.
inline constexpr double max_trim_area_fraction = 0.1;
/// Largest distance of a trim from the cloth that carries it, in m. More sews on what hangs beside it.
inline constexpr double max_trim_distance_m = 0.02;
/// Smallest count of stitches of a trim. Fewer let it turn.
inline constexpr std::size_t min_stitches = 3;
/// Area fraction for each further stitch: a belt needs more than a button. More lets belts hang down between stitches.
inline constexpr double stitch_area_fraction = 0.005;

// Models that are fitted (model_fitting.cpp).

/// Shortest edge of a fitted mesh, in thicknesses. The solver refuses cloth thicker than 0.42 of its edges. More makes
/// meshes of thick cloth coarser.
inline constexpr double min_edge_thicknesses = 3.0;
/// Crossing pairs above which a model is not simulated itself. More begins runs that break their promise, less refuses
/// models that move well where they do not cross.
inline constexpr std::size_t max_model_crossings = 3000;
/// Largest stretch of a model that follows, over the bound of the mesh. More moves it less, less smooths its folds.
inline constexpr double following_stretch_ratio = 2.0;
/// Largest stretch at which a model that follows is shown, in the 99th percentile of its edges. More shows models that
/// are torn, less shows the simulated mesh without their details.
inline constexpr double max_shown_stretch = 0.5;

}  // namespace taut::app::mending
