// Experiments in wind: the list of all, a hanging sheet's angle, and the drag of a flag.

#include "tests/study/claims/truth_wind.hpp"

#include "sim/local_wind.hpp"

namespace taut::app::truth {
namespace {

/// Returns the angle to the vertical at which a sheet hangs straight in a level wind: its weight across it is the force
/// of the air, g w sin(angle) = 1/2 rho U^2 C_N(90 degrees - angle), where C_N(a) is that of add_wind_forces.
double hanging_angle(double speed_m_per_s, double density_kg_per_m2, double coefficient) {
  const double pressure = 0.5 * sim::air_density_kg_per_m3 * speed_m_per_s * speed_m_per_s * coefficient;
  double low = 0.0, high = 0.5 * pi;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    const double force = pressure * (4.0 + pi) * std::cos(middle) / (4.0 + pi * std::cos(middle));
    (force > density_kg_per_m2 * gravity_m_per_s2 * std::sin(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Measures the angle of a sheet that hangs from a row of pins, once it is still.
std::vector<TruthPoint> hang_sheet(const Size& size, double speed_m_per_s, double physics) {
  const Material material;
  Surroundings windy;
  sim::Wind& wind = windy.forces.wind;
  wind.speed_m_per_s = speed_m_per_s;
  wind.friction_coefficient = 0.0;
  const double expected = hanging_angle(speed_m_per_s, material.areal_density_kg_per_m2, wind.pressure_coefficient);
  wind.pressure_coefficient *= physics;
  sim::Simulation simulation = begin(rectangle(size, 0.4, 0.4, sim::GridPlane::vertical), material,
                                     vertices_from(0, size.across), std::move(windy));
  advance(simulation, 60 * 8);
  Vec3 below(0.0);
  constexpr int averaged_frames = 60;
  for (int frame = 0; frame < averaged_frames; ++frame) {
    simulation.advance_frame();
    const std::vector<Vec3>& now_m = simulation.state().current;
    below += (now_m[now_m.size() - 1 - size.across / 2] - now_m[size.across / 2]) / double{averaged_frames};
  }
  return {{"sheet", speed_m_per_s, std::atan2(-below.z, -below.y) * 180.0 / pi, expected * 180.0 / pi}};
}

/// Returns a flag at rest beside its pole, a little uneven: nothing would start a flat one to flap.
std::vector<Vec3> uneven_flag(const std::vector<Vec3>& flat_m, double length_m) {
  std::vector<Vec3> positions_m = flat_m;
  for (Vec3& p : positions_m) {
    const double from_pole = (p.x - flat_m.front().x) / length_m;
    p.z += 0.02 * length_m * from_pole * from_pole * std::sin((3.0 * p.y + 5.0 * from_pole * length_m) / length_m);
  }
  return positions_m;
}

/// Returns the drag coefficient of a free flag, whose dynamic part grows with its mass (AS/NZS 1170.2, appendix F).
double flag_drag(const Flag& flag) {
  const double aspect = flag.length_m / flag.height_m;
  return 0.05 + 0.7 * flag.density_kg_per_m2 / (sim::air_density_kg_per_m3 * flag.height_m) * std::pow(aspect, -1.25);
}

/// Measures the mean force of the wind on a flag on its pole, over pressure of the wind and area.
std::vector<TruthPoint> fly_flag(const Size& size, const Flag& flag, double speed_m_per_s, double physics) {
  sim::Simulation simulation = hoist_flag(size, flag, speed_m_per_s, physics);
  advance(simulation, flag_settling_frames);
  Vec3 force_n(0.0);
  for (int frame = 0; frame < flag_watched_frames; ++frame) {
    simulation.advance_frame();
    const sim::WindLoad load = sim::measure_wind(simulation.garment(), simulation.state(),
                                                 simulation.surroundings().forces.wind, simulation.wind_fractions());
    force_n += load.force_n / double{flag_watched_frames};
  }
  const double area_m2 = flag.length_m * flag.height_m;
  const double pressure = 0.5 * sim::air_density_kg_per_m3 * speed_m_per_s * speed_m_per_s;
  return {{fmt::format("{:g} g/m2", 1e3 * flag.density_kg_per_m2), speed_m_per_s, force_n.x / (pressure * area_m2),
           flag_drag(flag)}};
}

}  // namespace

sim::Simulation hoist_flag(const Size& size, const Flag& flag, double speed_m_per_s, double physics) {
  Material material;
  material.areal_density_kg_per_m2 = flag.density_kg_per_m2;
  sim::Mesh mesh = rectangle(size, flag.length_m, flag.height_m, sim::GridPlane::vertical);
  std::vector<Index> pins;
  for (Index row = 0; row < size.along; ++row) pins.push_back(row * size.across);
  Surroundings windy;
  windy.forces.wind.direction = {1.0, 0.0, 0.0};
  windy.forces.wind.speed_m_per_s = speed_m_per_s;
  windy.forces.wind.pressure_coefficient *= physics;
  std::vector<Vec3> start_m = uneven_flag(mesh.positions, flag.length_m);
  return begin(std::move(mesh), material, std::move(pins), std::move(windy), false, std::move(start_m));
}

std::vector<TruthPoint> run_hanging(double physics, const ProgressCallback& report) {
  return run_all(std::array{0.5, 1.0, 1.5, 2.0, 3.0}, std::array{Size{9, 9}, Size{13, 13}, Size{19, 19}}, report,
                 [&](double speed_m_per_s, const Size& size) { return hang_sheet(size, speed_m_per_s, physics); });
}

std::vector<TruthPoint> run_flag(double physics, const ProgressCallback& report) {
  std::vector<std::pair<Flag, double>> cases;
  for (const double density : {0.1, 0.15, 0.22}) {
    for (const double speed_m_per_s : {6.0, 8.0, 12.0}) cases.push_back({{1.0, 0.6, density}, speed_m_per_s});
  }
  return run_all(cases, std::array{Size{26, 16}, Size{36, 22}, Size{51, 31}}, report,
                 [&](const auto& one, const Size& size) { return fly_flag(size, one.first, one.second, physics); });
}

}  // namespace taut::app::truth

namespace taut::app {

std::vector<TruthExperiment> wind_experiments() {
  using namespace truth;
  using enum Measure;
  using enum LegendCorner;
  return {{"flutter", "a flag flutters", "frequency with wind, amplitude stays (Alben 2021)", "wind in m/s",
           "frequency in Hz, amplitude in mm", false, false, lower_right, part, 0.2, 0.0, run_flutter, 0.0, 2.0},
          {"flag", "flags fly from a pole", "free flags (AS/NZS 1170.2, appendix F)", "wind in m/s", "drag coefficient",
           false, false, lower_right, part, 0.29, 0.0, run_flag, 0.115},
          {"onset", "a flag begins to flutter, and ends", "piston theory (Dowell 1975)", "rigidity in mN m",
           "wind's pressure in Pa, frequency in Hz", true, true, upper_left, part, 0.05, 0.0, run_onset},
          {"line", "a sheet held at both ends begins to flutter", "piston theory (Hedgepeth 1957)", "rigidity in mN m",
           "wind's pressure in Pa, frequency in Hz", true, true, upper_left, part, 0.05, 0.0, run_line},
          {"plate", "a square plate across the wind", "1.1 to 1.2 (Hoerner 1965)", "wind in m/s", "drag coefficient",
           false, false, none, difference, 0.005, 0.0, run_plate},
          {"hanging", "a sheet hangs in a level wind", "g w sin a = 1/2 rho U^2 C_N (Rayleigh 1876)", "wind in m/s",
           "angle to the vertical in degrees", false, false, none, part, 0.03, 0.0, run_hanging}};
}

}  // namespace taut::app
