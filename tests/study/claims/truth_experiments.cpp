#include "drape_meter.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/study/claims/truth_setups.hpp"

namespace taut::app {

static std::string to_name(const DiscMesh& mesh) { return fmt::format("edges of {:.0f} mm", 1e3 * mesh.edge_m); }

namespace {

using namespace truth;

struct Pull {
  const char* curve;
  Material material;
  double angle;  ///< angle from the pull to the warp, in radians
};

Material with_law(double warp_n_per_m, double weft_n_per_m, double shear_n_per_m) {
  Material material;
  material.tensile_warp_n_per_m = warp_n_per_m;
  material.tensile_weft_n_per_m = weft_n_per_m;
  material.shear_n_per_m = shear_n_per_m;
  return material;
}

/// Returns the strain per load along the strip for threads at this angle (Jones 1975, eq. 2.97, without lateral
/// contraction).
double compliance_m_per_n(const Pull& pull) {
  const double c = std::cos(pull.angle), s = std::sin(pull.angle);
  return c * c * c * c / pull.material.tensile_warp_n_per_m + s * s * s * s / pull.material.tensile_weft_n_per_m +
         c * c * s * s / pull.material.shear_n_per_m;
}

/// Measures the strain of the middle half of a strip of 10 x 40 cm that is pulled at its lower edge.
TruthPoint pull(const Pull& pull, const Size& size, double load_n_per_m, double physics) {
  constexpr double width_m = 0.1, length_m = 0.4;
  sim::Garment garment =
      sim::make_garment(rectangle(size, width_m, length_m, sim::GridPlane::vertical), {}, pull.material);
  const Vec3 warp(std::sin(pull.angle), std::cos(pull.angle), 0.0);
  const Vec3 weft(warp.y, -warp.x, 0.0);
  std::vector<glm::vec2> threads;
  for (const sim::Triangle& t : garment.mesh.triangles) {
    for (const Vec3& p : sim::corner_positions(t, garment.mesh.positions)) {
      threads.emplace_back(glm::dot(p, weft), glm::dot(p, warp));
    }
  }
  garment.warps = sim::warps_from_coordinates(garment.mesh, threads);
  Surroundings surroundings = in_vacuum();
  surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  surroundings.forces.air_drag_per_s = 2.0;
  std::vector<Index> pins;
  for (Index c = 0; c < size.across; ++c) {
    const double share = (c == 0 || c + 1 == size.across ? 0.5 : 1.0) / (size.across - 1);
    surroundings.forces.artificial_forces.push_back(
        {(size.along - 1) * size.across + c, Vec3(0.0, -load_n_per_m / physics * width_m * share, 0.0)});
    pins.push_back(c);
  }
  const std::vector<Vec3> flat = garment.mesh.positions;
  sim::Simulation simulation =
      begin(sim::share(std::move(garment)), std::move(pins), std::move(surroundings), 0.2, false);
  advance(simulation, 180);
  const auto length_of = [&](const std::vector<Vec3>& positions) {
    double sum_m = 0.0;
    for (Index c = 0; c < size.across; ++c) {
      sum_m += positions[size.along / 4 * size.across + c].y -
               positions[(size.along - 1 - size.along / 4) * size.across + c].y;
    }
    return sum_m;
  };
  return {pull.curve, load_n_per_m, 100.0 * (length_of(simulation.state().current) / length_of(flat) - 1.0),
          100.0 * load_n_per_m * compliance_m_per_n(pull)};
}

std::vector<TruthPoint> run_extension(double physics, const ProgressCallback& report) {
  const double bias = std::atan(1.0);
  const Material woven = with_law(2000.0, 1500.0, 60.0), knit = with_law(400.0, 200.0, 60.0);
  const std::array<Pull, 4> pulls = {{{"woven, along the warp", woven, 0.0},
                                      {"woven, on the bias", woven, bias},
                                      {"knit, along the warp", knit, 0.0},
                                      {"knit, on the bias", knit, bias}}};
  return run_all(pulls, std::array{Size{5, 17}, Size{6, 21}, Size{9, 33}}, report,
                 [&](const Pull& one, const Size& size) {
                   return collect<TruthPoint>(std::array{2.0, 6.0, 18.0},
                                              [&](double load) { return pull(one, size, load, physics); });
                 });
}

Vec3 compute_middle(std::span<const Vec3> positions) {
  return std::accumulate(positions.begin(), positions.end(), Vec3(0.0)) / static_cast<double>(positions.size());
}

/// Measures the acceleration of a sheet of 40 cm on a slope or, if `is_on_cloth`, on another sheet that is pinned
/// everywhere. The sheets are level, and gravity is tilted instead.
TruthPoint slide_sheet(const Size& size, double friction, double slope, bool is_on_cloth, double physics) {
  constexpr double width_m = 0.4;
  constexpr int frames = 45;
  constexpr double time_s = frames / 60.0;
  sim::Mesh mesh = rectangle(size, width_m, width_m, sim::GridPlane::horizontal);
  const std::size_t count = mesh.positions.size();
  for (Vec3& p : mesh.positions) p.y = 0.0011;
  Material material;
  material.friction = physics * friction;
  Surroundings surroundings = in_vacuum();
  std::vector<Index> pins;
  if (is_on_cloth) {
    sim::Mesh lower = mesh;
    for (Vec3& p : lower.positions) p = p * Vec3(8.0, 0.0, 2.0) - Vec3(0.0, 0.0, 0.2);
    mesh = sim::both(std::move(mesh), lower);
    pins = vertices_from(count, count);
  } else {
    surroundings.bodies = {{.name = "slope", .shape = sim::Plane{}, .friction = physics * friction}};
  }
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  surroundings.forces.gravity_m_per_s2 = gravity_m_per_s2 * cosine * Vec3(slope, -1.0, 0.0);
  std::vector<Vec3> start_m = mesh.positions;
  // The rest shapes are farther apart: layers modelled nearer than two thicknesses would keep only half of that
  // distance where they were modelled, and be lifted where they have slid to.
  for (std::size_t v = 0; is_on_cloth && v < count; ++v) mesh.positions[v].y = 0.01;
  sim::Simulation simulation =
      begin(std::move(mesh), material, std::move(pins), surroundings, true, std::move(start_m));
  const auto sliding = [&] { return compute_middle(std::span(simulation.state().current).first(count)).x; };
  const double before_m = sliding();
  advance(simulation, frames);
  const double acceleration = 2.0 * (sliding() - before_m) / (time_s * time_s);
  return {fmt::format("friction {:g}", friction), slope, acceleration / (gravity_m_per_s2 * cosine),
          std::max(0.0, slope - friction)};
}

std::vector<TruthPoint> slide_all(bool is_on_cloth, double physics, const ProgressCallback& report) {
  std::vector<std::array<double, 2>> cases;
  for (const double friction : {0.1, 0.2, 0.3, 0.5, 0.8}) {
    for (const double times : {0.8, 1.4, 2.0}) cases.push_back({friction, times * friction});
  }
  return run_all(cases, std::array{Size{5, 5}, Size{9, 9}, Size{15, 15}}, report,
                 [&](const auto& one, const Size& size) {
                   return std::vector{slide_sheet(size, one[0], one[1], is_on_cloth, physics)};
                 });
}

std::vector<TruthPoint> run_slope(double physics, const ProgressCallback& report) {
  return slide_all(false, physics, report);
}

std::vector<TruthPoint> run_layers(double physics, const ProgressCallback& report) {
  return slide_all(true, physics, report);
}

double mean_speed_down(const sim::State& state) {
  double sum_m = 0.0;
  for (std::size_t v = 0; v < state.current.size(); ++v) sum_m += state.previous[v].y - state.current[v].y;
  return sum_m / static_cast<double>(state.current.size()) / state.time_step_s;
}

/// Measures the fall of a level sheet through air. Drag on the whole area brings it to a terminal speed; before that v
/// = v_t tanh(g t / v_t).
std::vector<TruthPoint> drop_sheet(const Size& size, double density, double physics) {
  Material material;
  material.areal_density_kg_per_m2 = density;
  material.bending_rigidity_n_m = 1e-2;  // softer cloth bends and turns over
  Surroundings air;
  air.forces.air_drag_per_s = 0.0;
  const double terminal =
      std::sqrt(2.0 * density * gravity_m_per_s2 / (sim::air_density_kg_per_m3 * air.forces.wind.pressure_coefficient));
  air.forces.wind.pressure_coefficient *= physics;
  sim::Simulation simulation =
      begin(rectangle(size, 0.4, 0.4, sim::GridPlane::horizontal), material, {}, std::move(air));
  std::vector<TruthPoint> points;
  for (int tenth = 1; tenth <= 10; ++tenth) {
    advance(simulation, 6);
    const double time_s = simulation.state().time_s;
    points.push_back({fmt::format("{:g} g/m2", 1e3 * density), time_s, mean_speed_down(simulation.state()),
                      terminal * std::tanh(gravity_m_per_s2 * time_s / terminal)});
  }
  return points;
}

std::vector<TruthPoint> run_fall(double physics, const ProgressCallback& report) {
  return run_all(std::array{0.05, 0.15, 0.4}, std::array{Size{7, 7}, Size{9, 9}, Size{17, 17}}, report,
                 [&](double density, const Size& size) { return drop_sheet(size, density, physics); });
}

/// Measures the momentum of two free sheets, one above the other. A force pushes the upper one onto the lower one, then
/// both. Their momentum is force times time.
std::vector<TruthPoint> collide_sheets(double physics, const Size& size) {
  constexpr double force_n = 0.2, apart_m = 0.05;
  const sim::Mesh upper = rectangle(size, 0.4, 0.4, sim::GridPlane::horizontal);
  const std::size_t count = upper.positions.size();
  sim::Mesh lower = upper;
  for (Vec3& p : lower.positions) p -= Vec3(0.03, apart_m, 0.02);
  Surroundings surroundings = in_vacuum();
  surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  const auto garment = sim::share(sim::make_garment(sim::both(upper, lower), {}, {}));
  double pushed_kg = 0.0;
  for (Index v = 0; v < count; ++v) pushed_kg += garment->masses_kg[v];
  for (Index v = 0; v < count; ++v) {
    surroundings.forces.artificial_forces.push_back(
        {v, Vec3(0.0, -physics * force_n * garment->masses_kg[v] / pushed_kg, 0.0)});
  }
  sim::Simulation simulation = begin(garment, {}, std::move(surroundings), 0.01, true);
  std::vector<TruthPoint> points;
  for (int time = 1; time <= 10; ++time) {
    advance(simulation, 3);
    const sim::State& state = simulation.state();
    double momentum = 0.0, of_lower = 0.0;
    for (std::size_t v = 0; v < state.current.size(); ++v) {
      const double one = garment->masses_kg[v] * (state.previous[v].y - state.current[v].y) / state.time_step_s;
      momentum += one;
      of_lower += v < count ? 0.0 : one;
    }
    points.push_back({"both", state.time_s, 1e3 * momentum, 1e3 * force_n * state.time_s});
    points.push_back({"the lower one", state.time_s, 1e3 * of_lower, NAN});
  }
  return points;
}

std::vector<TruthPoint> run_collision(double physics, const ProgressCallback& report) {
  return run_all(std::array{physics}, std::array{Size{6, 6}, Size{10, 10}, Size{16, 16}}, report, collide_sheets);
}

/// Measures the energy of a sheet that is released level, pinned at an edge, divided by the energy of its fall. Nothing
/// brakes it.
std::vector<TruthPoint> swing_sheet(double physics, const Size& size) {
  constexpr double length_m = 0.4;
  constexpr int frames = 60 * 60;
  std::vector<Index> pins = vertices_from(0, size.across);
  const auto garment =
      sim::share(sim::make_garment(rectangle(size, length_m, length_m, sim::GridPlane::horizontal), {}, {}));
  const std::vector<Vec3> flat = garment->mesh.positions;
  Surroundings surroundings = in_vacuum();
  surroundings.forces.gravity_m_per_s2 *= physics;
  sim::Simulation simulation = begin(garment, pins, std::move(surroundings), 0.01, true);
  double all_j = 0.0;
  for (const double mass_kg : garment->masses_kg) all_j += mass_kg * gravity_m_per_s2 * 0.5 * length_m;
  std::vector<TruthPoint> points;
  for (int frame = 0; frame < frames;) {
    const int step = frame < 60 ? 6 : 60;  // the first fall in detail, because it loses little
    advance(simulation, step);
    frame += step;
    const sim::State& state = simulation.state();
    double energy_j = 0.0;
    for (std::size_t v = 0; v < flat.size(); ++v) {
      const Vec3 moved = state.current[v] - state.previous[v];
      energy_j += garment->masses_kg[v] * (0.5 * glm::dot(moved, moved) / (state.time_step_s * state.time_step_s) +
                                           gravity_m_per_s2 * (state.current[v].y - flat[v].y));
    }
    points.push_back({"sheet", state.time_s, energy_j / all_j, 0.0});
  }
  return points;
}

std::vector<TruthPoint> run_swing(double physics, const ProgressCallback& report) {
  return run_all(std::array{physics}, std::array{Size{7, 7}, Size{10, 10}, Size{14, 14}}, report, swing_sheet);
}

/// Returns the mean drape in % of three discs of a mesh, as the meter's standard asks for three specimens (BS 5058).
/// Discs on other triangles fold otherwise, and differ by up to 5 points.
double mean_drape_percent(const Material& fabric, double edge_m) {
  constexpr std::array<std::uint64_t, 3> seeds = {1, 2, 3};
  double sum = 0.0;
  for (const std::uint64_t seed : seeds) sum += 100.0 * run_drape(fabric, {edge_m, seed}).shadow.coefficient;
  return sum / seeds.size();
}

/// Measures discs in Cusick's drape meter, with the ranges that are published for such fabrics.
std::vector<TruthPoint> run_drapes(double physics, const ProgressCallback& report) {
  constexpr std::array meshes = {DiscMesh{0.010}, DiscMesh{0.009}, DiscMesh{0.008}};
  constexpr std::array names = {"jersey", "silk", "wool", "cotton", "denim"};
  return run_all(names, meshes, report, [&](const char* name, const DiscMesh& mesh) {
    const auto range = find_fabric(name).published_drape_percent.value_or(std::array<double, 2>{NAN, NAN});
    Material fabric = set_fabric({}, name).material;
    const double bending_length_m =
        std::cbrt(fabric.bending_rigidity_n_m / (fabric.areal_density_kg_per_m2 * gravity_m_per_s2));
    fabric.bending_rigidity_n_m *= physics;
    return std::vector{
        TruthPoint{name, 100.0 * bending_length_m, mean_drape_percent(fabric, mesh.edge_m), range[0], range[1]}};
  });
}

/// Measures the period of a narrow hanging sheet that swings a little, without bending: the period of a chain, from the
/// first zero of Bessel's function J0.
std::vector<TruthPoint> measure_period(const Size& size, double length_m, double physics) {
  constexpr double zero_of_bessel = 2.404825557695773, pushed_s = 0.5, push_m_per_s2 = 0.3;
  constexpr int frames = 60 * 12;
  Material material;
  material.bending_rigidity_n_m = 1e-7;
  Surroundings surroundings = in_vacuum();
  surroundings.forces.gravity_m_per_s2 *= physics;
  surroundings.forces.gravity_path = {
      {0.0, Vec3(0.0, 0.0, push_m_per_s2)}, {pushed_s, Vec3(0.0, 0.0, push_m_per_s2)}, {pushed_s + 0.05, Vec3(0.0)}};
  std::vector<Index> pins = vertices_from(0, size.across);
  sim::Simulation simulation =
      begin(rectangle(size, 0.1, length_m, sim::GridPlane::vertical), material, std::move(pins), surroundings);
  std::vector<double> crossed_s;
  double before_m = 0.0;
  for (int frame = 1; frame <= frames; ++frame) {
    simulation.advance_frame();
    const double time_s = simulation.state().time_s;
    const double at_m = compute_middle(simulation.state().current).z;
    if (time_s > 2.0 && before_m < 0.0 && at_m >= 0.0) crossed_s.push_back(time_s - at_m / (at_m - before_m) / 60.0);
    before_m = at_m;
  }
  const double measured_s =
      crossed_s.size() < 2 ? 0.0 : (crossed_s.back() - crossed_s.front()) / static_cast<double>(crossed_s.size() - 1);
  const double expected_s = 4.0 * std::acos(-1.0) / zero_of_bessel * std::sqrt(length_m / gravity_m_per_s2);
  return {{"sheet", length_m, measured_s, expected_s}};
}

std::vector<TruthPoint> run_chain(double physics, const ProgressCallback& report) {
  return run_all(std::array{0.2, 0.3, 0.45, 0.7, 1.0}, std::array{Size{3, 11}, Size{4, 16}, Size{5, 21}}, report,
                 [&](double length_m, const Size& size) { return measure_period(size, length_m, physics); });
}

}  // namespace

std::vector<TruthExperiment> calm_experiments() {
  using enum Measure;
  using enum LegendCorner;
  return {
      {"cantilever", "a clamped strip droops", "heavy elastica (Bickley 1934; Romero and others 2021)",
       "weight x length^3 / rigidity", "drop over reach of its end", true, true, none, part, 0.1, 0.0, run_cantilever},
      {"extension", "a woven and a knit are pulled", "orthotropic plate (Jones 1975)", "load in N/m", "strain in %",
       true, true, lower_right, part, 0.05, 0.0, run_extension},
      {"chain", "a hanging sheet swings a little", "hanging chain (Bernoulli 1732)", "length in m", "period in s",
       false, false, none, part, 0.025, 0.0, run_chain},
      {"fall", "a level sheet falls through air", "v_t tanh(g t / v_t)", "time in s", "speed in m/s", false, false,
       lower_right, part, 0.02, 0.0, run_fall},
      {"slope", "a sheet slides on a plane", "Coulomb 1785", "tangent of the slope", "acceleration in g cos", false,
       false, upper_left, difference, 0.02, 0.0, run_slope},
      {"layers", "a sheet slides on another", "Coulomb 1785", "tangent of the slope", "acceleration in g cos", false,
       false, upper_left, difference, 0.02, 0.0, run_layers},
      {"collision", "a sheet is pushed onto another", "momentum is force times time", "time in s", "momentum in mN s",
       false, false, upper_left, part, 0.01, 0.0, run_collision},
      {"swing", "a sheet swings without air", "energy is never above the start's", "time in s",
       "energy over what it has to fall", false, false, none, excess, 0.001, 0.0, run_swing},
      {"buckling", "a strip clamped on its edge buckles", "plate (Timoshenko and Gere 1961)", "width over length",
       "weight x length^3 / rigidity", false, false, none, part, 0.1, 0.107, run_buckling},
      {"slip", "a strip pressed on the ground slips", "elastica (Sano and others 2017)", "way of the clamp over length",
       "friction that just holds it", false, false, none, part, 0.06, 0.0, run_slip},
      {"drape", "fabrics hang over a disc", "published ranges (Cusick 1968; Gan and others 1991)",
       "bending length in cm", "drape coefficient in %", false, false, lower_right, difference, 0.0, 0.0, run_drapes,
       48.7}};
}

std::vector<TruthExperiment> truth_experiments() {
  std::vector<TruthExperiment> all = calm_experiments();
  std::ranges::move(wind_experiments(), std::back_inserter(all));
  return all;
}

}  // namespace taut::app
