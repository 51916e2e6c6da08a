#pragma once

#include <cstddef>

/// Numbers of sewing. Limits of the file format are in pattern.cpp.
namespace taut::app::sewing {

// Cutting: triangles of panels (cutting.cpp, filling.cpp).

/// Smallest edge length, in m. Less takes longer, more makes small patterns coarse.
inline constexpr double finest_edge_m = 0.006;
/// Largest edge length, in m. More lets bodies show through, less refuses small counts of triangles.
inline constexpr double coarsest_edge_m = 0.06;
/// Largest length that a step may cut off a curve, in m. More shortens armholes, less makes borders finer than panels.
inline constexpr double max_shortening_m = 4e-4;
/// Distance between panels in texture coordinates, in m. Less lets them touch in pictures, more wastes an image.
inline constexpr double between_panels_m = 0.05;
/// Count of meshes tried for an exact number of triangles. More takes longer, less gives up.
inline constexpr int max_meshes = 40;
/// Growth factor of the edge length from mesh to mesh. More makes larger steps, less tries similar meshes.
inline constexpr double spacing_growth = 1.002;
/// Largest number of added points, as a fraction of the triangles. More makes one panel finer than the others.
inline constexpr double max_point_growth = 0.02;
/// Irregularity of such meshes, as a fraction of the edge length. More makes thin triangles, less fewer counts.
inline constexpr double exact_jitter = 0.7;
/// Fraction by which their unsewn borders may be shorter than drafted. More cuts off curves, less leaves fewer counts.
inline constexpr double exact_shortened = 0.005;
/// Distance of inner points from the outline, as a fraction of the edge length. Less makes thin triangles at borders,
/// more large ones.
inline constexpr double clearance_fraction = 0.6;
/// Rounds of smoothing of the inner points. More changes little, less leaves uneven triangles.
inline constexpr int smoothing_rounds = 8;

// Heights: where a pattern lies about its body (heights.cpp).

/// Smallest height of a pattern's middle, in m, if its origin is at the feet. Less takes hoods about the chest for such
/// patterns, more misses shorts.
inline constexpr double min_middle_m = 0.3;
/// Height of the side of the neck above the chest, in m, which is at the origin of other patterns. More puts them
/// lower.
inline constexpr double neck_over_chest_m = 0.29;
/// Height of shoulder seams above the thin body, in m. Less lets shoulders cross it, more lets sleeves pull at them.
inline constexpr double above_shoulders_m = 0.06;
/// Distance of a bone below a shoulder seam, along x, in m. More looks beside the seam, less misses thin bones.
inline constexpr double beside_seam_m = 0.015;
/// Smallest ratio of the sideways and the upward extent of a shoulder seam. Less takes side seams for shoulders.
inline constexpr double shoulder_slope = 0.9;
/// Longest shoulder seam that does not begin near the neck, in m. More takes seams of sleeves for shoulders.
inline constexpr double max_shoulder_m = 0.3;
/// Depth below the highest shoulder seam, or below the top, that is near it, in m. More takes lower seams too.
inline constexpr double near_top_m = 0.2;

// Limbs: sleeves, arms and legs (limbs.cpp).

/// Smallest offset of a sleeve's panel, as a multiple of the joint's. Less takes side panels for sleeves.
inline constexpr double beside_trunk = 0.6;
/// Largest depth of a sleeve's top below the shoulder, in m. More takes pockets for sleeves.
inline constexpr double below_shoulder_m = 0.2;
/// Largest height of a sleeve panel's middle above the shoulder, in m. More takes hoods for sleeves.
inline constexpr double over_shoulder_m = 0.12;
/// Slope of the arms, also below a seam over them. More pulls sleeves down at the shoulders, less lets arms cross
/// seams.
inline constexpr double arms_down = 0.2;
/// Distance from the shoulder at which a seam is over the arm, in m. Less lowers arms below wide shoulders.
inline constexpr double over_arm_m = 0.1;
/// Height above the lowest point within which panels end at the hem, in m. More takes short linings for legs.
inline constexpr double near_hem_m = 0.05;
/// Smallest offset of the middle of a panel of one leg, in panel widths. Less takes the halves of a skirt for legs.
inline constexpr double min_leg_offset_widths = 0.15;

// Placing: pieces come apart and near the thin body (placing.cpp, cutting.cpp).

/// Step by which pieces move, in m. More leaves gaps, less takes longer.
inline constexpr double step_m = 0.01;
/// Distance of pieces that are drawn in, in m. Less lets them touch, more gives threads more to draw.
inline constexpr double clear_m = 0.03;
/// Smallest cosine of directions that count as equal. Less lets pieces pass each other, more moves neighbours apart.
inline constexpr double same_way = 0.8;
/// Smallest cosine of directions in which a layer is over another. Less moves layers beside each other outwards.
inline constexpr double nearly_same_way = 0.5;
/// Distance of an outer layer from an inner one, in m. Less lets layers cross, more gives threads more to draw.
inline constexpr double over_m = 0.04;
/// Lift of an outer layer with shoulders, in m. Less lets shoulders of layers cross.
inline constexpr double layer_lift_m = 0.03;
/// Smallest horizontal fraction of the normal of a piece that does not lie flat. More lays slanted pieces on top.
inline constexpr double min_level = 0.1;
/// Count of steps in which pieces come apart. More takes longer, less leaves crossings.
inline constexpr int max_pushes = 80;
/// Smallest size of clothes, in m. More refuses mittens, less accepts metres for centimetres.
inline constexpr double min_clothes_m = 0.04;
/// Largest size of clothes, in m. Less refuses trains, more accepts millimetres for centimetres.
inline constexpr double max_clothes_m = 3.5;
/// Depth of the bow of panels without a body, as a fraction of the pattern's size. Threads within a plane bend no cloth
/// out of it. More depth stretches panels beyond the bound.
inline constexpr double bow_fraction = 0.02;

// Closing: threads draw seams together, and vertices that have met are joined (closing.cpp).

/// Pull of all threads of a panel over its mass, in m/s^2. More crumples cloth, less takes longer.
inline constexpr double pull_m_per_s2 = 15.0;
/// Pull of sewn layers towards the body, in m/s^2. More crumples them, less leaves them in the way of outer ones.
inline constexpr double inwards_m_per_s2 = 10.0;
/// Distance from the body within which this pull decreases, in m. Less lets layers bounce.
inline constexpr double inwards_from_m = 0.05;
/// Distance within which threads pull less, in m. Less lets seams bounce, more leaves them open.
inline constexpr double slack_m = 0.001;
/// Growth factor of the pull after a pass that closed too little. More crumples cloth, less takes longer.
inline constexpr double strength_growth = 1.4;
/// Fraction of the open part that a pass has to close. More strengthens the pull earlier.
inline constexpr double min_pass_fraction = 0.05;
/// Largest pull, as a multiple of the first. More crumples cloth, less leaves thick seams open.
inline constexpr double max_strength = 30.0;
/// Drag of the air during closing, in 1/s. More takes longer, less lets panels swing.
inline constexpr double closing_drag_per_s = 10.0;
/// Upper limit of the cloth's thickness during closing, in m. More keeps borders apart, less lets layers lie closer
/// than they can rest.
inline constexpr double thickest_m = 3e-4;
/// Upper limit of the bending rigidity during closing, in N m. More resists threads, less crumples.
inline constexpr double max_bending_rigidity_n_m = 2e-6;
/// Distance within which vertices are joined, as a fraction of the edge length. More stretches cloth at joins, less
/// leaves seams open.
inline constexpr double reach_fraction = 0.1;
/// Count of frames before the first try to join. Less tries in vain.
inline constexpr int first_join = 12;
/// Count of frames between tries. Less tries in vain, more takes longer.
inline constexpr int frames_between_joins = 4;
/// Limit of these frames after tries that joined nothing. The pull grows with each try. More takes longer, less
/// crumples cloth before it has come near.
inline constexpr int max_frames_between_joins = 16;
/// Count of frames for the seams that carry the garment. Less closes sides before shoulders, more takes longer.
inline constexpr int max_frames_for_first = 60;
/// Budget of time steps for a layer, on average. More takes longer, less gives up.
inline constexpr int max_steps = 4000;
/// Distance of the body from a gap within which it is said to be in the way, in m. More blames it wrongly.
inline constexpr double blocking_distance_m = 0.03;

// Rest: the garment is worn, or lies free (sewing.cpp).

/// Largest number of time steps in a frame. More helps no garment that is too small, which then takes minutes.
inline constexpr int max_substeps = 250;
/// First drag of the thick air, in 1/s. The rest position does not depend on it, but the time to reach rest does.
inline constexpr double resting_drag_per_s = 6.0;
/// Growth factor of this drag. More stops cloth on its way, less takes longer.
inline constexpr double drag_growth_factor = 1.5;
/// Largest drag, in 1/s. More stops cloth on its way, less takes longer.
inline constexpr double thickest_per_s = 60.0;
/// Count of frames after which the drag grows. Less stops cloth on its way, more takes longer.
inline constexpr int frames_to_thicker = 10;
/// Largest mean speed at rest, in m/s. In the thickest air the drag then bears a hundredth of the cloth's weight. Less
/// never rests, more rests on the way.
inline constexpr double resting_m_per_s = 1.5e-3;
/// Budget of work until the garment rests, in sweeps, which searches count as too. Cloth that is nearly too small would
/// take minutes.
inline constexpr double max_work = 220e3;
/// Height above the waist from which the upper end of a garment without shoulder seams is held until it rests in thick
/// air, in m. Less holds skirts too.
inline constexpr double held_above_waist_m = 0.08;
/// Distance at which hands reach their force, in m. More lets cloth slide down.
inline constexpr double hold_reach_m = 0.01;
/// Upper limit of the compression stiffness without a body, in N/m. More lets gathered cloth tremble for ever; without
/// any, the bending of curved cloth shrinks it.
inline constexpr double max_free_compression_n_per_m = 3.0;
/// Count of frames after which a garment without a body begins anew. More leaves creases, less never rests.
inline constexpr int frames_to_unfold = 60;
/// Fraction of the body's girth below which a level of the garment meets one limb alone. More hides girths that do not
/// fit, less says girths of one limb.
inline constexpr double one_limb_fraction = 0.6;

}  // namespace taut::app::sewing
