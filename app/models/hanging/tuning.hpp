#pragma once

#include <cstddef>

/// Tuned numbers of hanging. Height, width and size mean a part's; its width is the larger of both level extents.
namespace taut::app::hanging {

// Openings: borders of a part (garment_parts.cpp).

/// Largest gap of an open seam, over the longer edge at it. More joins borders of slits, less ends openings at seams.
inline constexpr double max_seam_gap_ratio = 0.25;
/// Largest cosine between the outward directions of edges at a seam. More joins borders at an angle.
inline constexpr double max_opposite_border_cosine = -0.5;
/// Smallest length of an opening, over the size. More misses necklines, less takes buttonholes for openings.
inline constexpr double min_opening_length_ratio = 0.2;
/// Smallest mean height of a top opening above the lowest point, as a fraction. Less hangs linings by their ends.
inline constexpr double min_top_opening_height = 0.6;
/// Largest height of a top opening from its lowest to its highest point, as a fraction. More hangs jackets by fronts.
inline constexpr double max_top_opening_steepness = 0.4;
/// Largest distance, in widths, by which the centre of mass is beside pins that carry it. More hangs parts by one side.
inline constexpr double max_off_balance_across = 0.05;
/// Largest such distance towards front and back, where a garment leans and turns a little. More hangs hoods by their
/// faces.
inline constexpr double max_off_balance_in_depth = 0.25;
/// Smallest width of an opening that carries a part, in widths. Less hangs garments by holes in a collar.
inline constexpr double min_opening_width = 0.1;
/// Largest distance of an armhole's inner end from the middle, in widths. More takes cuffs for armholes.
inline constexpr double max_armhole_offset = 0.4;
/// Largest difference in height between two openings of a pair, as a fraction. More pairs an armhole with a cuff.
inline constexpr double max_pair_height_difference = 0.1;
/// Largest distance of a neck, a waist or a hem from the middle, in widths. More takes cuffs for hems.
inline constexpr double max_middle_offset = 0.15;

// Pins: where a part is held (hanging.cpp, hanger.cpp, landmarks.cpp).

/// Height of the band that is pinned, as a fraction of the height. More holds shoulders rigid, less holds single
/// points.
inline constexpr double pinned_band_fraction = 0.03;
/// Largest thickness of a flat part, over its size. More takes garments that were laid down for flat pieces.
inline constexpr double max_flat_part_thickness = 0.02;
/// Reach of pinned shoulders to each side of the centre of mass, in widths. More pins sleeves.
inline constexpr double max_pinned_shoulder_offset = 0.25;
/// Smallest height of a neckline between straps, as a fraction. More hangs dresses by necklines below their straps.
inline constexpr double min_strap_neckline_depth = 0.1;
/// Count of parts that are described one by one.
inline constexpr std::size_t max_described_parts = 12;
/// Largest distance of a landmark from its vertex, in m. Files have about six digits. More takes a neighbour for it.
inline constexpr double max_landmark_distance_m = 1e-5;

// Hoods (hanger.cpp). Fractions refer to a part's height.

/// Count of levels at which the width of a part is measured. More takes longer, fewer miss necks.
inline constexpr int hood_levels = 50;
/// Count of levels over which shoulders slope. More takes skirts for shoulders, fewer miss slanted ones.
inline constexpr int shoulder_levels = 4;
/// Smallest ratio of the widths below and above this slope. More misses narrow shoulders.
inline constexpr double min_widening_ratio = 1.5;
/// Smallest height of a hood. Less takes collars for hoods.
inline constexpr double min_hood_height = 0.15;
/// Largest height of a hood. More takes bodices above skirts for hoods.
inline constexpr double max_hood_height = 0.5;
/// Smallest height of the opening for the face, over the hood's. Less takes collars for hoods.
inline constexpr double min_face_height = 0.5;
/// Largest extent of a face's border from front to back, over the hood's at its height. More takes straps for hoods.
inline constexpr double max_face_depth_ratio = 0.6;

// Hangers (hanger.cpp). Lengths are in bars: a bar is half of a hanger.

/// Length of a bar for grown-ups, in m. More leaves less space in sleeves.
inline constexpr double max_bar_length_m = 0.2;
/// Largest length of a bar in widths. More reaches into sleeves.
inline constexpr double max_bar_width_ratio = 0.45;
/// Radius of a bar. More needs more space, less lets cloth slide.
inline constexpr double bar_radius_ratio = 0.04;
/// Clearance between bars and cloth at the start. More lets the garment fall farther.
inline constexpr double bar_clearance_ratio = 0.02;
/// Largest slope of shoulders. More hangs garments that slide off.
inline constexpr double max_shoulder_slope = 0.5;
/// Offset from which shoulders are measured; a neckline or a collar may be within. More misses shoulders.
inline constexpr double min_shoulder_offset = 0.4;
/// Depth of a neckline below the ends of the bars. More lets wide necklines slide.
inline constexpr double max_neckline_depth = 0.05;
/// Factor by which bars are shortened until they fit. More takes longer.
inline constexpr double bar_shortening = 0.93;
/// Smallest length of a bar that the scene asks for, over the longest. Less hangs garments by their collars.
inline constexpr double min_asked_bar_ratio = 0.5;
/// Smallest length of a bar that is chosen, over the longest. Less lets necklines slip over them.
inline constexpr double min_chosen_bar_ratio = 0.65;
/// Widest neckline of a garment whose hanger is chosen. More lets it slide over the ends.
inline constexpr double max_chosen_neckline_ratio = 0.6;
/// Largest lowering of bars below the shoulders. More lets the garment fall farther.
inline constexpr double max_bar_lowering = 0.5;
/// Step of this lowering. More lets the garment fall farther, less takes longer.
inline constexpr double bar_lowering_step = 0.02;
/// Friction of wood. Less lets garments slide off.
inline constexpr double bar_friction = 0.5;

// Marks that place a garment on a body (garment_measures.cpp).

/// Smallest extent of a front that is open from neck to hem, as a fraction of the height. Less takes slits for it.
inline constexpr double min_open_front_fraction = 0.7;
/// Upper fraction of the height in which the border of an open front is around the neck. More takes lapels too.
inline constexpr double neck_height_fraction = 0.08;
/// Largest unevenness of the edge of a stand collar, in m. More takes necklines for collars.
inline constexpr double max_collar_unevenness_m = 0.03;
/// Largest height of a stand collar, in m. More takes bodices for collars.
inline constexpr double max_collar_m = 0.12;
/// Step of the search down from a collar's edge, in m. Less takes longer.
inline constexpr double collar_step_m = 0.005;
/// Ratio of the girth where shoulders begin to the girth of the collar above. More finds shoulders too low.
inline constexpr double min_shoulder_girth_ratio = 1.2;
/// Smallest depth, over its width, by which a neckline is lower in front. Less trusts uneven necklines.
inline constexpr double min_front_dip = 0.03;
/// Count of levels at which the girth of a garment is measured. More takes longer, fewer place armholes less exactly.
inline constexpr int tube_levels = 200;
/// Largest count of levels in a row that do not go all around, as at a crack. More ignores open fronts.
inline constexpr std::size_t max_missed_levels = 30;
/// Ratio of girths, one level apart, where sleeves begin. More takes sleeves for the trunk.
inline constexpr double min_sleeve_girth_ratio = 1.1;
/// Smallest girth of a leg, over the largest of its level. Less takes sleeves for legs.
inline constexpr double min_leg_girth_ratio = 0.5;
/// Smallest offset of a leg's middle from the garment's, over the leg's width. Less takes a trunk for a leg.
inline constexpr double min_leg_offset = 0.25;

// Unit (placement.cpp): how likely a size is, by its logarithm.

/// Smallest size of a garment, in m. More refuses gloves, less takes centimetres for metres.
inline constexpr double min_garment_m = 0.1;
/// Largest size of a garment, in m. Less refuses trains, more takes feet for metres.
inline constexpr double max_garment_m = 2.5;
/// Fraction of files with garments side by side, of which only the largest part has a person's size.
inline constexpr double side_by_side_fraction = 0.3;
/// Likelihood, over the first unit's, from which a second is said. Less says it of all.
inline constexpr double min_second_likelihood = 0.1;
/// Smallest area fraction of a part whose openings show what the garment is: one of a pair of socks, or a wall of two.
inline constexpr double min_telling_area = 0.4;
/// Median size of garments of grown-ups, in m. More takes decimetres for feet.
inline constexpr double median_size_m = 0.85;
/// Standard deviation of its logarithm. More trusts the usual units more than sizes.
inline constexpr double size_spread = 0.38;
/// Median girth of the narrower opening of skirts and ponchos, in m.
inline constexpr double median_waist_m = 0.72;
/// Standard deviation of its logarithm.
inline constexpr double waist_spread = 0.4;
/// Median girth of the narrowest opening of shirts, dresses and trousers, in m.
inline constexpr double median_cuff_m = 0.36;
/// Standard deviation of its logarithm.
inline constexpr double cuff_spread = 0.3;
/// Median square root of the area of hats, socks and gloves, in m, which shows more than their size.
inline constexpr double median_bag_m = 0.34;
/// Standard deviation of its logarithm.
inline constexpr double bag_spread = 0.28;
/// Smallest size for which a file's own unit is accepted, in m: a glove. Less accepts millimetres for metres.
inline constexpr double min_believed_m = 0.02;
/// Largest such size, in m: a tent. More accepts metres for centimetres.
inline constexpr double max_believed_m = 20.0;
/// Distance from the origin above which a model is moved, in sizes. There single precision is worse than 0.1 mm.
inline constexpr double max_origin_distance_ratio = 1000.0;

// Up (placement.cpp).

/// Largest height of a level opening, over its width, or over the height of a bag. More takes fronts for hems.
inline constexpr double max_level_steepness = 0.4;
/// Largest area of a hat, over the square of its opening's length. More takes socks for hats.
inline constexpr double max_hat_area = 0.7;
/// Smallest ratio of the width and the length of a hat's opening. Less takes tote bags for hats.
inline constexpr double min_hat_roundness = 0.5;
/// Smallest such area of a sock. Less takes hats for socks.
inline constexpr double min_sock_area = 1.0;
/// Smallest distance of a sock's centre from the line through its opening, in sizes. Less takes gloves for socks.
inline constexpr double min_sock_bend = 0.05;
/// Smallest ratio of the lengths along z and y of a model with z up that shows nothing else. Less turns skirts over.
inline constexpr double min_z_ratio = 2.0;
/// Smallest area fraction that openings at the top carry. Less hangs all by a part.
inline constexpr double min_carried_area_fraction = 0.5;
/// Smallest excess, over another axis, of the fraction of levels that the cloth goes around. Less trusts folds.
inline constexpr double min_around_excess = 0.3;
/// Smallest length of a section that goes around, in longer sides of its box. Less takes cloth along it for a tube.
inline constexpr double min_around_length_ratio = 1.5;
/// Largest count of directions of 64 that a section around its middle misses. More takes open fronts for tubes.
inline constexpr int max_slit_directions = 6;
/// Smallest difference of the depths of view from above and below, as a fraction of the height. More leaves models on
/// their heads, less turns others.
inline constexpr double min_view_difference = 0.01;
/// Smallest such difference where y is up, as in most files.
inline constexpr double min_view_difference_of_y = 0.03;
/// Width of the view from above and below, as a fraction of the model's. More sees sleeves, less only necklines.
inline constexpr double seen_width = 0.5;
/// Depth of this view, as a fraction of the same fraction of the model's depth. More sees seams of fronts.
inline constexpr double seen_depth = 0.4;
/// Count of views along each axis. More takes longer, fewer miss straps.
inline constexpr int views_across = 24;
/// Largest height of a model that lies on its back, over its size. More lays capes down.
inline constexpr double max_lying_height = 0.1;
/// Count of levels of a model. More takes longer.
inline constexpr int section_levels = 11;
/// Smallest excess of levels with two legs in one half. Less takes sleeves for legs.
inline constexpr int min_leg_levels = 3;
/// Largest reach of a leg over the middle between both, over its width. More takes skirts for legs.
inline constexpr double max_leg_overlap = 0.25;
/// Smallest height of trousers, over their larger size across. Less takes sleeves for legs.
inline constexpr double min_leg_height = 0.7;
/// Smallest ratio of the lengths of a hem and the opening above. Less turns tubes over.
inline constexpr double min_hem_ratio = 1.05;
/// Smallest distance of both, as a fraction of the height.
inline constexpr double min_opening_distance = 0.25;
/// Largest ratio of the girths of a garment at its narrower and its wider end. More turns tubes over.
inline constexpr double max_taper = 0.8;

// Up by hanging (hanging.cpp).

/// Count of frames of 1/60 s for which a model hangs. More takes longer.
inline constexpr int trial_frames = 60;
/// Largest ratio of the sagging of the better way up to the sagging of the other. More trusts small differences.
inline constexpr double max_sagging_ratio = 0.7;
/// Largest thickness of a flat pattern, over its length. More turns garments that lie.
inline constexpr double max_pattern_thickness = 0.001;
/// Count of levels at which its width is measured.
inline constexpr int flat_levels = 12;
/// Height of the middle of its area above which it has its wider end at the top, as a fraction.
inline constexpr double max_middle_height = 0.52;
/// Ratio of widths one level apart, from sleeves to the trunk. More takes flares for sleeves.
inline constexpr double max_narrowing = 0.65;

}  // namespace taut::app::hanging
