#pragma once

#include "prelude.hpp"

/// Tuned numbers of the solver, which follow from no law, geometry or rounding. log.md lists values that lost.
namespace taut::sim::bounded::tuning {

// Time steps.

/// Smallest number of time steps per s. Lower values suffice for small stiff cloths but let fast ones pass through
/// obstacles.
inline constexpr double min_steps_per_s = 480.0;
/// Growth factor of the number of time steps after a costly projection, and its inverse after a cheap one; at least its
/// cube for a repeated frame. Higher values adapt faster but fluctuate more.
inline constexpr double step_growth_factor = 1.12;
/// Target stretch before the projection, in bounds, of a repeated frame. Higher values take fewer steps and longer
/// projections.
inline constexpr double target_unprojected_stretch = 4.0;
/// Largest cost of a cheap projection, in sweeps per time step. Higher values reduce the number of steps sooner, and
/// increase it again sooner.
inline constexpr double low_cost_ratio = 0.6;
/// Largest motion by a cheap projection, as a fraction of the allowed shift. Higher values reduce the number of steps
/// sooner, and increase it again sooner.
inline constexpr double low_shift_ratio = 0.6;
/// Largest cost of a projection before its frame is repeated, in sweeps per time step. Higher values repeat less and
/// sweep longer.
inline constexpr double max_cost_ratio = 3.0;
/// Largest motion by a projection before its frame is repeated, in allowed shifts. Higher values repeat less and throw
/// the cloth about at the ends of frames.
inline constexpr double max_shift_ratio = 3.0;
/// Largest growth of that motion from one frame to the next for which a frame is kept in any case. Higher values repeat
/// less where the cloth shifts by steps.
inline constexpr double max_shift_growth = 1.12;
/// Factor by which the median work of frames follows each of them, up or down. Higher values follow sooner but also
/// single frames.
inline constexpr double median_growth_factor = 1.12;
/// Largest number of sweeps of a last projection. Higher values keep more bounds but end later.
inline constexpr double last_resort_sweeps = 1000.0;
/// Work of a broad phase, in sweeps. One around single vertices counts half; regions with one pair per triangle count
/// as much.
inline constexpr double search_work_sweeps = 25.0;
/// Smallest fraction of the frame's work budget left for another attempt; with less, the next attempt is the last.
/// Higher values leave more work to the last attempt and less to those before.
inline constexpr double min_budget_fraction = 0.2;
/// Largest fraction of that budget for an attempt at a whole frame. Higher values leave less work to its halves.
inline constexpr double max_whole_frame_fraction = 0.25;
/// Time in s for which projections have to be cheap before fewer time steps are tried. Longer takes more steps than
/// needed; shorter keeps cloth awake that is about to rest.
inline constexpr double low_cost_time_s = 1.0 / 15.0;
/// Largest motion of a vertex by the projection, as a fraction of the cloth's reach from its pins. Higher values take
/// fewer steps but move the cloth further at the end of a frame.
inline constexpr double shift_per_reach = 0.004;

// Sweeps.

/// Fraction of each colour, nearest to the pins, that is swept again after all colours; then this fraction of that, and
/// so on down to `min_resweep_fraction`. Higher values cost sweeps and leave less to the projection.
inline constexpr double resweep_fraction = 0.35;
/// Smallest fraction that is swept again. Lower values sweep once more around the pins.
inline constexpr double min_resweep_fraction = 0.03;
/// Smallest number of triangles of fine cloth. Fine cloth skips the first of the repeated sweeps and over-relaxes long
/// triangles. Coarser cloth needs more steps without the first repeat.
inline constexpr std::size_t min_fine_triangles = 20000;
/// Relaxation factor of long triangles in fine cloth. Higher values take fewer steps but leave single triangles longer;
/// stable below 4/3.
inline constexpr float fine_relaxation = 1.25F;
/// Largest slack of tethers if springs are bounded, as a fraction of the path along the cloth; at most the bound. Cloth
/// made of springs yields a little across them, and tethers of the exact length lift it.
inline constexpr double max_tether_slack = 0.005;

// The projection.

/// Over-relaxed sweeps in a round, before one of factor 1 and a check of all lengths: where springs pull at each other,
/// over-relaxed sweeps leave some too long. Higher values check less often.
inline constexpr int relaxed_sweeps = 6;
/// Rounds between two checks whether they still help. Higher values make regions anew later if the cloth is stuck.
inline constexpr int rounds_per_check = 6;
/// Smallest number of springs in the chain that sets the relaxation factor; otherwise it is the cloth's reach. Higher
/// values converge faster along a chain but slower across.
inline constexpr double min_chain_springs = 16.0;
/// Fraction of the target stretch above which a block is swept, as corrections of others may make it too long. Values
/// nearer to 1 sweep fewer blocks in more rounds.
inline constexpr float near_bound_fraction = 0.75F;
/// Decay rate of the last frame's correction, in 1/s. At 0 the sweeps would be fewest, but shapes would drift.
inline constexpr double correction_decay_per_s = 1.8;
/// Fraction of the bound at which the projection aims: the last part of a correction takes the most sweeps. Lower
/// values end sooner but move the cloth further.
inline constexpr double aim_fraction = 0.97;
/// Growth of the weights per spring towards the pins, as a power of e. Higher values pass corrections down the cloth
/// faster and leave smaller ones near the pins.
inline constexpr double projection_weight_growth = 0.2;

// The law of cloth in its plane.

/// Time constant of the averaged tension, in s. Lower values follow loads sooner; under large loads the cloth then
/// trembles.
inline constexpr double tension_averaging_s = 0.15;
/// Rounds of averaging of tension around vertices. More rounds cost more; with fewer, strain depends on the tension
/// that single triangles happen to carry.
inline constexpr int tension_sharing_rounds = 2;
/// Largest strain that the sweeps of a step correct, averaged by load. Higher values leave loaded cloth uneven; lower
/// ones take more steps.
inline constexpr double max_strain_per_step = 0.025;

// Slow forces.

/// Smallest rate of updates, in 1/s. Lower rates cost less, but the wind then lags behind the cloth.
inline constexpr double min_updates_per_s = 180.0;
/// Largest product of the angular frequency of the fastest bending mode and the update interval, in radians: stable
/// below the square root of 2 (see add_bending). At 1.2 the cloth trembled, because sweeps come in between.
inline constexpr double max_rate_times_interval = 0.886;
/// Largest angular frequency of a single bending element, in radians per second; stiffer ones are softened to it.
/// Higher values need more updates.
inline constexpr double max_element_rate_per_s = 60.0;
/// Bending length in edges above which that limit rises, with the sixth power of the length. Without the rise clusters
/// smear folds that are few edges wide, and cloth drapes too softly.
inline constexpr double edges_in_bending_length = 1.13;
/// Largest rise of the limit per edge of bending length. Higher values keep more rigidity near clamps, where clusters
/// cannot bend like cloth, for more updates.
inline constexpr double max_rise_per_edge = 3.0;
/// Factor on the rate limit of the coarsest level, which takes all remaining rigidity. Only needles exceed it; higher
/// values need more updates for them.
inline constexpr double coarsest_rate_factor = 10.0;
/// Smallest number of clusters of a level that is refined; with fewer, folds cannot be told from ripples. Higher values
/// make fewer levels and leave more to the coarsest.
inline constexpr std::size_t min_clusters = 100;

// When regions are made, and for how long.

/// Relative motion of neighbours for which regions last, as a fraction of the mean edge. Higher values make fewer
/// regions with larger trust regions.
inline constexpr double region_travel_per_edge = 0.2;
/// Smallest rate of new regions if something is near, in 1/s. Planes follow the earlier motion, and would carry along
/// primitives that have slowed down since.
inline constexpr double touching_regions_per_s = 240.0;
/// Largest number of searches until trust regions fit. Higher values stop fewer vertices, for more work if nothing
/// fits.
inline constexpr int max_searches = 12;
/// Largest number of searches for regions that can be made for half the time instead.
inline constexpr int max_searches_before_halving = 3;
/// Largest fraction of vertices with larger trust regions than at first, above which regions are made for half the
/// time. Higher values find pairs by the hundred thousand.
inline constexpr double max_large_ball_fraction = 0.01;
/// Largest fraction of vertices clamped by their trust regions, above which regions are renewed. Higher values renew
/// less often, and clamp more.
inline constexpr double max_clamped_fraction = 0.03;
/// Sweeps that bring predicted motions towards the bound. With one, cloth that is pulled along keeps its old motion.
inline constexpr int prediction_sweeps = 3;
/// Quantile of the triangles' relative speeds that counts, as single vertices tremble. Higher values make regions more
/// often.
inline constexpr double speed_quantile = 0.99;

// Balls.

/// Slack of vertices around their predicted motion, as fractions of the mean edge, of the edges at the vertex, and of
/// the motion; lists use it too. Higher values find more pairs, and planes between neighbours in the cloth hold it
/// stiff; lower ones shorten the life of regions.
inline constexpr float slack_per_mean_edge = 0.04F;
inline constexpr float slack_per_local_edge = 0.1F;
inline constexpr float slack_per_motion = 0.25F;
/// Largest initial radius of a trust region, as a fraction of the mean edge. Higher values find more pairs.
inline constexpr float max_slack_per_edge = 0.375F;
/// Growth factor of a trust region beyond the radius that would have sufficed. Higher values find more pairs; lower
/// ones grow more often.
inline constexpr float ball_growth_factor = 1.5F;
/// Largest motion of a vertex by contact, as a fraction of its trust region. Values nearer to 1 allow smaller trust
/// regions but leave less slack around the new motion.
inline constexpr float ball_fill_fraction = 0.8F;

// Planes.

/// Tolerance of predicted motions, as a fraction of the thickness: planes use the distance that is left. Lower values
/// take more rounds.
inline constexpr float motion_tolerance_fraction = 0.01F;
/// Passes over pairs that resolve predicted collisions by mass. Higher values leave less to the passes that ignore
/// mass.
inline constexpr int passes_by_mass = 12;
/// Largest number of passes over pairs. Higher values hold fewer vertices, for more work in a pile.
inline constexpr int max_passes = 144;
/// Largest number of projections onto the planes of a vertex. Higher values need the path along planes less often.
inline constexpr int max_plane_projections = 12;
/// Over-relaxation of the projection onto planes: between nearly parallel planes, exact projections take very many
/// rounds.
inline constexpr float over_projection_factor = 1.4F;
/// Fraction of the missing thickness that is restored while regions last. Higher values throw layers apart; lower ones
/// let a pile sink into itself.
inline constexpr float separation_fraction = 0.2F;
/// Speed at which vertices of folds leave their predicted motion, in m/s. Primitives of the thinnest cloth collide
/// within the distance that it covers while regions last. Lower values let thin cloth bounce between planes for ever;
/// higher ones cost time.
inline constexpr double fold_speed_m_per_s = 0.72;
/// Decrease of this distance per thickness. Lower values let cloth of a millimetre collide further away than it needs,
/// which costs time.
inline constexpr float decrease_per_thickness = 1.85F;
/// Largest acceleration that planes between movable primitives stop, in gravities. Lower values leave crumpled cloth
/// trembling; without a limit a storm blows cloth into itself beyond its bound.
inline constexpr float max_stopped_gravities = 16.0F;

// Lists of pairs that last.

/// Largest predicted motion during the life of a list, as a fraction of the mean edge. Higher values make lists of more
/// pairs that last longer.
inline constexpr float slow_motion_per_edge = 0.5F;
/// Largest fraction of vertices faster than that, above which no list is made. Higher values renew more of each list.
inline constexpr double max_fast_fraction = 0.03;
/// Additional slack of vertices in a list, as a fraction of the mean edge. Higher values make longer lists that last
/// longer.
inline constexpr float list_slack_per_edge = 0.075F;
/// Largest fraction of vertices for which a list is renewed; with more, it is made anew. Higher values search around
/// more vertices.
inline constexpr double max_renewed_fraction = 0.1;

}  // namespace taut::sim::bounded::tuning
