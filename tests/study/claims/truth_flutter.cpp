// Experiments in which the wind moves cloth: a flag flutters, sheets held at one end or both begin to, and a plate is
// driven.

#include "tests/study/claims/truth_wind.hpp"

namespace taut::app::truth {
namespace {

/// Motion of vertices sideways: one row of positions in metres for each frame.
using Record = std::vector<std::vector<double>>;

/// Returns a vertex's mean in a record.
double mean_m(const Record& record, std::size_t vertex) {
  double sum_m = 0.0;
  for (const auto& frame_m : record) sum_m += frame_m[vertex];
  return sum_m / static_cast<double>(record.size());
}

struct Flutter {
  double amplitude_m;   ///< root mean square of the way from the mean
  double frequency_hz;  ///< a sine's with the same mean squares of position and change a frame (Rice 1944)
};

Flutter measure_flutter(const Record& record, double frame_rate_hz) {
  double squares = 0.0, changes = 0.0;
  for (std::size_t v = 0; v < record.front().size(); ++v) {
    const double middle_m = mean_m(record, v);
    for (std::size_t k = 1; k < record.size(); ++k) {
      squares += std::pow(record[k][v] - middle_m, 2);
      changes += std::pow(record[k][v] - record[k - 1][v], 2);
    }
  }
  const double count = static_cast<double>(record.front().size() * (record.size() - 1));
  const double half_turn = std::min(1.0, 0.5 * std::sqrt(changes / squares));
  return {std::sqrt(squares / count), frame_rate_hz / pi * std::asin(half_turn)};
}

Flutter watch_flag(const Size& size, double speed_m_per_s, double physics) {
  sim::Simulation simulation = hoist_flag(size, standard_flag, speed_m_per_s, physics);
  advance(simulation, flag_settling_frames);
  Record fly_end_m;
  for (int frame = 0; frame < flag_watched_frames; ++frame) {
    simulation.advance_frame();
    std::vector<double>& now_m = fly_end_m.emplace_back();
    for (Index row = 1; row <= size.along; ++row) now_m.push_back(simulation.state().current[row * size.across - 1].z);
  }
  return measure_flutter(fly_end_m, 1.0 / simulation.frame_time_s());
}

/// A sheet in a wind along it, pinned at its edge to windward, and at the other edge unless that is free.
struct HeldSheet {
  Size size;
  double rigidity_n_m;
  bool is_free;

  /// Unit of time of its waves.
  double unit_s() const { return sheet_length_m * sheet_length_m * std::sqrt(sheet_density_kg_per_m2 / rigidity_n_m); }
};

sim::Simulation begin_sheet(const HeldSheet& sheet, double speed_m_per_s, double start, double physics) {
  const auto& [size, rigidity_n_m, is_free] = sheet;
  Material material;
  material.areal_density_kg_per_m2 = sheet_density_kg_per_m2;
  material.bending_rigidity_n_m = rigidity_n_m;
  sim::Mesh mesh = rectangle(size, sheet_length_m, sheet_length_m, sim::GridPlane::horizontal);
  std::vector<Index> pins;
  for (Index row = 0; row < size.along; ++row) {
    pins.push_back(row * size.across);
    if (!is_free) pins.push_back((row + 1) * size.across - 1);
  }
  Surroundings windy;
  windy.forces.gravity_m_per_s2 = Vec3(0.0);
  windy.forces.air_drag_per_s = 0.0;
  sim::Wind& wind = windy.forces.wind;
  wind.direction = {1.0, 0.0, 0.0};
  wind.speed_m_per_s = speed_m_per_s;
  wind.friction_coefficient = 0.0;
  wind.pressure_coefficient *= physics;
  std::vector<Vec3> start_m = mesh.positions;
  for (Vec3& p : start_m) {
    const double x = (p.x - mesh.positions.front().x) / sheet_length_m;
    p.y += start * sheet_length_m * (is_free ? x * x : std::sin(pi * x) + 0.5 * std::sin(2.0 * pi * x));
  }
  sim::Simulation simulation =
      begin(std::move(mesh), material, std::move(pins), std::move(windy), false, std::move(start_m));
  sim::SimulationSettings settings = simulation.settings();
  settings.frame_rate_hz = sheet_frames_per_unit / sheet.unit_s();
  simulation.set_settings(settings);
  return simulation;
}

/// Returns the motion in as many equal parts of the run after the first as `parts` has.
template <std::size_t parts> std::array<Flutter, parts> watch_sheet(sim::Simulation simulation, int frames) {
  constexpr int all_parts = int{parts} + 1;
  std::array<Flutter, parts> flutters;
  advance(simulation, frames / all_parts);
  for (Flutter& flutter : flutters) {
    Record sideways_m;
    for (int frame = 0; frame < frames / all_parts; ++frame) {
      simulation.advance_frame();
      std::vector<double>& now_m = sideways_m.emplace_back();
      for (const Vec3& p : simulation.state().current) now_m.push_back(p.y);
    }
    flutter = measure_flutter(sideways_m, 1.0 / simulation.frame_time_s());
  }
  return flutters;
}

/// Returns the lowest speed at which the sheet flutters, sought around one of theory.
template <class DoesFlutter> double find_speed(double theory_m_per_s, const DoesFlutter& does_flutter) {
  double low = min_onset_ratio * theory_m_per_s, high = max_onset_ratio * theory_m_per_s;
  for (int run = 0; run < onset_runs; ++run) {
    const double middle = 0.5 * (low + high);
    (does_flutter(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Flutter at its onset.
struct Onset {
  double pressure_pa;  ///< 1/2 rho U^2
  double frequency_hz;
};

constexpr double wind_pressure_pa(double speed_m_per_s) {
  return 0.5 * sim::air_density_kg_per_m3 * speed_m_per_s * speed_m_per_s;
}

/// Returns the onset by theory: at small angles the wind presses by 1.79 C_n times its pressure and the angle.
Onset expect_onset(const HeldSheet& sheet) {
  const double rise = sim::Wind{}.pressure_coefficient * (4.0 + pi) / 4.0;
  const double air_ratio = 0.5 * sim::air_density_kg_per_m3 * rise * sheet_length_m / sheet_density_kg_per_m2;
  const FlutterOnset onset = flutter_onset(air_ratio, sheet.is_free);
  return {onset.load * sheet.rigidity_n_m / (rise * std::pow(sheet_length_m, 3)), onset.frequency / sheet.unit_s()};
}

double wind_speed_m_per_s(double pressure_pa) { return std::sqrt(2.0 * pressure_pa / sim::air_density_kg_per_m3); }

/// Measures the wind in which a sheet that hardly moves begins to flutter, and its frequency there.
Onset find_onset(const HeldSheet& sheet, double physics) {
  const auto begin_at = [&](double speed_m_per_s) { return begin_sheet(sheet, speed_m_per_s, small_start, physics); };
  const double speed_m_per_s = find_speed(wind_speed_m_per_s(expect_onset(sheet).pressure_pa), [&](double speed) {
    const auto [earlier, later] = watch_sheet<2>(begin_at(speed), onset_frames);
    return later.amplitude_m > std::min(earlier.amplitude_m, small_start * sheet_length_m);
  });
  return {wind_pressure_pa(speed_m_per_s), watch_sheet<1>(begin_at(speed_m_per_s), onset_frames).front().frequency_hz};
}

/// Measures the pressure of the wind in which a sheet that flutters comes to rest.
double find_end_pa(const HeldSheet& sheet, double physics) {
  return wind_pressure_pa(find_speed(wind_speed_m_per_s(expect_onset(sheet).pressure_pa), [&](double speed) {
    const auto flutter = watch_sheet<1>(begin_sheet(sheet, speed, large_start, physics), end_frames).front();
    return flutter.amplitude_m > min_flutter * sheet_length_m;
  }));
}

constexpr std::array sheet_sizes = {Size{15, 23}, Size{17, 17}, Size{19, 19}};
constexpr std::array rigidities_n_m = {1e-4, 1e-3, 1e-2};

/// Measures the drag coefficient of a square plate that is let go: v / (U (U - v)) = 1/2 rho C t / m.
std::vector<TruthPoint> drive_plate(const Size& size, double speed_m_per_s, double physics) {
  Material material;
  material.areal_density_kg_per_m2 = plate_density_kg_per_m2;
  material.bending_rigidity_n_m = plate_rigidity_n_m;
  Surroundings windy;
  windy.forces.gravity_m_per_s2 = Vec3(0.0);
  windy.forces.air_drag_per_s = 0.0;
  windy.forces.wind.speed_m_per_s = speed_m_per_s;
  windy.forces.wind.pressure_coefficient *= physics;
  sim::Simulation simulation =
      begin(rectangle(size, plate_side_m, plate_side_m, sim::GridPlane::vertical), material, {}, std::move(windy));
  advance(simulation, plate_frames);
  const sim::State& state = simulation.state();
  double moved_m = 0.0;
  for (std::size_t v = 0; v < state.current.size(); ++v) moved_m += state.previous[v].z - state.current[v].z;
  const double plate_m_per_s = moved_m / static_cast<double>(state.current.size()) / state.time_step_s;
  const double drag = 2.0 * plate_density_kg_per_m2 * plate_m_per_s /
                      (sim::air_density_kg_per_m3 * state.time_s * speed_m_per_s * (speed_m_per_s - plate_m_per_s));
  return {{"square", speed_m_per_s, drag, min_plate_drag, max_plate_drag}};
}

}  // namespace

std::vector<TruthPoint> run_flutter(double physics, const ProgressCallback& report) {
  constexpr std::array sizes = {Size{51, 31}, Size{61, 37}, Size{71, 43}};
  return run_all(std::array{physics}, sizes, report, [](double factor, const Size& size) {
    std::vector<TruthPoint> points;
    double first_mm = 0.0;
    for (const double speed_m_per_s : {4.0, 6.0, 8.0, 12.0}) {
      const Flutter flutter = watch_flag(size, speed_m_per_s, factor);
      const double amplitude_mm = 1e3 * flutter.amplitude_m;
      if (points.empty()) first_mm = amplitude_mm;
      points.push_back({"frequency in Hz", speed_m_per_s, flutter.frequency_hz,
                        flag_reduced_frequency * speed_m_per_s / standard_flag.length_m});
      points.push_back({"amplitude in mm", speed_m_per_s, amplitude_mm, min_amplitude_ratio * first_mm,
                        first_mm / min_amplitude_ratio});
    }
    return points;
  });
}

std::vector<TruthPoint> run_onset(double physics, const ProgressCallback& report) {
  return run_all(rigidities_n_m, sheet_sizes, report, [&](double rigidity_n_m, const Size& size) {
    const HeldSheet flag = {size, rigidity_n_m, true};
    const Onset expected = expect_onset(flag), found = find_onset(flag, physics);
    return std::vector<TruthPoint>{{"begins, Pa", 1e3 * rigidity_n_m, found.pressure_pa, expected.pressure_pa},
                                   {"ends, Pa", 1e3 * rigidity_n_m, find_end_pa(flag, physics), expected.pressure_pa},
                                   {"frequency, Hz", 1e3 * rigidity_n_m, found.frequency_hz, expected.frequency_hz}};
  });
}

std::vector<TruthPoint> run_line(double physics, const ProgressCallback& report) {
  return run_all(rigidities_n_m, sheet_sizes, report, [&](double rigidity_n_m, const Size& size) {
    const HeldSheet sheet = {size, rigidity_n_m, false};
    const Onset expected = expect_onset(sheet), found = find_onset(sheet, physics);
    return std::vector<TruthPoint>{{"begins, Pa", 1e3 * rigidity_n_m, found.pressure_pa, expected.pressure_pa},
                                   {"frequency, Hz", 1e3 * rigidity_n_m, found.frequency_hz, expected.frequency_hz}};
  });
}

std::vector<TruthPoint> run_plate(double physics, const ProgressCallback& report) {
  return run_all(std::array{2.0, 4.0, 8.0, 12.0}, std::array{Size{7, 7}, Size{9, 9}, Size{17, 17}}, report,
                 [&](double speed_m_per_s, const Size& size) { return drive_plate(size, speed_m_per_s, physics); });
}

}  // namespace taut::app::truth
