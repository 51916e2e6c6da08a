#pragma once

#include <cstddef>

/// Numbers of dressing: how bodies are measured, thinned and put into garments. A "level" is a level tape around a body
/// (LevelTape). The "trunk" goes from the fork, where legs part, to the armpits.
namespace taut::app::dressing {

// Girths of the trunk (body_girths.cpp).

/// Count of levels from the feet to the top of the head. More takes longer, less measures folds.
inline constexpr int level_count = 400;
/// Height of the level at which the largest curve is the trunk, as a fraction of the body's. Less may meet hands, more
/// outstretched arms.
inline constexpr double trunk_search_height_fraction = 0.55;
/// Smallest girth of a leg, as a fraction of the level's longest curve. Less takes hands for legs, more misses thin
/// legs.
inline constexpr double min_leg_girth_fraction = 0.5;
/// Smallest girth of an arm beside the trunk, as a fraction of the trunk's. Less takes fingers for arms, more misses
/// thin arms.
inline constexpr double min_arm_girth_fraction = 0.15;
/// Smallest ratio of girths, `limb_tape_offset_levels` apart, where arms begin. Less takes wide chests for arms, more
/// takes arms for the chest.
inline constexpr double min_armpit_girth_ratio = 1.2;
/// Smallest such ratio where an arm beside the trunk has joined it. Less takes sleeves that touch for joined arms.
inline constexpr double min_joined_arm_girth_ratio = 1.08;
/// Ratio of girths, one level apart, above which arms still join the trunk. Less lowers the upper chest, more puts it
/// into the armpits.
inline constexpr double joining_girth_ratio = 1.02;
/// Count of levels from the crotch or the armpits down to the tape below them. More measures less of the limb's or the
/// trunk's full girth, less measures folds.
inline constexpr std::ptrdiff_t limb_tape_offset_levels = 3;
/// Smallest count of levels of a trunk. More refuses children with long legs, less measures tables.
inline constexpr std::ptrdiff_t min_trunk_levels = 10;
/// Lowest height of the chest, as a fraction of the trunk's. Less takes bellies for chests.
inline constexpr double min_chest_height_fraction = 0.6;
/// Largest height of a waist, as a fraction of the trunk's. More takes the chest for a waist, less puts skirts too low.
inline constexpr double max_waist_height_fraction = 0.8;
/// Smallest girth of a chest, as a multiple of the trunk's smallest girth. Less takes ribs for chests, more misses flat
/// ones.
inline constexpr double min_chest_girth_ratio = 1.03;
/// Largest height of the seat, as a fraction of the trunk's. More takes bellies for seats.
inline constexpr double max_seat_height_fraction = 0.5;
/// Largest distance of the seat below the crotch, as a fraction of the body's height. Less misses wide thighs, more
/// measures legs.
inline constexpr double seat_below_fork_fraction = 0.03;
/// Smallest height of the skin, as a fraction of the height with hair and shoes. Less takes shirts for skin, more
/// measures hair.
inline constexpr double min_skin_height_fraction = 0.8;

// Neck (body_girths.cpp).

/// Largest girth of a neck, as a fraction of the head's. More takes tables for people, less misses thick necks.
inline constexpr double max_neck_girth_fraction = 0.85;
/// Girth of the base of the neck, as a multiple of the neck's smallest girth. More puts it on the shoulders.
inline constexpr double neck_base_girth_ratio = 1.35;
/// Girth around a jaw, as a multiple of the neck's smallest girth. More measures jaws, less distrusts joints.
inline constexpr double min_jaw_girth_ratio = 1.28;
/// Fraction of the way from the neck's joint to the head's for the neck's tape. More measures jaws, less shoulders.
inline constexpr double neck_tape_height_fraction = 0.75;

// Arms (body_girths.cpp).

/// Largest distance of a ring's middle from the point where it is searched, in m. More takes the trunk for an arm.
inline constexpr double max_ring_distance_m = 0.1;
/// Offset of two rings from the middle of the upper arm, as a fraction of its length. Less tilts the tape, more leaves
/// the arm.
inline constexpr double upper_arm_ring_offset_fraction = 0.15;
/// Distance from the shoulder joint to the end of the shoulder, in m. More widens armholes.
inline constexpr double shoulder_end_offset_m = 0.03;
/// Count of steps from the shoulder joint to the middle of the upper arm. More takes longer, less moves armholes out.
inline constexpr int armhole_step_count = 40;
/// Smallest ratio of one ring to the ring before it. More takes an armhole further out.
inline constexpr double min_next_ring_ratio = 0.98;
/// Largest girth of an armhole, as a multiple of the arm's. More takes rings around the trunk.
inline constexpr double max_armhole_ratio = 2.0;
/// Smallest girth of an armhole, as a fraction of the arm's or sleeve's. Less takes folds.
inline constexpr double min_armhole_ratio = 0.7;

// Growth of a body from its bones (dressing.cpp).

/// Fraction of the way to its bones by which a vertex of the thin shape is moved. More leaves triangles no area, less
/// crosses tight clothes.
inline constexpr double thinning_fraction = 0.9;
/// Fraction of the dressing's frames in which the body grows; in the rest cloth slides to where it fits. More leaves
/// less time to slide, less grows faster.
inline constexpr double growth_time_fraction = 0.8;
/// Count of frames after 0 s in which a body takes its own shape, where parts near each other had left clearance for
/// cloth. More takes longer, less presses cloth there.
inline constexpr int frames_to_own_shape = 30;
/// Count of poses in a turn, between which vertices move straight. More takes longer, less thins turning limbs.
inline constexpr int turn_pose_count = 8;
/// Clearance for one garment where limbs meet, in m: for two layers of usual cloth. More thins limbs, less traps cloth.
inline constexpr double first_garment_clearance_m = 0.008;
/// Clearance for each further garment over it, in m, as garments over each other lie in folds. More thins limbs, less
/// traps cloth.
inline constexpr double further_garment_clearance_m = 0.032;
/// Largest cosine between the normals of surfaces that face each other. More leaves clearance in creases.
inline constexpr double max_facing_cosine = -0.2;
/// Fraction of the growth that every vertex keeps. More leaves less clearance, less makes thin limbs.
inline constexpr double min_kept_growth_fraction = 0.48;
/// Count of steps of the growth in which clearance is found. Fewer let limbs pass each other, more take longer.
inline constexpr int growth_step_count = 13;

// Joints guessed from a shape (dressing.cpp).

/// Offset of a shoulder from the trunk's middle, as a fraction of the half width at the arms. More puts it into the
/// arm, less into the chest.
inline constexpr double shoulder_offset_fraction = 0.85;
/// Offset of a hip joint, as the same fraction. More puts it beside the leg.
inline constexpr double hip_offset_fraction = 0.5;
/// Height of shoulders, as a fraction of the way from below the arms to the base of the neck. More puts them above it.
inline constexpr double shoulder_height_fraction = 0.55;
/// Distance of an elbow from the shoulder, as a fraction of that to the finger tips. More puts it into the forearm.
inline constexpr double elbow_fraction = 0.45;
/// Difference from this fraction of the vertices around an elbow. More follows bent arms less, less finds no vertices.
inline constexpr double elbow_tolerance = 0.05;
/// Height of the hips above the fork, as a fraction of the trunk's. More shortens the trunk.
inline constexpr double hips_above_fork_fraction = 0.12;
/// Offset beyond which a vertex is of an arm, as a multiple of the trunk's half width. More takes arms for the trunk.
inline constexpr double beside_trunk_ratio = 1.03;
/// Depth below the fork to which hands reach, as a fraction of the body's height. More takes legs for hands.
inline constexpr double hands_below_fork_fraction = 0.1;
/// Height of feet, as a fraction of the body's. More moves their joint to the ankle.
inline constexpr double foot_height_fraction = 0.04;
/// Fraction of a bone's length beyond which a vertex follows the joint at its end. Less moves hands with forearms.
inline constexpr double end_joint_fraction = 0.9;

// Place of a garment on a body (wearing.cpp).

/// Largest distance of a garment that is already about a body, in m. More leaves garments beside it.
inline constexpr double max_worn_distance_m = 0.05;
/// Largest such distance downwards, in m. More leaves garments that have slid down.
inline constexpr double max_worn_drop_m = 0.12;
/// Smallest cosine of the rotation of such a garment. Less leaves garments that face sideways.
inline constexpr double min_worn_cosine = 0.70710678;
/// Cosine above which a rotation of a moved garment is ignored. More turns garments for the sake of noise.
inline constexpr double min_unturned_cosine = 0.98;
/// Depth of a garment's fork below the body's, in m. Less crosses the crotch.
inline constexpr double below_fork_m = 0.01;
/// Distance of an opening from the start of a limb below which it turns no bone, in m. More leaves arms beside sleeves.
inline constexpr double min_limb_distance_m = 0.02;
/// Largest distance by which a garment is lifted off shoulders that it crosses, in m. More drops it from far above.
inline constexpr double max_lift_m = 0.12;
/// Step of this lift, in m. More lifts too far, less takes longer.
inline constexpr double lift_step_m = 0.02;

// Fit of a garment (fit.cpp).

/// Distance from an edge of cloth, in m: up to there above a garment its upper edge is measured, and sleeves are
/// measured that far from their ends. More gives girths that it does not cover, less measures hems of sleeves.
inline constexpr double near_edge_m = 0.02;
/// Distance from the shoulder joint within which an opening is an armhole, and cloth above the tube is about it, in m.
/// More takes short sleeves for armholes.
inline constexpr double armhole_distance_m = 0.15;
/// Ease below which a shoulder width is narrow, in m. More calls more garments narrow.
inline constexpr double narrow_below_m = -0.02;
/// Ease from which a shoulder width is wide, in m. Less calls more garments wide.
inline constexpr double wide_from_m = 0.03;
/// Ease below which a girth is tight, in m. More calls more garments tight.
inline constexpr double tight_below_m = 0.04;
/// Ease below which a girth is fitted and not loose, in m. More calls fewer garments loose.
inline constexpr double fitted_below_m = 0.12;
/// Ratio of girths below which a garment is refused. More refuses what fits a little higher or lower, less tries what
/// is too small.
inline constexpr double min_girth_ratio = 0.98;
/// Fraction of the triangles at a girth, the most stretched ones, whose mean stretch is named. More names less stretch.
inline constexpr double tight_triangle_fraction = 0.1;
/// Half height of the band of such triangles, in m. More mixes girths.
inline constexpr double girth_band_m = 0.04;
/// Count of named tight places. More do not fit into a line of the picture.
inline constexpr std::size_t max_tight_places = 3;
/// Smallest stretch that is named. Less names places that hardly stretch.
inline constexpr double min_named_stretch = 0.005;

}  // namespace taut::app::dressing
