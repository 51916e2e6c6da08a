#pragma once

#include "prelude.hpp"

/// The numbers of the solver that neither a law, nor geometry, nor rounding gives. The effect of halving and
/// doubling each is in log.md.
namespace taut::sim::bounded::tuning {

/// The part of the cloth that may be otherwise than the rest: held back by balls, fast in a list that lasts,
/// swept once more. More makes regions and lists anew less often, which are then wrong for more vertices.
inline constexpr double few = 0.03;

// Time steps.

/// Fewer time steps, in 1/s, would do for small stiff cloths, and let fast ones pass through obstacles.
inline constexpr double least_steps_per_s = 480.0;
/// The time steps of the next frame over those of the last where its projection was costly, the other way
/// round where it was cheap, and at least to the third power where a frame is repeated: further from 1 they
/// fit sooner, and change more about what fits.
inline constexpr double more_steps = 1.12;
/// Stretch before the projection, in bounds, that a repeated frame aims at. More takes fewer steps and longer
/// projections.
inline constexpr double coped_stretch = 4.0;
/// A projection is cheap below this many sweeps a time step, and below this part of the largest allowed
/// shift. More takes fewer steps sooner, and gives them back sooner.
inline constexpr double cheap = 0.6;
/// A frame is repeated where its projection would take more sweeps a time step than this, or moves a vertex
/// so many times too far, and further than that of the frame before. More repeats less and throws the cloth
/// about at the ends of frames.
inline constexpr double costliest = 3.0;
/// Sweeps of a projection that no more time steps can help. More keeps more bounds and ends later.
inline constexpr double last_resort_sweeps = 1000.0;
/// The work of a search for pairs, in sweeps; one around single vertices is half of it, and regions of as
/// many pairs as there are triangles are as much.
inline constexpr double work_of_search = 25.0;
/// An attempt at a frame that is left less than this part of the frame's budget of work is the last. More gives the
/// last one more work, and fewer before it.
inline constexpr double least_of_budget = 0.2;
/// How long a projection has to be cheap before fewer time steps are tried, in s. Longer takes more steps
/// than needed; shorter keeps cloth awake that is about to rest.
inline constexpr double calm_s = 1.0 / 15.0;
/// How far the projection may move a vertex, in parts of the cloth's reach from its pins. More takes fewer
/// steps and moves the cloth further at the end of a frame.
inline constexpr double shift_per_reach = 0.004;

// Sweeps.

/// After all colours this part of each, the nearest to the pins, is swept again, then this part of that, and
/// so on while it is not few. More costs sweeps and leaves less to the projection.
inline constexpr double swept_again = 0.35;
/// Cloth of so many triangles is fine: of each colour only the second and later of those parts are swept again, and
/// what is too long is corrected by more than its error. Coarser cloth needs more steps without the first part.
inline constexpr std::size_t fine_triangles = 20000;
/// The correction of what is too long in fine cloth over its error. More takes fewer steps, leaves single triangles
/// longer, and is stable below 4/3.
inline constexpr float fine_relaxation = 1.25F;
/// Tethers are longer than the way along the cloth by the bound where springs are held, but by no more than
/// this part of it: cloth made of springs gives a little across them, and tethers of the exact length lift
/// it.
inline constexpr double most_tether_slack = 0.005;

// The projection.

/// Over-relaxed sweeps between two looks at everything, before one of factor 1: where springs pull at each
/// other, a sweep that is over-relaxed leaves some of them too long. More look less often.
inline constexpr int relaxed_sweeps = 6;
/// Cloth is relaxed as a chain of springs of its reach, but of no fewer than this. More settles faster along
/// a chain and slower across.
inline constexpr double shortest_chain = 16.0;
/// A block that is stretched by this part of the aim may get too long by the correction of others: nearer to 1 fewer
/// blocks are swept, in more rounds.
inline constexpr float nearly_long = 0.75F;
/// How fast the last frame's correction fades, in 1/s. Not at all would be fewest sweeps, but shapes would
/// drift off.
inline constexpr double faded_per_s = 1.8;
/// The part of the bound that is aimed at: the last of a correction takes the most sweeps. Less is done
/// sooner and moves the cloth further.
inline constexpr double aimed_part = 0.97;
/// Weights grow by this power of e per spring towards the pins. More hands corrections down the cloth faster
/// and leaves smaller ones near the pins.
inline constexpr double projection_weight_growth = 0.2;

// The law of cloth in its plane.

/// How long tension is averaged over, in s. Less follows loads sooner; where they are large cloth then trembles.
inline constexpr double remembered_s = 0.15;
/// How often tension is averaged around vertices. More costs more; with less, strain goes by what each triangle
/// happens to carry.
inline constexpr int shared_times = 2;
/// The strain that the sweeps of a step have to correct, on average by load. More leaves cloth under load
/// uneven; less takes more steps.
inline constexpr double largest_strain_per_step = 0.025;

// Slow forces.

/// Fewer updates, in 1/s, cost less, and the wind then lags behind the cloth.
inline constexpr double least_updates_per_s = 180.0;
/// The angular frequency of the fastest bending mode times the interval between updates, in radians: stable
/// below the square root of 2 (see add_bending). At 1.2 the cloth trembled, because sweeps come in between.
inline constexpr double largest_rate_times_interval = 0.886;
/// One bending element alone is softened to no more than this, in radians per second, where edges are long.
/// More needs more updates.
inline constexpr double fastest_element_per_s = 60.0;
/// How many edges the bending length of cloth may have before the limit above rises, with the sixth power of
/// their number: folds that are few edges wide are smeared by clusters, and cloth drapes too softly.
inline constexpr double edges_in_bending_length = 1.13;
/// The limit rises to no more than this times the number of edges. More keeps more of the rigidity near
/// clamps, where clusters cannot bend as cloth does, for more updates.
inline constexpr double rise_per_edge = 3.0;
/// The coarsest level takes all that is left, with rates up to this many times those of other levels. Only
/// needles exceed it; more needs more updates for them.
inline constexpr double coarsest_rate = 10.0;
/// The smallest number of clusters of a level: so few have no folds distinct from ripples. More makes fewer
/// levels, and leaves more to the coarsest.
inline constexpr std::size_t fewest_clusters = 100;

// When regions are made, and for how long.

/// Regions last while neighbours move against each other by this part of the mean edge. More makes fewer, of
/// larger balls.
inline constexpr double turned_part_of_edge = 0.2;
/// Where something is near, regions are made at least this often, in 1/s: their planes move as things did
/// before, and would carry what since has been slowed down.
inline constexpr double touching_regions_per_s = 240.0;
/// The part of the triangles that count for how fast neighbours move: single vertices tremble. More makes
/// regions more often.
inline constexpr double counted_part = 0.99;

// Balls.

/// How far vertices may deviate from where they are expected: in parts of the mean edge, of the edges that
/// meet in one, and of the way there, in lists too. More finds more pairs, and where these are neighbours in the cloth
/// their planes hold it stiff; less makes regions last less long.
inline constexpr float room_per_edge = 0.04F;
inline constexpr float room_per_edge_here = 0.1F;
inline constexpr float room_per_move = 0.25F;
/// No ball begins larger, in parts of the mean edge. More finds more pairs.
inline constexpr float most_room_per_edge = 0.375F;
/// A ball that proved too small grows to this many times what would have done. More finds more pairs; less
/// grows more often.
inline constexpr float larger = 1.5F;
/// Contact moves a vertex to within this part of its ball: nearer to 1 balls are smaller, and leave less room
/// to deviate from there.
inline constexpr float filled_part_of_ball = 0.8F;

// Planes.

/// The part of the thickness that expected moves may lack: planes go by what they leave. Less takes more
/// rounds.
inline constexpr float enough_part = 0.01F;
/// Rounds over what has to be satisfied all at once: pairs, the planes of a vertex, planes and the bound,
/// balls and what is found. More holds fewer vertices fast, for more work where nothing fits.
inline constexpr int most_rounds = 12;
/// A round moves a vertex so much further than onto a plane: where these are nearly parallel, exact
/// projections take very many rounds.
inline constexpr float over_projected = 1.4F;
/// The part of what two things lack to the thickness that is asked for while regions last. More throws them
/// apart; less lets a pile sink into itself.
inline constexpr float parted_at_once = 0.2F;

// Lists of pairs that last.

/// A list is for a time in which nothing is expected to move further than this part of the mean edge. More
/// makes lists that last longer, of more pairs.
inline constexpr float slow_part_of_edge = 0.5F;
/// In a list's time vertices may deviate by this part of the mean edge more. More makes the list longer and
/// lets it last longer.
inline constexpr float more_in_list_per_edge = 0.075F;
/// A list is made anew rather than renewed when more than this part of the vertices has to be looked at.
inline constexpr double most_renewed = 0.1;

}  // namespace taut::sim::bounded::tuning
