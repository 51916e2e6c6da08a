#pragma once

#include "sim/mesh/types.hpp"

/// Numbers of fitting. Limits within which a fitted mesh is the model's cloth are in comparison.hpp. "The size" is the
/// diagonal of the model's box.
namespace taut::app::fitting {

// Walls: which of the model's sheets are cloth (sheets.cpp).

/// Largest distance between two walls of one cloth, in m. More takes layers for walls, less simulates both walls of
/// quilts.
inline constexpr double max_wall_distance_m = 0.012;
/// Size of a garment in m; all lengths here shrink with smaller ones. More shrinks them for children's clothes.
inline constexpr double usual_size_m = 0.8;
/// Depth to which two walls may cross each other, in m. More takes neighbouring folds for walls.
inline constexpr double max_wall_crossing_m = 0.0005;
/// Largest cosine between the normals of two walls. More pairs folds, less misses walls of different curvature.
inline constexpr double max_opposite_cosine = -0.7;
/// Area fraction with another wall above which a sheet is cut into walls. Less cuts hems, more keeps shells whole.
inline constexpr double min_shell_area_fraction = 0.3;
/// Largest thickness of a garment laid flat, in m, which has no two walls. More keeps both walls of thin shells.
inline constexpr double flat_m = 0.04;
/// Largest distance of a sheet from the cloth that it lies on, in m. More lets flounces be carried, less simulates
/// labels.
inline constexpr double max_lying_distance_m = 0.006;
/// Smallest fraction of a sheet's area that lies on others. More simulates pockets, less carries their flaps.
inline constexpr double min_lying_area_fraction = 0.8;
/// The same fraction of a wall of a sheet that has two.
inline constexpr double min_behind_area_fraction = 0.4;
/// Smallest cosine between a normal and the direction to cloth above it. Less finds cloth beside it.
inline constexpr double min_over_cosine = 0.7;
/// Count of triangles of a piece that tell whether it lies on others or outside. More takes longer, fewer are less
/// certain.
inline constexpr std::size_t max_triangles_tried = 4000;

// Borders: what is joined (fitted_mesh.cpp).

/// Cosine of the inward directions of two borders above which one lies on the other. Less leaves sharp seams open.
inline constexpr double min_layer_cosine = 0.95;
/// Largest such cosine of a seam between borders of one sheet. More closes slits and pleats.
inline constexpr double max_seam_cosine = -0.3;
/// Largest such cosine of a part that continues beyond a gap. More joins parts side by side.
inline constexpr double max_gap_cosine = -0.7;
/// Largest cosine between the inward direction and the other border's direction. More joins borders at an angle.
inline constexpr double max_across_cosine = 0.3;
/// Width of a slit over its longest border, which may be twice as long. More closes vents.
inline constexpr double slit_width_ratio = 0.07;
/// Largest distance of joined borders, in m. More joins layers, less leaves seams open.
inline constexpr double max_joined_m = 0.0025;
/// The same as a fraction of the size.
inline constexpr double joined_share = 0.003;
/// Largest gap between joined parts, in m. More joins hems to what hangs below.
inline constexpr double max_gap_m = 0.02;
/// The same as a fraction of the size.
inline constexpr double gap_share = 0.02;
/// Smallest count of border vertices along another part that continues. Fewer join parts at a point.
inline constexpr std::size_t min_border_vertices = 8;
/// Largest border of a closed hole, in edge lengths. More closes buttonholes and eyelets.
inline constexpr double closed_hole_edges = 5.0;
/// Thickness of flat pieces, as a fraction of the size. More takes worn garments for cut pieces.
inline constexpr double flat_thickness_fraction = 0.02;

// Sheets: which are simulated (fitted_mesh.cpp).

/// Smallest area of a simulated sheet, as a fraction of the total. More carries cuffs, less simulates buttons.
inline constexpr double min_sheet_share = 0.02;
/// The same as a fraction of the largest sheet's area.
inline constexpr double min_share_of_largest = 0.05;
/// The same of a sheet beside no other. More drops straps.
inline constexpr double tiny_sheet_share = 0.001;
/// Fraction of a small sheet's vertices that are beside others for it to follow them. More simulates trims.
inline constexpr double min_trim_fraction = 0.6;
/// Largest distance of such a vertex, as a fraction of the size. More carries tassels.
inline constexpr double trim_distance_fraction = 0.02;

// Number of triangles and of fits (fitted_mesh.cpp).

/// Ratio of a target edge to the edge of equilateral triangles that are as many as wanted. After a trial with too many
/// triangles, edges grow by it too. Less needs more trials, more gives fewer triangles.
inline constexpr double target_edge_ratio = 1.08;
/// Budget of triangle tests for each requested triangle. Thirteen garments of other makers took up to 215 in all their
/// fits. Flat polygons of 2000 corners that are cut into needles exceed it.
inline constexpr std::size_t max_looks_per_triangle = 2000;
/// Largest count of target edges that are tried. Fewer may end with too many triangles.
inline constexpr int max_edge_trials = 4;
/// Largest count of fits, each of the mesh of the one before. More crosses less and is farther from the model.
inline constexpr int max_fits = 4;
/// Smallest area after another fit, as a fraction of the first one's. Less loses folds.
inline constexpr double min_area_left = 0.96;

// Models that are simulated themselves (fitted_mesh.cpp).

/// Fraction of the area with two walls above which a mesh is fitted. Less refits hems.
inline constexpr double max_two_walled_fraction = 0.3;
/// Smallest count of triangles for the folds of a garment. More refits models that would do.
inline constexpr std::size_t min_fold_triangles = 1000;
/// Largest fraction of needles among the triangles. More simulates models that hardly move.
inline constexpr double needle_share = 0.003;
/// Largest fraction of edges within the thickness. More lets contact tear them.
inline constexpr double short_share = 0.002;
/// Sine of 5 degrees, the smallest angle of a triangle that is no needle.
inline constexpr double needle_sine = 0.0871557427;

// Triangles of one size (remeshing.cpp). The two edge ratios are those of Botsch and Kobbelt 2004.

/// Count of rounds of splits, collapses, flips and smoothing. More evens triangles out and takes longer.
inline constexpr int remeshing_rounds = 8;
/// Largest count of sweeps of collapses or flips in a round.
inline constexpr int max_collapse_sweeps = 6;
/// Limit of all vertices ever made, for models of needles.
inline constexpr std::size_t max_vertices = 1000000;
/// Cost of a split in triangle tests.
inline constexpr std::size_t looks_of_split = 50;
/// Length over target length above which an edge is split.
inline constexpr double max_edge_ratio = 4.0 / 3.0;
/// Length over target length below which an edge is collapsed.
inline constexpr double min_edge_length_ratio = 4.0 / 5.0;
/// Longest half of a split edge, as a fraction of the edge.
inline constexpr double max_half_ratio = 0.75;
/// Cosine of a border's turn below which the corner stays. More keeps more corners.
inline constexpr double max_corner_cosine = 0.6;
/// Distance to both sides over which the turn is measured, in edge lengths.
inline constexpr double corner_reach_edges = 0.7;
/// Smallest cosine between normals before and after a change. Less folds the mesh over, more keeps needles.
inline constexpr double min_normal_cosine = 0.3;
/// Smallest edge of a triangle, in target lengths. More keeps fewer small folds.
inline constexpr double min_edge_ratio = 0.1;
/// Smallest height of a triangle, in target lengths.
inline constexpr double min_height_ratio = 0.03;
/// Doubled area over the square of the longest side below which a normal is meaningless.
inline constexpr double min_area_ratio = 0.02;
/// Smallest ratio of inner to outer radius after a collapse by simplify(). Less leaves needles, more ends before
/// the mesh is coarse enough.
inline constexpr double min_roundness = 0.25;
/// Largest turn of a triangle by a collapse, in degrees. More folds the cloth over.
inline constexpr double max_normal_turn_deg = 60.0;

// Comparison with the model (comparison.cpp).

/// Count of points on each surface. Fewer are less certain of a small lost part, more take longer.
inline constexpr std::size_t sample_count = 4000;
/// Cosine of the normals below which an edge may be a rim of two walls. More finds rims in folds.
inline constexpr double crease_cosine = 0.8;

// The model that follows the mesh (following.cpp, and app/models/mending/following_limits.cpp from `max_sweeps` on).

/// Largest distance of a triangle that faces the same way, as a multiple of the distance of the nearest triangle.
inline constexpr double max_facing_distance_ratio = 2.0;
/// Weight of a triangle's own normal beside the normals of its vertices. More shows edges of the mesh in the model.
inline constexpr double face_normal_weight = 0.1;
/// Count of rounds in which the normals of a mesh are averaged for a model that follows it. More keeps the thickness of
/// thick models in folds, less follows small folds more closely.
inline constexpr int normal_smoothing_rounds = 10;
/// Largest size of a part that stays rigid, such as a button, in m. More keeps belt loops and tabs from bending.
inline constexpr double max_rigid_size_m = 0.03;
/// Largest count of sweeps over stretched triangles. More shorten models whose vertices follow distant parts, and take
/// longer.
inline constexpr int max_sweeps = 60;
/// Correction of a stretched triangle over the one that it needs by itself. More needs fewer sweeps; 2 does not end.
inline constexpr double over_correction = 1.7;
/// Stretch beyond the limit, as a fraction of the length at rest, that is left. Less needs more sweeps.
inline constexpr double stretch_tolerance = 0.003;
/// Largest count of rounds in which triangles that cross are parted. More removes more crossings and takes longer.
inline constexpr int max_parting_rounds = 16;
/// Largest work of these rounds for a shape, in triangles. More removes crossings of larger models and takes longer.
inline constexpr std::size_t max_parting_work = 1000000;
/// Largest number of crossings as modelled for each triangle of a model whose crossings are parted. More takes longer
/// on tangled models, whose crossings only change their places.
inline constexpr double max_own_crossing_fraction = 0.1;
/// Work of a crossing, in triangles.
inline constexpr std::size_t work_of_crossing = 6;
/// Distance to which crossing triangles are parted, in mean edges. More needs fewer rounds and stretches more.
inline constexpr double parting_margin_edges = 0.07;
/// Largest distance as modelled, in mean edges, within which two surfaces keep the sides that they have as modelled.
/// More takes other folds for another wall of the same cloth.
inline constexpr double max_wall_edges = 2.0;
/// Smallest cosine between their distance as modelled and the normal. Less takes neighbours beside it for walls.
inline constexpr double min_wall_cosine = 0.1;
/// Weight of the neighbours' mean in a round. More flattens folds, less leaves crossings.
inline constexpr double smoothing_weight = 0.5;

}  // namespace taut::app::fitting
