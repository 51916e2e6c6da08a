#include <gtest/gtest.h>

#include <cmath>

#include "sim/local_wind.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

constexpr double side_m = 0.6;

/// Returns square sheets of 0.6 m across a wind along -z, one for each place.
Garment make_sheets(const std::vector<Vec3>& places_m, GridPlane plane = GridPlane::vertical) {
  Mesh mesh;
  for (const Vec3& place_m : places_m) {
    const Mesh sheet = make_grid({.columns = 31, .rows = 31, .width_m = side_m, .height_m = side_m, .plane = plane});
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const Vec3& p : sheet.positions) mesh.positions.push_back(p + place_m);
    for (const Triangle& t : sheet.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return make_garment(std::move(mesh));
}

Surroundings in_wind(double speed_m_per_s = 10.0) {
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = speed_m_per_s;
  surroundings.forces.wind.direction = {0, 0, -1};
  return surroundings;
}

std::vector<float> fractions_of(const Garment& garment, const Surroundings& surroundings, double time_s = 0.0) {
  return find_wind_fractions(garment, garment.mesh.positions, surroundings, time_s);
}

double strength_at(const Wind& wind, double time_s, const Vec3& point_m) {
  return GustField(wind, time_s).strength(point_m);
}

/// Returns the mean fraction that one of several equal sheets meets.
double mean_of_sheet(const std::vector<float>& fractions, std::size_t sheet, std::size_t sheets) {
  const std::size_t count = fractions.size() / sheets;
  double sum = 0.0;
  for (std::size_t t = 0; t < count; ++t) sum += static_cast<double>(fractions[sheet * count + t]);
  return sum / static_cast<double>(count);
}

TEST(WindFractions, AreNoneWithoutWindAndOneOnASheetAlone) {
  const Garment alone = make_sheets({{0, 0, 0}});
  EXPECT_TRUE(fractions_of(alone, in_wind(0.0)).empty());
  for (const float fraction : fractions_of(alone, in_wind())) ASSERT_EQ(fraction, 1.0F);
}

TEST(WindFractions, AreSmallInTheLeeOfASheetAndOneBesideIt) {
  const Garment sheets = make_sheets({{0, 0, 0}, {0, 0, -0.2}, {0.8, 0, -0.2}, {0, 0, -1.5}});
  const std::vector<float> fractions = fractions_of(sheets, in_wind());
  EXPECT_EQ(mean_of_sheet(fractions, 0, 4), 1.0);
  EXPECT_NEAR(mean_of_sheet(fractions, 1, 4), lee_velocity_fraction, 0.03);
  EXPECT_EQ(mean_of_sheet(fractions, 2, 4), 1.0);
  EXPECT_NEAR(mean_of_sheet(fractions, 3, 4), lee_velocity_fraction, 0.03);
  for (const float fraction : fractions) EXPECT_GE(fraction, static_cast<float>(lee_velocity_fraction) - 1e-5F);
}

TEST(WindFractions, AreOneOnSheetsAlongTheWind) {
  const Garment along = make_sheets({{0, 0, 0}, {0, 0, -0.8}}, GridPlane::horizontal);
  for (const float fraction : fractions_of(along, in_wind())) ASSERT_EQ(fraction, 1.0F);
}

TEST(WindFractions, ChangeLittleWhileClothMovesLittle) {
  const double step_m = 1e-3;
  const Garment sheets = make_sheets({{0, 0, 0}, {0.31, 0.1, -0.2}});
  std::vector<Vec3> positions_m = sheets.mesh.positions;
  const std::size_t half = positions_m.size() / 2;
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    std::vector<float> before = find_wind_fractions(sheets, positions_m, in_wind(), 0.0);
    for (int step = 0; step < 100; ++step) {
      for (std::size_t v = half; v < positions_m.size(); ++v) positions_m[v] += step_m * way;
      const std::vector<float> now = find_wind_fractions(sheets, positions_m, in_wind(), 0.0);
      for (std::size_t t = 0; t < now.size(); ++t) ASSERT_NEAR(now[t], before[t], 0.05) << step << ' ' << t;
      before = now;
    }
  }
}

TEST(WindFractions, AreSmallInTheLeeOfEveryBodyButAPlane) {
  const Garment sheet = make_sheets({{0, 0, 0}});
  const double around_m = 0.6;
  BodyMeshData wall;
  wall.positions_m = {{-1, -1, 0.3}, {1, -1, 0.3}, {1, 1, 0.3}, {-1, 1, 0.3}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Body bodies[] = {{.shape = Sphere{{0, 0, 1.0}, around_m}},
                         {.shape = Capsule{{0, -1, 1.0}, {0, 1, 1.0}, around_m, around_m}},
                         {.shape = BodyMesh{std::make_shared<const BodyMeshData>(wall)}}};
  for (const Body& body : bodies) {
    Surroundings surroundings = in_wind();
    surroundings.bodies = {body};
    const std::vector<float> fractions = fractions_of(sheet, surroundings);
    EXPECT_NEAR(mean_of_sheet(fractions, 0, 1), lee_velocity_fraction, 0.03) << body.shape.index();
    surroundings.forces.wind.direction = {0, 0, 1};
    EXPECT_EQ(mean_of_sheet(fractions_of(sheet, surroundings), 0, 1), 1.0) << "upwind of it";
  }
  Surroundings ground = in_wind();
  ground.bodies = {{.shape = Plane{{0, 0, 1.0}, {0, 0, -1}}}};
  EXPECT_EQ(mean_of_sheet(fractions_of(sheet, ground), 0, 1), 1.0);
}

TEST(Gusts, TravelWithTheWind) {
  Wind wind = in_wind().forces.wind;
  wind.gust_amplitude = 0.5;
  double change = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double time_s = 0.07 * k;
    const Vec3 point_m = {0.3, 0.2, 0.1};
    const Vec3 downwind_m = point_m + Vec3(0, 0, -5.0);
    EXPECT_NEAR(strength_at(wind, time_s + 0.5, downwind_m), strength_at(wind, time_s, point_m), 1e-9);
    change = std::max(change, std::abs(strength_at(wind, time_s, downwind_m) - strength_at(wind, time_s, point_m)));
  }
  EXPECT_GT(change, 0.2) << "it is not the same everywhere";
}

TEST(Gusts, HaveTheTurbulenceIntensityOfTheirAmplitude) {
  Wind wind = in_wind().forces.wind;
  wind.gust_amplitude = 0.5;
  double sum = 0.0, squares = 0.0;
  constexpr int count = 200000;
  for (int k = 0; k < count; ++k) {
    const double strength = strength_at(wind, 0.1 * k, Vec3(3.0 * k, 0, 0));
    sum += strength;
    squares += strength * strength;
  }
  const double mean = sum / count;
  EXPECT_NEAR(mean, 1.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), turbulence_per_amplitude * wind.gust_amplitude, 0.01);
}

TEST(WindFractions, DependLittleOnTheMesh) {
  std::vector<double> means;
  for (const Index columns : {5U, 12U, 61U}) {
    const Mesh sheet = make_grid({.columns = columns, .rows = columns, .width_m = side_m, .height_m = side_m});
    Mesh mesh = sheet;
    for (const Vec3& p : sheet.positions) mesh.positions.push_back(p + Vec3(0.2, 0.1, -0.1));
    const auto first = static_cast<Index>(sheet.positions.size());
    for (const Triangle& t : sheet.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    means.push_back(mean_of_sheet(fractions_of(make_garment(std::move(mesh)), in_wind()), 1, 2));
  }
  EXPECT_NEAR(means[0], means[2], 0.04);
  EXPECT_NEAR(means[1], means[2], 0.03);
  EXPECT_LT(means[2], 0.85);
}

TEST(WindFractions, AreThoseOfGusts) {
  Surroundings surroundings = in_wind();
  surroundings.forces.wind.gust_amplitude = 0.5;
  const Garment sheet = make_sheets({{0, 0, 0}});
  const std::vector<float> fractions = fractions_of(sheet, surroundings, 1.25);
  for (std::size_t t = 0; t < fractions.size(); ++t) {
    const auto corners = corner_positions(sheet.mesh.triangles[t], sheet.mesh.positions);
    const Vec3 middle_m = (corners[0] + corners[1] + corners[2]) / 3.0;
    ASSERT_NEAR(fractions[t], strength_at(surroundings.forces.wind, 1.25, middle_m), 1e-6);
  }
}

TEST(WindFractions, OfASimulationAreThoseOfItsPresentShapeAndWind) {
  Surroundings gusts = in_wind();
  gusts.forces.wind.gust_amplitude = 0.5;
  Simulation simulation(share(make_sheets({{0, 0, 0}, {0.3, 0, -0.1}})), {0, 30}, {}, gusts);
  const auto expect_present = [&](const char* when) {
    const std::vector<float> expected = find_wind_fractions(simulation.garment(), simulation.state().current,
                                                            simulation.surroundings(), simulation.state().time_s);
    EXPECT_EQ(simulation.wind_fractions(), expected) << when;
  };
  expect_present("at the start");
  const Checkpoint start = simulation.save();
  simulation.advance_frame();
  expect_present("after a frame");
  simulation.set_time(0.5);
  expect_present("at another time");
  simulation.set_surroundings(in_wind(5.0));
  expect_present("in another wind");
  simulation.restore(start);
  expect_present("restored");
}

}  // namespace
}  // namespace taut::sim
