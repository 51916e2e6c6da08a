// The loops in which the bounded solver spends its time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <random>

#include "scalar_kernels.hpp"
#include "sheets.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/slow_forces.hpp"
#include "sim/step.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

/// Returns matrix rows with none to nine entries each.
std::vector<std::vector<MatrixEntry>> some_entries(std::size_t size, std::mt19937& random) {
  std::uniform_int_distribution<Index> column(0, static_cast<Index>(size) - 1);
  std::normal_distribution<double> value(0.0, 1.0);
  std::vector<std::vector<MatrixEntry>> rows(size);
  for (std::vector<MatrixEntry>& entries : rows) {
    entries.resize(column(random) % 10);
    for (MatrixEntry& e : entries) {
      e = {column(random), value(random)};
    }
  }
  return rows;
}

TEST(Kernels, ASlicedMatrixGivesTheProductOfItsEntries) {
  std::mt19937 random(5);
  const std::size_t size = 1000;
  const auto rows = some_entries(size, random);
  const SlicedMatrix matrix = make_sliced_matrix(rows);
  std::normal_distribution<double> metres(0.0, 1.0);
  std::vector<double> x(size);
  std::generate(x.begin(), x.end(), [&] { return metres(random); });
  Float4Array positions(size + block_size);
  for (std::size_t row = 0; row < size; ++row) {
    positions[row] = to_float4({x[row], 2.0 * x[row], -x[row]});
  }
  Float4Array result(size + block_size, Float4{1.0F, 2.0F, 3.0F, 0.0F});
  std::vector<double> doubles(size, 1.0);
  kernels_for(VectorUnit::best).add_product(matrix, 0, matrix.slice_count(), positions.data(), result.data());
  add_product(matrix, x, doubles);
  for (std::size_t row = 0; row < size; ++row) {
    double expected = 0.0;
    for (const MatrixEntry& e : rows[row]) {
      expected += e.value * (x[e.column] - x[row]);
    }
    EXPECT_NEAR(doubles[row], 1.0 + expected, 1e-5);
    EXPECT_NEAR(result[row].x, 1.0 + expected, 1e-5);
    EXPECT_NEAR(result[row].y, 2.0 + 2.0 * expected, 2e-5);
    EXPECT_NEAR(result[row].z, 3.0 - expected, 1e-5);
  }
}

/// Random input for all kernels: a sheet with two pins.
struct Inputs {
  Inputs();
  Float4Array random_rows();

  Garment garment = make_garment(irregular_sheet(23, 1.0));
  Layout layout = make_layout(garment, make_pins(garment, {0, 22}));
  SurfaceLanes surface = make_layout(garment, make_pins(garment, {0, 22}), BoundKind::surface).surface;
  std::mt19937 random{3};
  std::normal_distribution<float> metres{0.0F, 0.02F};
  Float4Array start = random_rows();
  Float4Array current = random_rows();
  Float4Array previous = random_rows();
  StartRows start_rows = {start, random_rows()};
  Lanes<Tether> tethers;
  Prediction prediction = {0.99F, 1e-6F, {0.01F, 0.02F, -0.01F, 0.0F}};
  Lanes<float> wind_fractions = Lanes<float>(layout.triangles.lane_count());
  AirFlow air = {{3.0F, -1.0F, 2.0F}, wind_fractions.data(), 0.7F, 0.03F, 0.02F, 1000.0F};
  SlicedMatrix matrix = make_sliced_matrix(some_entries(layout.vertex_count(), random));
  Float4Array opposed;
};

Inputs::Inputs() {
  std::generate(wind_fractions.begin(), wind_fractions.end(), [&] { return 0.7F + 10.0F * metres(random); });
  for (SpringBlock& block : layout.springs.blocks) {
    block.short_share.fill(0.1F);
    block.start_y.fill(0.05F);
    std::generate(block.start_x.begin(), block.start_x.end(), [&] { return metres(random); });
    std::generate(block.start_z.begin(), block.start_z.end(), [&] { return metres(random); });
  }
  surface.relaxation = 1.25F;
  for (SurfaceBlock& block : surface.blocks) {
    block.short_share.fill(0.1F);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::generate(block.start_along[axis].begin(), block.start_along[axis].end(),
                    [&] { return (axis == 0 ? 1.0F : 0.0F) + 10.0F * metres(random); });
      std::generate(block.start_across[axis].begin(), block.start_across[axis].end(),
                    [&] { return (axis == 1 ? 1.0F : 0.0F) + 10.0F * metres(random); });
    }
  }
  // One lane is stretched alike in all directions, and two are not stretched at all.
  for (std::size_t k : {0, 1, 2}) {
    surface.blocks[0].along_per_m[k] = surface.blocks[0].across_per_m[k] = surface.blocks[0].skew_per_m[k] =
        0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      surface.blocks[0].start_along[axis][k] = axis == 0 ? (k == 0 ? 1.5F : 1.0F) : 0.0F;
      surface.blocks[0].start_across[axis][k] = axis == 2 ? (k == 0 ? 1.5F : 1.0F) : 0.0F;
    }
  }
  for (const Float4& r : random_rows()) {
    tethers.push_back({r.x, r.y, r.z, 0.002F});
  }
  for (const Float4& r : random_rows()) {
    const bool is_free = layout.inverse_masses_per_kg[opposed.size()] > 0.0F;
    opposed.push_back({500.0F * r.x, 500.0F * r.y, 500.0F * r.z, is_free ? 1.0F : 0.0F});
  }
}

Float4Array Inputs::random_rows() {
  Float4Array rows(layout.row_count());
  for (Float4& r : rows) {
    r = {metres(random), metres(random), metres(random), 0.0F};
  }
  return rows;
}

/// The results of all kernels, by the name of the kernel.
std::map<std::string, Float4Array> run_kernels(const Kernels& kernels, const Inputs& in) {
  const SpringLanes& springs = in.layout.springs;
  std::vector<std::uint32_t> blocks(springs.block_count());
  std::iota(blocks.begin(), blocks.end(), 0U);
  std::map<std::string, Float4Array> results = {
      {"sweep", in.current},
      {"shorten", in.current},
      {"sweep_surface", in.current},
      {"sweep_surface with sums", in.current},
      {"sums of sweep_surface",
       Float4Array(in.surface.block_count() * sizeof(SurfaceSums) / sizeof(Float4))},
      {"shorten_surface", in.current},
      {"predict", in.previous},
      {"predict with tethers", in.previous},
      {"add_product", in.current},
      {"wind", Float4Array(in.layout.triangles.lane_count())},
      {"largest_ratios", Float4Array((blocks.size() + 3) / 4)},
      {"largest_surface_ratios", Float4Array(in.surface.block_count())}};
  std::vector<std::uint32_t> surface_blocks(in.surface.block_count());
  std::iota(surface_blocks.begin(), surface_blocks.end(), 0U);
  std::vector<SurfaceSums> sums(in.surface.block_count());
  for (const BlockRange& range : in.surface.sweep) {
    kernels.sweep_surface(in.surface, range, nullptr, results["sweep_surface"].data());
    kernels.sweep_surface(in.surface, range, sums.data(), results["sweep_surface with sums"].data());
  }
  std::memcpy(as_floats(results["sums of sweep_surface"].data()), sums.data(), sums.size() * sizeof(SurfaceSums));
  for (const auto [begin, end, again] : in.surface.sweep) {
    kernels.shorten_surface(in.surface, std::span(surface_blocks).subspan(begin, end - begin), 1.02F, 1.8F,
                            results["shorten_surface"].data());
  }
  kernels.find_max_surface_ratios(in.surface, 0, surface_blocks.size(), in.current.data(),
                                  as_floats(results["largest_surface_ratios"].data()));
  kernels.sweep(springs, 0, blocks.size(), results["sweep"].data());
  kernels.shorten(springs, blocks, 1.02F, 1.8F, results["shorten"].data());
  kernels.predict(0, in.layout.row_count(), in.prediction, nullptr, in.start.data(), in.current.data(),
                  results["predict"].data());
  kernels.predict(0, in.layout.row_count(), in.prediction, in.tethers.data(), in.start.data(),
                  in.current.data(), results["predict with tethers"].data());
  kernels.add_product(in.matrix, 0, in.matrix.slice_count(), in.start.data(), results["add_product"].data());
  kernels.wind(in.layout.triangles, in.air, 0, in.layout.triangles.lane_count(), in.start.data(),
               in.current.data(), in.previous.data(), in.opposed.data(), results["wind"].data());
  kernels.find_max_ratios(springs, 0, blocks.size(), in.current.data(), as_floats(results["largest_ratios"].data()));
  return results;
}

template <typename T>
bool same_bits(const Lanes<T>& a, const Lanes<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Kernels, EveryVectorUnitGivesTheBitsOfTheScalarLoops) {
  const Inputs in;
  const auto expected = run_kernels(scalar_kernels(), in);
  EXPECT_FALSE(same_bits(expected.at("sweep"), in.current));
  EXPECT_FALSE(same_bits(expected.at("shorten"), in.current));
  EXPECT_FALSE(same_bits(expected.at("sweep_surface"), in.current));
  EXPECT_TRUE(same_bits(expected.at("sweep_surface"), expected.at("sweep_surface with sums")));
  EXPECT_FALSE(same_bits(expected.at("shorten_surface"), in.current));
  EXPECT_FALSE(same_bits(expected.at("sweep_surface"), expected.at("shorten_surface")));
  for (const auto& [kernel, result] : expected) {
    EXPECT_TRUE(std::all_of(result.begin(), result.end(), [](const Float4& row) {
      return std::isfinite(row.x) && std::isfinite(row.y) && std::isfinite(row.z) &&
             std::isfinite(row.fourth);
    })) << kernel;
  }
  EXPECT_FALSE(same_bits(expected.at("predict"), expected.at("predict with tethers")));
  for (const VectorUnit unit : available_vector_units()) {
    for (const auto& [kernel, result] : run_kernels(kernels_for(unit), in)) {
      EXPECT_TRUE(same_bits(result, expected.at(kernel))) << kernel << " of " << to_name(unit);
    }
  }
}

TEST(Kernels, EveryVectorUnitStartsSpringsWithTheBitsOfTheScalarLoops) {
  const Inputs in;
  const auto started = [&](const Kernels& kernels) {
    SpringLanes springs = in.layout.springs;
    kernels.start_springs(in.start_rows, 0, springs.block_count(), springs);
    return springs.blocks;
  };
  EXPECT_FALSE(same_bits(started(scalar_kernels()), in.layout.springs.blocks));
  for (const VectorUnit unit : available_vector_units()) {
    EXPECT_TRUE(same_bits(started(kernels_for(unit)), started(scalar_kernels()))) << to_name(unit);
  }
}

TEST(Kernels, EveryVectorUnitStartsTrianglesWithTheBitsOfTheScalarLoops) {
  const Inputs in;
  const auto started = [&](const Kernels& kernels) {
    SurfaceLanes surface = in.surface;
    kernels.start_surface(in.start_rows, 0, surface.block_count(), surface);
    return surface.blocks;
  };
  EXPECT_FALSE(same_bits(started(scalar_kernels()), in.surface.blocks));
  for (const VectorUnit unit : available_vector_units()) {
    EXPECT_TRUE(same_bits(started(kernels_for(unit)), started(scalar_kernels()))) << to_name(unit);
  }
}

TEST(Kernels, AUnitTheProcessorLacksIsRefused) {
  for (const VectorUnit unit : all_vector_units) {
    const auto available = available_vector_units();
    if (std::find(available.begin(), available.end(), unit) == available.end()) {
      EXPECT_THROW(kernels_for(unit), std::invalid_argument);
    }
  }
}

TEST(Kernels, ThePredictionAgreesWithTheOtherSolvers) {
  const Inputs in;
  const double time_step_s = 0.002;
  const std::size_t count = in.layout.vertex_count();
  const std::vector<double> inverse_masses_per_kg(count, 4.0);
  std::vector<Vec3> previous, current, forces_n, expected(count);
  for (std::size_t row = 0; row < count; ++row) {
    previous.push_back(to_vec3(in.previous[row]));
    current.push_back(to_vec3(in.current[row]));
    forces_n.push_back(1e3 * to_vec3(in.start[row]));
  }
  predict_positions(previous, current, forces_n, inverse_masses_per_kg, time_step_s, expected);
  Float4Array accelerations;
  for (const Float4& start : in.start) {
    accelerations.push_back(to_float4(4e3 * to_vec3(start)));
  }
  const Prediction airless = {1.0F, static_cast<float>(time_step_s * time_step_s), {}};
  for (const VectorUnit unit : available_vector_units()) {
    Float4Array predicted = in.previous;
    kernels_for(unit).predict(0, in.layout.row_count(), airless, nullptr, accelerations.data(),
                              in.current.data(), predicted.data());
    for (std::size_t row = 0; row < count; ++row) {
      ASSERT_LT(glm::distance(to_vec3(predicted[row]), expected[row]), 2e-8) << to_name(unit) << ' ' << row;
    }
  }
}

TEST(Kernels, TheWindAgreesWithTheOtherSolvers) {
  const Garment garment = make_garment(irregular_sheet(9, 1.0));
  const Pins no_pins = make_pins(garment, {});
  const Layout layout = make_layout(garment, no_pins);
  State state = make_state(garment);
  set_time_step(state, 1e-3);
  for (std::size_t v = 0; v < state.current.size(); ++v) {
    const auto phase = static_cast<double>(v);
    state.current[v] += 0.001 * Vec3(std::sin(phase), std::cos(2.0 * phase), std::sin(3.0 * phase));
  }
  Wind wind;
  wind.speed_m_per_s = 8.0;
  wind.direction = {0.5, 0.1, 1.0};
  std::vector<float> fractions;
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    fractions.push_back(0.5F + 0.25F * static_cast<float>(t % 4));
  }
  std::vector<Vec3> expected(state.current.size(), Vec3(0.0));
  add_wind_forces(garment, state, wind, fractions, 2e-3, expected);

  SlowForces forces(garment, no_pins, layout, 0.0);
  Motion motion;
  motion.start_m = garment.mesh.positions;
  for (Float4Array* rows : {&motion.start.high, &motion.current, &motion.previous}) {
    rows->resize(layout.row_count());
  }
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Index v = layout.vertex_indices[row];
    motion.start.high[row] = to_float4(garment.mesh.positions[v]);
    motion.current[row] = to_float4(state.current[v] - garment.mesh.positions[v]);
  }
  ExternalForces external;
  external.gravity_m_per_s2 = {0, 0, 0};
  external.wind = wind;
  for (const VectorUnit unit : available_vector_units()) {
    ParallelKernels kernels(kernels_for(unit), 1);
    forces.begin_attempt({}, fractions);
    forces.update_wind(garment, external.wind, motion, 0.0, 1e-3, 2e-3, kernels);
    forces.update(garment, external, motion, 0.0, 1e-3, 1e-3, kernels);
    for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
      const Index v = layout.vertex_indices[row];
      const Vec3 force = to_vec3(forces.accelerations()[row]) * garment.masses_kg[v];
      EXPECT_LT(glm::length(force - expected[v]), 2e-4 * glm::length(expected[v])) << to_name(unit) << ", vertex " << v;
    }
  }
}

TEST(SlowForces, TheWindNeedNotFollowTheFastestWavesOfBending) {
  const Garment garment = make_garment(irregular_sheet(9, 1.0));
  const Pins no_pins = make_pins(garment, {});
  const Layout layout = make_layout(garment, no_pins);
  const SlowForces stiff(garment, no_pins, layout, 1.0);
  const SlowForces limp(garment, no_pins, layout, 0.0);
  ExternalForces external;
  external.wind.speed_m_per_s = 10.0;
  EXPECT_EQ(stiff.wind_updates_per_frame(1.0 / 60.0), limp.wind_updates_per_frame(1.0 / 60.0));
  EXPECT_GT(stiff.updates_per_frame(1.0 / 60.0), 3 * stiff.wind_updates_per_frame(1.0 / 60.0));
  external.wind.speed_m_per_s = 100.0;
  EXPECT_EQ(limp.updates_per_frame(1.0 / 60.0), limp.wind_updates_per_frame(1.0 / 60.0));
}

TEST(SlowForces, TheWindGoesOnAsItWasUntilItIsUpdated) {
  const Garment garment = make_garment(irregular_sheet(9, 1.0));
  const Pins no_pins = make_pins(garment, {});
  const Layout layout = make_layout(garment, no_pins);
  SlowForces forces(garment, no_pins, layout, 0.0);
  Motion motion;
  set_start(layout, garment.mesh.positions, motion.start);
  motion.start_m = garment.mesh.positions;
  motion.current.resize(layout.row_count());
  motion.previous.resize(layout.row_count());
  ExternalForces external;
  external.gravity_m_per_s2 = {0, -10, 0};
  external.wind.speed_m_per_s = 8.0;
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  const auto first_row_at = [&](double gravity) {
    external.gravity_m_per_s2.y = gravity;
    forces.update(garment, external, motion, 0.0, 1e-3, 1e-3, kernels);
    return to_vec3(forces.accelerations()[0]);
  };
  EXPECT_EQ(first_row_at(-10.0), Vec3(0, -10, 0));
  forces.update_wind(garment, external.wind, motion, 0.0, 1e-3, 2e-3, kernels);
  const Vec3 blown = first_row_at(0.0);
  EXPECT_LT(blown.z, -1.0);
  external.wind.speed_m_per_s = 0.0;
  EXPECT_EQ(first_row_at(0.0), blown);
  forces.update_wind(garment, external.wind, motion, 0.0, 1e-3, 2e-3, kernels);
  EXPECT_EQ(first_row_at(0.0), Vec3(0.0));
}

}  // namespace
}  // namespace taut::sim
