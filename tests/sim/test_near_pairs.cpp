// Pairs that could meet, compared with a search through all pairs in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "all_pairs.hpp"
#include "sheets.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"
#include "sim/solvers/bounded/contact/lasting_pairs.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

/// Returns a name that does not depend on the order of a pair's two edges.
std::array<Index, 5> to_name(const NearPair& pair) {
  std::array<Index, 4> r = pair.rows;
  if (pair.first_count == 2 && std::tie(r[2], r[3]) < std::tie(r[0], r[1])) {
    r = {r[2], r[3], r[0], r[1]};
  }
  return {pair.first_count, r[0], r[1], r[2], r[3]};
}

/// Compares the pairs found with all pairs. Returns how many of all pairs certainly could meet.
std::size_t expect_what_is_near(const Scene& scene, std::span<const NearPair> pairs) {
  // Boxes are rounded to a grid of 65 530 numbers across the cloth and its reach.
  const std::vector<Vec3> places_m = scene.places_m();
  const Vec3 size_m = compute_extent(places_m).size();
  const double grid_m = (std::max({size_m.x, size_m.y, size_m.z}) + 0.05) / 65530.0;
  std::set<std::array<Index, 5>> found;
  for (const NearPair& pair : pairs) {
    EXPECT_TRUE(found.insert(to_name(pair)).second) << "found twice";
  }
  std::size_t near = 0;
  for (const NearPair& pair : all_pairs(scene.mesh())) {
    const auto [gap_m, reach_m, tolerance_m] = measure_gap(pair, scene);
    const bool is_found = found.erase(to_name(pair)) == 1;
    if (!boxes_overlap(pair, scene, grid_m) || gap_m > reach_m + tolerance_m) {
      EXPECT_FALSE(is_found) << pair.first_count << ": " << gap_m << " m, reach " << reach_m;
    } else if (boxes_overlap(pair, scene) && gap_m < reach_m - tolerance_m) {
      ++near;
      EXPECT_TRUE(is_found) << pair.first_count << ": " << gap_m << " m, reach " << reach_m;
    }
  }
  EXPECT_TRUE(found.empty()) << found.size() << " pairs that may not be found at all";
  return near;
}

Float4Array some_vectors(std::size_t count, float size, std::mt19937& random) {
  std::uniform_real_distribution<float> metres(-size, size);
  Float4Array vectors(count);
  for (Float4& v : vectors) {
    v = {metres(random), metres(random), metres(random), 0.0F};
  }
  return vectors;
}

std::vector<float> some_radii(std::size_t count, float largest, std::mt19937& random) {
  std::uniform_real_distribution<float> metres(0.0F, largest);
  std::vector<float> radii(count);
  std::generate(radii.begin(), radii.end(), [&] { return metres(random); });
  return radii;
}

/// Triangles of cloth that share corners at random, and two thirds as many triangles of a body.
Scene soup(Index triangles, unsigned seed) {
  std::mt19937 random(seed);
  const Index rows = triangles * 2;
  std::uniform_int_distribution<Index> of_cloth(0, rows / 2 - 1);
  std::uniform_int_distribution<Index> of_body(rows / 2, rows - 1);
  Scene scene;
  for (Index t = 0; t < triangles; ++t) {
    const Index a = of_cloth(random);
    scene.cloth.push_back({a, (a + 1) % (rows / 2), (a + 2 + of_cloth(random) % 3) % (rows / 2)});
    if (t % 3 != 0) {
      const Index b = of_body(random) - rows / 2;
      scene.bodies.push_back({rows / 2 + b, rows / 2 + (b + 1) % (rows / 2), rows / 2 + (b + 2) % (rows / 2)});
    }
  }
  for (std::vector<Triangle>* triangles_of : {&scene.cloth, &scene.bodies}) {
    std::sort(triangles_of->begin(), triangles_of->end());
    triangles_of->erase(std::unique(triangles_of->begin(), triangles_of->end()), triangles_of->end());
  }
  scene.positions = some_vectors(rows, 0.1F, random);
  for (Index row = 1; row < rows; ++row) {
    // Each vertex is near the one before it, so that triangles are small.
    const Float4 before = scene.positions[row - 1];
    scene.positions[row] = scaled_sum(before, scene.positions[row], row % 7 == 0 ? -1.0F : 0.2F);
  }
  scene.moves = some_vectors(rows, 0.01F, random);
  scene.radii = some_radii(rows, 0.005F, random);
  scene.together = mean_position(scene.moves);
  return scene;
}

/// A sheet folded onto itself, its layers 1 mm apart, which moves as a whole and a little in itself.
Scene folded_sheet(Index count) {
  std::mt19937 random(11);
  const Mesh mesh = irregular_sheet(count, 1.0);
  Scene scene;
  scene.cloth = mesh.triangles;
  scene.moves = some_vectors(mesh.positions.size(), 0.001F, random);
  for (std::size_t row = 0; row < mesh.positions.size(); ++row) {
    Vec3 p = mesh.positions[row];
    const double middle = mesh.positions[0].x + 0.5;
    p.z += p.x > middle ? 0.001 : 0.0;
    p.x = std::min(p.x, 2.0 * middle - p.x);
    scene.positions.push_back(to_float4(p));
    add_scaled(scene.moves[row], {0.02F, -0.05F, 0.01F, 0.0F}, 1.0F);
  }
  scene.radii = some_radii(mesh.positions.size(), 0.001F, random);
  scene.together = mean_position(scene.moves);
  return scene;
}

TEST(NearPairs, AreThoseOfASearchThroughAll) {
  for (const Scene& scene : {soup(100, 1), soup(100, 2)}) {
    EXPECT_GT(expect_what_is_near(scene, scene.find()), 100U);
  }
  const Scene scene = folded_sheet(20);
  EXPECT_GT(expect_what_is_near(scene, scene.find()), 500U);
}

/// Changes the radii and moves of some vertices. Returns marks of them.
std::vector<std::uint8_t> change_some(Scene& scene, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution is_marked(0.1);
  std::vector<std::uint8_t> marks(scene.positions.size());
  for (std::size_t row = 0; row < marks.size(); ++row) {
    if (is_marked(random)) {
      marks[row] = 1;
      scene.radii[row] += 0.003F;
      add_scaled(scene.moves[row], {0.001F, 0.002F, -0.003F, 0.0F}, 1.0F);
    }
  }
  return marks;
}

TEST(NearPairs, AroundRowsThatMoveOtherwiseAreFoundAnew) {
  for (Scene scene : {soup(100, 1), folded_sheet(20)}) {
    ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
    NearPairs pairs(scene.mesh(), true, scene.places_m());
    pairs.find(scene.positions, scene.moves, scene.radii, kernels);
    scene.together = mean_position(scene.moves);
    const std::vector<std::uint8_t> marks = change_some(scene, 7);
    EXPECT_GT(expect_what_is_near(scene, pairs.find_anew(marks, scene.positions, scene.moves, scene.radii, kernels)),
              100U);
  }
}

/// Sets `now` to the predicted motion between two parts of the time. Vertices deviate from it a little, every 50th a
/// hundred times as far.
void go_on(const Scene& scene, float from, float to, unsigned seed, Scene& now) {
  std::mt19937 random(seed);
  const Float4Array off = some_vectors(scene.positions.size(), 3e-4F, random);
  for (std::size_t row = 0; row < off.size(); ++row) {
    const bool keeps_to_it = row % 50 != 0;
    now.positions[row] = scaled_sum(scene.positions[row], scene.moves[row], from);
    add_scaled(now.positions[row], off[row], keeps_to_it ? 1.0F : 100.0F);
    now.moves[row] = multiply(scene.moves[row], to - from);
  }
}

/// Expects `lasting` to find all pairs that could meet in `now`.
void expect_all_near(const Scene& now, const TimeSpan& time, LastingPairs& lasting) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  std::set<std::array<Index, 5>> names;
  for (const NearPair& pair : lasting.find({now.positions, now.moves, now.radii, time}, 1.0, 0.1F, kernels)) {
    EXPECT_TRUE(names.insert(to_name(pair)).second) << "found twice";
  }
  std::size_t near = 0;
  for (const NearPair& pair : now.find()) {
    near += names.count(to_name(pair));
  }
  EXPECT_EQ(near, now.find().size()) << time.from_s;
  EXPECT_GT(near, 1000U);
}

TEST(LastingPairs, AreAllThatAreNear) {
  const Scene scene = folded_sheet(30);
  LastingPairs lasting(scene.mesh(), true, scene.places_m());
  for (const float part : {0.0F, 0.25F, 0.5F, 0.75F}) {
    Scene now = scene;
    go_on(scene, part, part + 0.25F, static_cast<unsigned>(100.0F * part), now);
    expect_all_near(now, {part, part + 0.25}, lasting);
  }
}

// Rounds of a correction search like this: no time passes, and a few vertices have moved.
TEST(LastingPairs, AreAllThatAreNearAtAMomentAgainAndAgain) {
  const Scene scene = folded_sheet(30);
  for (const double began_s : {0.0, 0.5, 1.0}) {
    LastingPairs lasting(scene.mesh(), true, scene.places_m());
    Scene now = scene;
    expect_all_near(now, {began_s, 1.0}, lasting);
    std::mt19937 random(5);
    for (int round = 0; round < 3; ++round) {
      const Float4Array off = some_vectors(now.positions.size(), 0.03F, random);
      for (std::size_t row = 0; row < off.size(); ++row) {
        const bool keeps_to_it = row % 50 != 0;
        now.positions[row] = scaled_sum(scene.positions[row], scene.moves[row], began_s < 1.0 ? 1.0F : 0.0F);
        now.moves[row] = began_s < 1.0 ? Float4{} : scene.moves[row];
        add_scaled(now.positions[row], off[row], keeps_to_it ? 0.0F : 1.0F);
      }
      expect_all_near(now, {1.0, 1.0}, lasting);
    }
    EXPECT_GE(lasting.take_searches().marked, 2);
  }
}

TEST(NearPairs, AreTheSameInTheSameOrderForEveryVectorUnitAndAnyThreads) {
  for (const Scene& scene : {soup(500, 4), folded_sheet(40), folded_sheet(100)}) {
    const std::vector<NearPair> expected = scene.find(VectorUnit::scalar);
    EXPECT_FALSE(expected.empty());
    for (const VectorUnit unit : available_vector_units()) {
      EXPECT_EQ(scene.find(unit), expected) << sim::to_name(unit);
    }
    for (const int threads : {2, 3, 4}) {
      EXPECT_EQ(scene.find(VectorUnit::best, threads), expected) << threads;
    }
  }
}

/// Two triangles whose corners lie in a box of this size.
Scene two_triangles(const Float4& size_m, std::mt19937& random) {
  Scene scene;
  scene.cloth = {{0, 1, 2}, {3, 4, 5}};
  scene.positions = some_vectors(6, 1.0F, random);
  for (Float4& p : scene.positions) {
    p = {p.x * size_m.x, p.y * size_m.y, p.z * size_m.z, 0.0F};
  }
  scene.moves.resize(6);
  scene.radii.resize(6);
  return scene;
}

// The sizes include thin triangles and nearly parallel edges.
TEST(NearPairs, AreNearIfTheirDistanceIsLessThanTheirRadii) {
  std::mt19937 random(9);
  for (const Float4& size_m :
       {Float4{0.02F, 0.02F, 0.02F, 0.0F}, Float4{0.02F, 0.02F, 1e-3F, 0.0F}, Float4{0.02F, 1e-3F, 1e-3F, 0.0F},
        Float4{0.02F, 1e-4F, 1e-3F, 0.0F}, Float4{0.02F, 0.0F, 1e-3F, 0.0F}}) {
    for (int k = 0; k < 40; ++k) {
      Scene scene = two_triangles(size_m, random);
      for (const NearPair& pair : all_pairs(scene.mesh())) {
        const auto is_found = [&](double reach) {
          std::fill(scene.radii.begin(), scene.radii.end(), static_cast<float>(0.5 * reach));
          const std::vector<NearPair> found = scene.find();
          return std::any_of(found.begin(), found.end(),
                             [&](const NearPair& f) { return to_name(f) == to_name(pair); });
        };
        const auto [distance, reach, rounding] = measure_gap(pair, scene);
        EXPECT_TRUE(is_found(distance * (1.0 + 1e-6))) << pair.first_count << ' ' << size_m.y;
        // A touching pair has no line between its nearest points.
        if (distance > rounding) {
          EXPECT_FALSE(is_found(distance * (1.0 - 2e-5) - rounding))
              << pair.first_count << ": " << distance << " m, " << size_m.y;
        }
      }
    }
  }
}

TEST(NearPairs, AreNotSoughtWithinBodiesOrWhereThereIsNothing) {
  Scene scene = soup(100, 5);
  EXPECT_FALSE(scene.find().empty());
  scene.bodies.insert(scene.bodies.end(), scene.cloth.begin(), scene.cloth.end());
  scene.cloth.clear();
  EXPECT_TRUE(scene.find().empty());
  scene.bodies.clear();
  EXPECT_TRUE(scene.find().empty());
}

TEST(NearPairs, ComeAnewFromTheSamePositionsAndFromOthers) {
  const Scene scene = folded_sheet(20);
  std::vector<Vec3> flat;
  for (const Vec3& p : irregular_sheet(20, 1.0).positions) {
    flat.push_back(p);
  }
  NearPairs pairs(scene.mesh(), true, flat);
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  const std::vector<NearPair> first = pairs.find(scene.positions, scene.moves, scene.radii, kernels);
  Float4Array away = scene.positions;
  for (std::size_t row = 0; row < away.size(); ++row) {
    away[row] = to_float4(10.0 * flat[row]);
  }
  EXPECT_TRUE(pairs.find(away, Float4Array(away.size()), std::vector<float>(away.size()), kernels).empty());
  EXPECT_EQ(pairs.find(scene.positions, scene.moves, scene.radii, kernels), first);
  std::set<std::array<Index, 5>> names, names_in_other_order;
  for (const NearPair& pair : first) {
    names.insert(to_name(pair));
  }
  for (const NearPair& pair : scene.find()) {
    names_in_other_order.insert(to_name(pair));
  }
  EXPECT_EQ(names, names_in_other_order);
}

// Two triangles of cloth 0.3 m apart that do not share a vertex, and one of a body 0.2 m below the lower.
TEST(Clearances, AreTheDistancesOfTheNearestLayers) {
  std::vector<Vec3> positions_m;
  for (const double height_m : {0.0, 0.3, -0.2}) {
    positions_m.insert(positions_m.end(), {{0, height_m, 0}, {1, height_m, 0}, {0, height_m, 1}});
  }
  const std::vector<Triangle> cloth{{0, 1, 2}, {3, 4, 5}};
  const std::vector<Triangle> body{{6, 7, 8}};
  const auto expect = [&](bool within_cloth, float most_m, std::array<float, 3> expected_m) {
    Clearances clearances(cloth, body, within_cloth, positions_m);
    const std::span<const float> found_m = clearances.find(positions_m, most_m);
    ASSERT_EQ(found_m.size(), positions_m.size());
    for (std::size_t v = 0; v < found_m.size(); ++v) {
      EXPECT_NEAR(found_m[v], expected_m[v / 3], 1e-6F) << v;
    }
  };
  expect(true, 1.0F, {0.2F, 0.3F, 0.2F});
  expect(true, 0.25F, {0.2F, 0.25F, 0.2F});
  expect(false, 0.4F, {0.2F, 0.4F, 0.2F});
}

}  // namespace
}  // namespace taut::sim
