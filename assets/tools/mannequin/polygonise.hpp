#pragma once

#include "sim/mesh/mesh.hpp"
#include "tailor/mannequin/shape.hpp"

namespace taut::tailor {

/// Returns the left half of the body's surface, x >= 0, as triangles that are counter-clockwise from outside, by
/// marching tetrahedra, six in a cell (Bloomenthal 1994). Its border is on x = 0. Cells are `cell_m` wide.
sim::Mesh polygonise_left_half(const Shape& shape, const Vec3& low_m, const Vec3& high_m, double cell_m);

/// Returns the left half with nearly equilateral triangles and edges of the length `edge_length_m`, by splits,
/// collapses, flips and tangential relaxation (Botsch, Kobbelt 2004).
sim::Mesh even_out(const Shape& shape, const sim::Mesh& half, int rounds);

/// Moves vertices towards the middle of their neighbours and back onto the surface. The border stays on x = 0.
void relax(const Shape& shape, sim::Mesh& half);

/// Returns the half and its mirror image, joined along x = 0. Vertex i of the half stays vertex i.
sim::Mesh with_mirror_image(const sim::Mesh& half);

}  // namespace taut::tailor
