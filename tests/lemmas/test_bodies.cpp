// Lemma 5 of sim/solvers/bounded/bounded.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/verify/crossing_pairs.hpp"
#include "check.hpp"
#include "numbers.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/contact/body_contacts.hpp"

namespace taut::sim {
namespace {

/// A tetrahedron around the origin, its corners `size_m` from it.
BodyMesh tetrahedron(double size_m) {
  const double s = size_m / std::sqrt(3.0);
  const BodyMeshData data = {{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}},
                             {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  return {std::make_shared<const BodyMeshData>(data)};
}

/// A body below the cloth that rises, turns and shifts.
Body some_body(Numbers& some) {
  const double up_m = some.between(-0.12, -0.03);
  const double size_m = some.between(0.01, 0.1);
  Body body;
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      body.shape = Plane{some.vector(3.0) * Vec3(1, 0, 1) + Vec3(0, up_m, 0),
                         glm::normalize(Vec3(0, 1, 0) + some.vector(0.02) * Vec3(1, 0, 1))};
      break;
    case 1:
      body.shape = Sphere{{0, up_m - size_m, 0}, size_m};
      break;
    case 2: {
      const Vec3 half = some.vector(0.1) * Vec3(1, 0, 1);
      body.shape = Capsule{Vec3(0, up_m - size_m, 0) - half, Vec3(0, up_m - size_m, 0) + half, size_m,
                           some.between(0.3, 1.0) * size_m};
      break;
    }
    default:
      body.shape = tetrahedron(size_m);
      body.motion.path = {{0.0, {0, up_m - size_m, 0}}};
  }
  body.motion.shift = {some.vector(1.0) + Vec3(0, 1, 0), 0.0, some.between(0.0, 0.2)};
  body.motion.spin = {some.vector(0.1), glm::normalize(some.vector(1.0)), some.between(-0.5, 0.5)};
  return body;
}

/// Returns whether a point of the triangle is within a shape other than a mesh.
struct Enters {
  const app::Corners& triangle;

  bool operator()(const Plane& plane) const { return app::enters_half_space(triangle, plane.point_m, plane.normal); }
  bool operator()(const Sphere& ball) const {
    return app::enters_limb(triangle, {ball.centre_m, ball.centre_m, ball.radius_m, ball.radius_m});
  }
  bool operator()(const Capsule& limb) const {
    return app::enters_limb(triangle, {limb.start_m, limb.end_m, limb.start_radius_m, limb.end_radius_m});
  }
  bool operator()(const BodyMesh&) const { return false; }
};

/// Returns whether the triangle is in one of the balls that a tapered limb consists of. The limb of app/verify is a
/// little smaller, as its radius is measured at right angles to its axis.
bool begins_within_balls(const app::Corners& triangle, const Shape& shape) {
  const auto* limb = std::get_if<Capsule>(&shape);
  constexpr int balls = 30;
  for (int k = 0; limb != nullptr && k <= balls; ++k) {
    const double along = static_cast<double>(k) / balls;
    const Vec3 centre_m = glm::mix(limb->start_m, limb->end_m, along);
    const double radius_m = 1e-4 + glm::mix(limb->start_radius_m, limb->end_radius_m, along);
    if (app::enters_limb(triangle, {centre_m, centre_m, radius_m, radius_m})) {
      return true;
    }
  }
  return false;
}

std::size_t entered(const Mesh& mesh, const std::vector<Vec3>& cloth_m, const Body& body, double time_s) {
  std::size_t count = 0;
  const Shape shape = shape_at(body, time_s);
  for (const auto& [a, b, c] : mesh.triangles) {
    const app::Corners triangle = {cloth_m[a], cloth_m[b], cloth_m[c]};
    count += std::visit(Enters{triangle}, shape) ? 1 : 0;
  }
  if (const auto* solid = std::get_if<BodyMesh>(&body.shape)) {
    std::vector<Vec3> positions_m(solid->data->positions_m.size());
    positions_at(body, time_s, positions_m);
    const Surface surface = {positions_m, solid->data->triangles};
    count += app::crossing_pairs({cloth_m, mesh.triangles}, surface).size();
    for (const Vec3& p : cloth_m) {
      count += winding_number(p, surface) > 0.5 ? 1 : 0;
    }
  }
  return count;
}

TEST(Lemma, NothingIsWithinABodyAfterAFrame) {
  std::size_t touched = 0;
  std::size_t kept = 0;
  ASSERT_TRUE(holds("bodies", [&] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    GridSettings grid;
    grid.columns = grid.rows = 5;
    grid.width_m = grid.height_m = 0.2;
    grid.plane = GridPlane::horizontal;
    grid.top_centre_m = {0, 0, -0.1};
    Material material;
    material.thickness_m = *rc::gen::element(1.8e-5, 1e-4, 1e-3);
    const Mesh mesh = make_grid(grid);
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.max_stretch = 0.05, .threads = 1};
    settings.solver.max_substeps = 100;
    settings.frame_rate_hz = 24.0;
    Surroundings surroundings;
    surroundings.bodies = {some_body(some)};
    const Body& body = surroundings.bodies[0];
    if (entered(mesh, mesh.positions, body, 0.0) > 0) {
      return;
    }
    const std::vector<Index> pins = some.is_so() ? std::vector<Index>{} : std::vector<Index>{0, 24};
    Simulation simulation(share(make_garment(mesh, {}, material)), pins, settings, surroundings);
    try {
      for (int frame = 0; frame < 4; ++frame) {
        simulation.advance_frame();
        RC_ASSERT(entered(mesh, simulation.state().current, body, simulation.state().time_s) == 0U);
        touched += simulation.frame_report().contact.max_pairs > 0 ? 1 : 0;
        ++kept;
      }
    } catch (const ContactBlocked&) {  // a pin is in the body's path: the frame is refused
    }
  }));
  EXPECT_GT(kept, 250U) << "frames";
  EXPECT_GT(touched, 100U);
}

// Counts for the same lemma about regions alone: cloth is pushed anywhere, and the body moves in any direction.
struct Beside {
  std::size_t tried = 0;
  std::size_t pressed = 0;
};

void push_against(Body body, Numbers& some, Beside& beside) {
  using namespace bounded;
  if (std::holds_alternative<BodyMesh>(body.shape)) {
    return;  // soups test bodies that are meshes
  }
  body.motion.spin.turns_per_s *= *rc::gen::element(0.0, 1.0, 10.0);
  const Vec3 origin_m = some.vector(0.5);
  const TimeSpan time = {0.1, 0.1 + some.between(1e-4, 0.02)};
  const auto thickness_m = *rc::gen::element(1.8e-5F, 1e-3F);
  Mesh cloth;
  RowMoves rows;
  for (Index v = 0; v < block_size; ++v) {
    const Vec3 near_m = v % 3 == 0 ? some.vector(0.15) : to_vec3(rows.positions.back()) + origin_m;
    rows.positions.push_back(to_float4(near_m + some.vector(0.03) - origin_m));
    rows.moves.push_back(to_float4(some.vector(0.01)));
    rows.radii.push_back(static_cast<float>(some.between(0.0, 0.01)));
    rows.inverse_masses_per_kg.push_back(1e4F);
    cloth.positions.push_back(to_vec3(rows.positions.back()) + origin_m);
  }
  for (Index v = 0; v + 2 < block_size; v += 3) {
    const Mesh one = {cloth.positions, {{v, v + 1, v + 2}}, {}};
    const app::Corners triangle = {one.positions[v], one.positions[v + 1], one.positions[v + 2]};
    if (entered(one, one.positions, body, time.from_s) == 0 &&
        !begins_within_balls(triangle, shape_at(body, time.from_s))) {
      cloth.triangles.push_back(one.triangles[0]);
    }
  }
  rows.cloth_count = block_size;
  BodyContacts bodies({body}, 0.3, block_size);
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  Regions regions;
  bool fits = false;
  for (int search = 0; search < 8 && !fits; ++search) {
    rows.positions.resize(block_size);
    rows.moves.resize(block_size);
    rows.radii.resize(block_size);
    rows.inverse_masses_per_kg.resize(block_size);
    std::vector<ContactPair> pairs;
    bodies.add_near(cloth.triangles, thickness_m, time, origin_m, rows, pairs);
    fits = regions.make(pairs, rows, kernels);
  }
  if (!fits || regions.blocked()) {
    return;
  }
  ++beside.tried;
  const Float4Array since(block_size);
  for (int k = 0; k < 10; ++k) {
    Float4Array previous(block_size);
    Float4Array current(block_size);
    std::vector<Vec3> ends_m = cloth.positions;
    std::generate(current.begin(), current.end(), [&] { return to_float4(some.vector(0.1)); });
    const Float4Array pushed = current;
    regions.project_into_region(1.0F, {1.0F, 1.0F}, since, previous, current, kernels);
    for (std::size_t v = 0; v < block_size; ++v) {
      ends_m[v] += to_vec3(current[v]);
      beside.pressed += vector_length(scaled_sum(current[v], pushed[v], -1.0F)) > 0.0F ? 1 : 0;
    }
    RC_ASSERT(entered(cloth, ends_m, body, time.to_s) == 0U);
  }
}

TEST(Lemma, WhatIsWithinItsRegionIsOutsideOfABodyAtTheirEnd) {
  Beside beside;
  ASSERT_TRUE(holds("regions beside bodies", [&] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    for (int k = 0; k < 20; ++k) {
      push_against(some_body(some), some, beside);
    }
  }));
  EXPECT_GT(beside.tried, 800U);
  EXPECT_GT(beside.pressed, 20000U);
}

}  // namespace
}  // namespace taut::sim
