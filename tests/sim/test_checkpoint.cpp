#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <random>

#include "sim/bytes.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

/// Everything that moves a small cloth: gusts, shaken pins, obstacles, a force and a hand that yanks.
Surroundings storm() {
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = 6.0;
  surroundings.forces.wind.gust_amplitude = 0.5;
  surroundings.forces.wind.gust_turn = 0.2;
  surroundings.forces.artificial_forces = {{40, {0.0, 0.01, 0.02}}};
  surroundings.forces.grabbed_vertices = {{140, {0.3, -0.3, 1.0}, 20.0, 12.0}};
  surroundings.bodies = {{.shape = Plane{{0.0, -0.2, 0.0}}, .friction = 0.4},
                         {.shape = Sphere{{0.1, 0.3, -0.3}, 0.25}, .friction = 0.2}};
  surroundings.pin_motion = {{0.15, 0.0, 0.1}, 4.0};
  return surroundings;
}

Garment sheet() { return make_garment(make_grid({.columns = 13, .rows = 11})); }

/// A cloth that hangs over its middle row as over a line, so that two layers meet.
Garment cloth_on_a_line() {
  const Mesh lying = make_grid({.columns = 13, .rows = 11, .plane = GridPlane::horizontal});
  return make_garment(lying);
}

const std::vector<Index> corners = {0, 12};
const std::vector<Index> middle_row = {65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77};

SolverSettings solver_settings(SolverKind kind) {
  switch (kind) {
    case SolverKind::ideal:
      return {.method = IdealSettings{}};
    case SolverKind::provot:
      return {.method = ProvotSettings{.max_stretch = 0.1}};
    case SolverKind::strong:
      return {.method = StrongSettings{}};
    case SolverKind::vassilev:
      return {.method = VassilevSettings{.max_stretch = 0.02}};
    case SolverKind::fast_projection:
      return {.method = FastProjectionSettings{.max_strain = 0.01}};
    case SolverKind::implicit:
      return {.max_substeps = 32, .method = ImplicitSettings{.max_stretch_change = 0.02}};
    case SolverKind::bounded:
      break;
  }
  return {.method = BoundedSettings{.max_stretch = 0.002}};
}

struct Case {
  const char* name;
  Garment (*garment)();
  SolverKind solver;
  Surroundings surroundings;
  int frames;  ///< number of all simulated frames
  int every;   ///< number of frames between two checkpoints
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << to_name(c.solver) << ' ' << c.name; }

SimulationSettings case_settings(const Case& c) {
  SimulationSettings settings;
  settings.solver = solver_settings(c.solver);
  settings.rest_settings = {4e-3, 30};
  return settings;
}

/// The results of a frame that a resumed simulation has to repeat.
struct Shown {
  std::uint64_t state;
  FrameReport report;
  double time_s;
  std::uint64_t steps;
  double rms_speed_m_per_s;
  int quiet_frames;
  bool asleep;

  bool operator==(const Shown&) const = default;
};

Shown shown_by(const Simulation& simulation) {
  const State& state = simulation.state();
  return {hash(state),      simulation.frame_report(),      state.time_s,
          state.step_count, rms_speed(simulation.change()), state.quiet_frames,
          state.asleep};
}

class GoingOn : public testing::TestWithParam<Case> {
 protected:
  /// Expects the same frames from a new simulation that goes on from the bytes.
  void expect_same(const std::string& bytes, int from, const std::vector<Shown>& expected) const {
    const Garment garment = GetParam().garment();
    Simulation simulation(share(garment), middle_row, case_settings(GetParam()), GetParam().surroundings);
    simulation.restore(decode(bytes, garment));
    EXPECT_EQ(encode(simulation.save(), garment), bytes);
    for (int frame = from; frame < GetParam().frames; ++frame) {
      ASSERT_EQ(shown_by(simulation), expected[static_cast<std::size_t>(frame)])
          << "from " << from << ", frame " << frame;
      simulation.advance_frame();
    }
  }
};

TEST_P(GoingOn, FromAnyFrameGivesTheSameBits) {
  const Garment garment = GetParam().garment();
  Simulation simulation(share(garment), middle_row, case_settings(GetParam()), GetParam().surroundings);
  std::vector<Shown> shown;
  std::vector<std::string> saved;
  for (int frame = 0; frame < GetParam().frames; ++frame) {
    shown.push_back(shown_by(simulation));
    saved.push_back(encode(simulation.save(), garment));
    simulation.advance_frame();
  }
  bool before_fell_asleep = false;
  for (int frame = 0; frame < GetParam().frames; ++frame) {
    const auto f = static_cast<std::size_t>(frame);
    const bool falls_asleep = f + 1 < shown.size() && !shown[f].asleep && shown[f + 1].asleep;
    before_fell_asleep = before_fell_asleep || falls_asleep;
    if (frame % GetParam().every == 0 || falls_asleep) {
      expect_same(saved[f], frame, shown);
    }
  }
  EXPECT_EQ(before_fell_asleep, is_steady(GetParam().surroundings, 0.0));
}

const Case cases[] = {{"in a storm", cloth_on_a_line, SolverKind::ideal, storm(), 90, 9},
                      {"in a storm", cloth_on_a_line, SolverKind::provot, storm(), 90, 9},
                      {"in a storm", cloth_on_a_line, SolverKind::strong, storm(), 90, 9},
                      {"in a storm", cloth_on_a_line, SolverKind::bounded, storm(), 120, 3},
                      {"in a storm", cloth_on_a_line, SolverKind::vassilev, storm(), 90, 9},
                      {"in a storm", cloth_on_a_line, SolverKind::fast_projection, storm(), 45, 9},
                      {"in a storm", cloth_on_a_line, SolverKind::implicit, storm(), 45, 9},
                      {"at rest", cloth_on_a_line, SolverKind::strong, {}, 1200, 61},
                      {"at rest", cloth_on_a_line, SolverKind::bounded, {}, 900, 3}};
INSTANTIATE_TEST_SUITE_P(Checkpoint, GoingOn, testing::ValuesIn(cases));

std::string saved_in_a_storm(const SolverSettings& solver) {
  SimulationSettings settings;
  settings.solver = solver;
  Simulation simulation(share(sheet()), corners, settings, storm());
  for (int frame = 0; frame < 5; ++frame) {
    simulation.advance_frame();
  }
  return encode(simulation.save(), simulation.garment());
}

/// Returns the error message about these bytes, empty if a sheet in a storm goes on from them.
std::string refusal(const std::string& bytes, SolverKind solver = SolverKind::bounded) {
  SimulationSettings settings;
  settings.solver = solver_settings(solver);
  Simulation simulation(share(sheet()), corners, settings, storm());
  const auto before = hash(simulation.state());
  try {
    simulation.restore(decode(bytes, simulation.garment()));
  } catch (const BadBytes& error) {
    EXPECT_EQ(hash(simulation.state()), before);
    return error.what();
  }
  return "";
}

TEST(Checkpoint, RefusesEveryDamagedByteAndEveryLength) {
  const std::string whole = saved_in_a_storm(solver_settings(SolverKind::bounded));
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t at = 0; at < whole.size(); at += at < 100 ? 1 : 121) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_NE(refusal(damaged), "") << "byte " << at;
    EXPECT_NE(refusal(whole.substr(0, at)), "") << at << " bytes";
  }
  EXPECT_NE(refusal(whole + '\0'), "");
}

// Forged bytes whose hash fits are refused, or the simulation goes on from them as from any other shape.
TEST(Checkpoint, DoesNoHarmWhateverItsBytesAre) {
  for (const SolverMethod& method : {SolverMethod(StrongSettings{}), SolverMethod(BoundedSettings{})}) {
    SimulationSettings settings;
    settings.solver = {.max_substeps = 40, .method = method};
    const std::string whole = saved_in_a_storm(settings.solver);
    int taken = 0;
    for (std::size_t at = 44; at + 8 < whole.size(); at += at % 8 == 7 ? 1801 : 1) {
      std::string forged = whole.substr(0, whole.size() - 8);
      forged[at] = static_cast<char>(forged[at] ^ 0x40);
      const auto hash_bytes = little_endian(fnv1a(fnv1a_of_nothing, forged));
      forged.append(hash_bytes.data(), hash_bytes.size());
      Simulation simulation(share(sheet()), corners, settings, storm());
      try {
        simulation.restore(decode(forged, simulation.garment()));
        ++taken;
        simulation.advance_frame();
      } catch (const BadBytes&) {
      } catch (const Diverged&) {
      } catch (const ContactBlocked&) {
      }
    }
    EXPECT_GT(taken, 30);
  }
}

/// Two sheets that cross each other and a body, so that triangles of all three are left out of contact.
Garment crossing_sheets() {
  Mesh mesh = make_grid({.columns = 5, .rows = 5});
  Mesh lying = make_grid({.columns = 5, .rows = 5, .plane = GridPlane::horizontal});
  const auto count = static_cast<Index>(mesh.positions.size());
  const Vec3 down(0.013, -0.41 * mesh.positions[0].y, 0.007);
  for (const Vec3& p : lying.positions) mesh.positions.push_back(p + down);
  for (const auto& [a, b, c] : lying.triangles) mesh.triangles.push_back({a + count, b + count, c + count});
  mesh.quads.clear();
  Material material;
  material.tensile_warp_n_per_m = material.tensile_weft_n_per_m = 400.0;
  material.shear_n_per_m = 40.0;
  return make_garment(std::move(mesh), {}, material);
}

Simulation crossing_simulation(const SolverMethod& method) {
  const Garment garment = crossing_sheets();
  const auto tetrahedron = std::make_shared<BodyMeshData>();
  const Vec3 middle = garment.mesh.positions[12];
  tetrahedron->positions_m = {middle + Vec3(0.0, 0.1, 0.0), middle + Vec3(-0.09, -0.05, 0.05),
                              middle + Vec3(0.09, -0.05, 0.05), middle + Vec3(0.0, -0.05, -0.1)};
  tetrahedron->triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = 3.0;
  surroundings.bodies = {{.shape = BodyMesh{tetrahedron}, .friction = 0.3}};
  SimulationSettings settings;
  settings.solver = {.max_substeps = 40, .method = method};
  return Simulation(share(garment), {0, 4}, settings, surroundings);
}

template <class Number> void overwrite(std::string& bytes, std::size_t at, Number number) {
  const auto raw = little_endian(number);
  std::copy(raw.begin(), raw.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

std::string seal(std::string bytes) {
  const auto hash_bytes = little_endian(fnv1a(fnv1a_of_nothing, bytes));
  return bytes.append(hash_bytes.data(), hash_bytes.size());
}

/// Returns the number of forged checkpoints of each solver, which the environment variable can raise.
int trials() {
  const char* const more = std::getenv("TAUT_TEST_TRIALS");
  return more != nullptr ? std::atoi(more) : 200;
}

/// Goes on from the bytes for two frames. Returns whether they were accepted.
bool goes_on(const std::string& bytes, const SolverMethod& method) {
  Simulation simulation = crossing_simulation(method);
  try {
    simulation.restore(decode(bytes, simulation.garment()));
    simulation.advance_frame();
    simulation.advance_frame();
  } catch (const BadBytes&) {
    return false;
  } catch (const Diverged&) {
  } catch (const ContactBlocked&) {
  }
  return true;
}

// The bounded solver's memory ends with the last triangle left out of contact and this triangle's group.
TEST(Checkpoint, RefusesAGroupBeyondItsTriangles) {
  const SolverMethod method = BoundedSettings{.allow_crossing = true};
  Simulation simulation = crossing_simulation(method);
  simulation.advance_frame();
  const std::string whole = encode(simulation.save(), simulation.garment());
  ASSERT_TRUE(goes_on(whole, method));
  for (const Index group : {1000U, 1000000U, 0xFFFFFFFFU}) {
    std::string forged = whole.substr(0, whole.size() - 8);
    overwrite(forged, forged.size() - 4, group);
    EXPECT_FALSE(goes_on(seal(std::move(forged)), method)) << group;
  }
}

TEST(Checkpoint, WithAnyNumbersInItIsRefusedOrGoneOnFrom) {
  std::mt19937_64 random(20261127);
  const auto any_of = [&](const auto& values) { return values[random() % std::size(values)]; };
  const std::array words = {0U,          1U,          2U,          63U,         64U,
                            65U,         1000U,       0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU,
                            0x7F800000U, 0x7FC00000U, 0x7F7FFFFFU, 0x00000001U, 0x4B800000U};
  const std::array numbers = {0.0,
                              -1.0,
                              1e-320,
                              1e-30,
                              1e9,
                              1e30,
                              1e300,
                              -1e300,
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};
  for (const SolverMethod& method : {SolverMethod(BoundedSettings{.allow_crossing = true}),
                                     SolverMethod(BoundedSettings{}), SolverMethod(ImplicitSettings{})}) {
    Simulation simulation = crossing_simulation(method);
    simulation.advance_frame();
    const std::string whole = encode(simulation.save(), simulation.garment());
    for (int trial = 0; trial < trials(); ++trial) {
      std::string forged = whole.substr(0, whole.size() - 8);
      for (std::uint64_t field = random() % 4; field < 4; ++field) {
        // Most of the bytes are positions, so that half of all changes are made near the end or the beginning.
        const std::size_t reach =
            random() % 2 == 0 ? std::min<std::size_t>(300, forged.size() - 52) : forged.size() - 52;
        const std::size_t from_end = random() % reach + 8;
        const std::size_t at = random() % 4 == 0 ? 44 + random() % 40 : forged.size() - from_end;
        switch (random() % 3) {
          case 0:
            overwrite(forged, at, any_of(words));
            break;
          case 1:
            overwrite(forged, at, any_of(numbers));
            break;
          default:
            forged[at] = static_cast<char>(random());
            break;
        }
      }
      std::ignore = goes_on(seal(std::move(forged)), method);
    }
  }
}

TEST(Checkpoint, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("nothing of ours"), "byte 0, what the bytes are: found 'nothing ', expected 'TAUTSAVE'");
  EXPECT_EQ(refusal("TAUT"), "byte 0, what the bytes are: found 4 bytes, expected at least 8");
  std::string later = saved_in_a_storm(solver_settings(SolverKind::bounded));
  later[8] = 8;
  EXPECT_EQ(refusal(later), "byte 8, the version: found 8, expected 7");
  EXPECT_EQ(refusal(saved_in_a_storm(solver_settings(SolverKind::strong))),
            "what the solver 'strong' remembers, expected 'bounded'");
  const Garment other = make_garment(make_grid({}));
  const Simulation simulation(share(other), corners, {}, {});
  EXPECT_EQ(refusal(encode(simulation.save(), other)),
            "byte 12, the garment's number of vertices: found 81, expected 143");
}

TEST(Checkpoint, BelongsToTheGarmentAtRest) {
  GridSettings narrower{.columns = 13, .rows = 11};
  narrower.width_m *= 0.999;
  const Garment other = make_garment(make_grid(narrower));
  const Simulation simulation(share(other), corners, {}, {});
  EXPECT_NE(refusal(encode(simulation.save(), other)).find("the hash of the garment at rest"), std::string::npos);
}

TEST(Checkpoint, OfAnotherSizeIsNotTakenOver) {
  const Garment small = make_garment(make_grid({}));
  Simulation simulation(share(sheet()), corners, {}, {});
  EXPECT_THROW(simulation.restore(Simulation(share(small), {0, 8}, {}, {}).save()), BadBytes);
}

}  // namespace
}  // namespace taut::sim
