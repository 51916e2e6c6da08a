#include "tests/study/claims/rest_shapes.hpp"

#include <cmath>

#include "app/runs/csv.hpp"
#include "tests/study/claims/truth_setups.hpp"

namespace taut::app {
namespace {

using reference::RestCase;
using reference::Vector;

sim::Vec3 to_sim(const reference::Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<sim::Vec3> to_positions(const RestCase& what, const Vector& shape) {
  std::vector<sim::Vec3> positions;
  for (const reference::Point& p : reference::make_surface(what.cloth, shape).points_m) positions.push_back(to_sim(p));
  return positions;
}

std::shared_ptr<const sim::Garment> make_case_garment(const RestCase& what, double physics) {
  sim::Mesh mesh;
  mesh.positions = to_positions(what, reference::flatten(what.cloth.rest_m));
  for (const reference::Corners& t : what.cloth.triangles) {
    mesh.triangles.push_back(
        {static_cast<sim::Index>(t[0]), static_cast<sim::Index>(t[1]), static_cast<sim::Index>(t[2])});
  }
  const reference::Fabric& fabric = what.cloth.fabric;
  sim::Material material;
  material.areal_density_kg_per_m2 = fabric.density_kg_per_m2;
  material.bending_rigidity_n_m = physics * fabric.rigidity_n_m;
  material.compression_stiffness_n_per_m = fabric.stiffness_n_per_m;
  material.tensile_warp_n_per_m = material.tensile_weft_n_per_m = fabric.stiffness_n_per_m;
  material.shear_n_per_m = 0.5 * fabric.stiffness_n_per_m;
  material.thickness_m = fabric.thickness_m;
  material.friction = 0.0;
  return sim::share(sim::make_garment(std::move(mesh), {}, material));
}

std::vector<sim::Index> list_pins(const RestCase& what) {
  std::vector<sim::Index> pins;
  for (const int pin : what.cloth.pins) {
    if (pin != what.cloth.ball) pins.push_back(static_cast<sim::Index>(pin));
  }
  return pins;
}

std::vector<sim::Body> make_bodies(const RestCase& what) {
  if (what.cloth.ball < 0) return {};
  return {{.name = "ball",
           .shape = sim::Sphere{to_sim(what.cloth.rest_m[what.cloth.ball]), what.cloth.ball_radius_m},
           .friction = 0.0}};
}

reference::Difference compute_difference(const RestCase& what, const Vector& one, const Vector& other) {
  return reference::difference(reference::make_surface(what.cloth, one), reference::make_surface(what.cloth, other));
}

reference::Drape measure_drape(const RestCase& what, const Vector& shape) {
  return reference::measure_drape(reference::make_surface(what.cloth, shape),
                                  reference::Potential(what.cloth).masses_kg());
}

/// Returns a recording of the shape, drawn like the shirt. One camera draws all shapes, so cloth on a ball is lifted to
/// the shirt's height.
Recording record_picture(const RestCase& what, const Vector& shape) {
  Recording recording;
  recording.scene = shirt_scene("tshirt-gravity", model_sizes.front());
  recording.garment = make_case_garment(what, 1.0);
  recording.pins = list_pins(what);
  std::vector<sim::Vec3>& positions = recording.moments.emplace_back().positions;
  positions = to_positions(what, shape);
  if (what.cloth.ball >= 0) {
    for (sim::Vec3& p : positions) p.y += 1.55;
  }
  return recording;
}

RestComparison compare(const RestCase& what, const std::string& title) {
  const reference::Potential potential(what.cloth);
  const auto energy_j = [&](const Vector& shape) { return potential.energies(shape).sum(); };
  const Vector kept = kept_rest(what), taut = find_rest(what);
  // The Hessian jumps where the closest points of a pair change edges, so the last digits would take very many steps.
  const reference::Descent descent{.max_force = 1e-3, .max_steps = 300};
  const Vector from_taut = reference::minimise(potential, taut, descent).x;
  reference::Cloth stiffer = what.cloth;
  stiffer.fabric.rigidity_n_m *= 1.1;
  const Vector with_stiffer = reference::minimise(reference::Potential(stiffer), kept, descent).x;
  return {title,
          record_picture(what, kept),
          record_picture(what, taut),
          compute_difference(what, kept, taut),
          measure_drape(what, kept),
          measure_drape(what, taut),
          energy_j(kept),
          energy_j(taut),
          compute_difference(what, taut, from_taut),
          compute_difference(what, kept, from_taut),
          energy_j(from_taut),
          compute_difference(what, kept, find_rest(what, 1.0, kept)),
          compute_difference(what, kept, with_stiffer),
          measure_drape(what, with_stiffer)};
}

struct NamedNumber {
  std::string name;
  double value;
  int decimals;
};

/// Returns all compared numbers in the report's order.
std::vector<NamedNumber> list_numbers(const RestComparison& rest) {
  std::vector<NamedNumber> numbers;
  const auto add = [&](const std::string& name, const reference::Difference& apart) {
    numbers.push_back({name + ", largest distance in mm", 1e3 * apart.hausdorff_m, 1});
    numbers.push_back({name + ", root mean square in mm", 1e3 * apart.mean_m, 1});
  };
  add("Taut's shape from the potential's", rest.apart);
  add("Taut's, if it begins in the potential's, from that", rest.from_reference);
  add("the potential's, if it begins in Taut's, from Taut's", rest.moved);
  add("the same from the potential's own", rest.from_taut);
  add("the potential's with a tenth more rigidity from its own", rest.stiffer);
  const auto add_drape = [&](const std::string& whose, const reference::Drape& drape) {
    numbers.push_back({"lowest point of " + whose + " in mm", 1e3 * drape.min_height_m, 1});
    numbers.push_back({"mean height of " + whose + " in mm", 1e3 * drape.mean_m, 1});
    numbers.push_back({"shadow of " + whose + " in cm2", 1e4 * drape.shadow_m2, 0});
  };
  add_drape("the potential's", rest.by_reference);
  add_drape("Taut's", rest.by_taut);
  add_drape("the potential's with a tenth more rigidity", rest.by_stiffer);
  numbers.push_back({"potential of its own in mJ", 1e3 * rest.reference_j, 2});
  numbers.push_back({"potential of Taut's in mJ", 1e3 * rest.taut_j, 2});
  numbers.push_back({"potential of its own, if it begins in Taut's, in mJ", 1e3 * rest.from_taut_j, 2});
  return numbers;
}

std::string rests_csv(const std::vector<RestComparison>& rests) {
  CsvTable table({"cloth", "what", "value"});
  for (const RestComparison& rest : rests) {
    for (const NamedNumber& number : list_numbers(rest)) {
      table.add({cell(rest.title), cell(number.name), cell(number.value)});
    }
  }
  return table.text();
}

Drawing draw_rests(const std::vector<RestComparison>& rests, LazyOffscreenRenderer& offscreen) {
  std::vector<Recording> recordings;
  std::vector<Caption> captions;
  for (const RestComparison& rest : rests) {
    const auto add = [&](const Recording& recording, const char* by, const reference::Drape& drape,
                         const std::string& more) {
      recordings.push_back(recording);
      captions.push_back({static_cast<char>('a' + captions.size()), fmt::format("{}, {}", rest.title, by),
                          fmt::format("shadow {:.0f} cm2{}", 1e4 * drape.shadow_m2, more)});
    };
    add(rest.reference, "incremental potential", rest.by_reference, "");
    add(rest.taut, "Taut", rest.by_taut, ", up to " + fmt::format("{:.1f} mm away", 1e3 * rest.apart.hausdorff_m));
  }
  return sheet_of_last(recordings, captions, {1000, 900}, {.columns = 2}, false, offscreen);
}

}  // namespace

Vector kept_rest(const RestCase& what) { return reference::kept_rest(what, TAUT_REFERENCE_SHAPES); }

Vector find_rest(const RestCase& what, double physics, const std::optional<Vector>& start) {
  const int frames = what.cloth.ball < 0 ? 300 : 360;
  sim::Surroundings surroundings;
  surroundings.forces.gravity_m_per_s2.y = -what.cloth.gravity_m_per_s2;
  surroundings.bodies = make_bodies(what);
  sim::SimulationSettings settings;
  settings.rest_settings.speed_m_per_s = 0.0;
  settings.solver.method = sim::BoundedSettings{.max_stretch = 0.1, .contact = true, .threads = 1};
  Vector shape = start ? *start : reference::flatten(what.start_m);
  sim::Simulation simulation(make_case_garment(what, physics), list_pins(what), settings, surroundings,
                             to_positions(what, shape));
  truth::advance(simulation, frames);
  const std::vector<sim::Vec3>& positions = simulation.state().current;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    shape.segment<3>(3 * static_cast<Eigen::Index>(v)) << positions[v].x, positions[v].y, positions[v].z;
  }
  return shape;
}

double drape_coefficient(const RestCase& what, const Vector& shape) {
  const double radius_m = what.cloth.ball_radius_m + what.cloth.fabric.thickness_m;
  const double on_ball_m2 = std::acos(-1.0) * radius_m * radius_m;
  const reference::Vector flat = reference::flatten(what.start_m);
  return (measure_drape(what, shape).shadow_m2 - on_ball_m2) / (measure_drape(what, flat).shadow_m2 - on_ball_m2);
}

std::vector<RestComparison> compare_rests(const ProgressCallback& report) {
  std::vector<RestComparison> rests;
  for (const int triangles : reference::kept_shirts) {
    rests.push_back(compare(reference::shirt(assets_folder() / "garments", triangles),
                            fmt::format("T-shirt of {} triangles", triangles)));
    report(0.4 * static_cast<double>(rests.size()));
  }
  rests.push_back(compare(reference::cloth_on_ball(28, 1e-3), "cloth on a ball"));
  return rests;
}

Figure rest_figure(std::vector<RestComparison>& rests) {
  return {"rest_shapes",
          "Shapes at rest by an incremental potential, our own implementation of IPC's equations, and by Taut",
          {"rest_shapes"},
          std::bind_front(draw_rests, std::ref(rests)),
          std::bind_front(rests_csv, std::ref(rests))};
}

std::string rest_html(std::span<const RestComparison> rests) {
  if (rests.empty()) return "";
  std::string html = "<table>\n<tr><th></th>";
  for (const RestComparison& rest : rests) html += fmt::format("<th>{}</th>", rest.title);
  html += "</tr>\n";
  const std::vector<NamedNumber> first = list_numbers(rests.front());
  for (std::size_t i = 0; i < first.size(); ++i) {
    html += fmt::format("<tr><td>{}</td>", first[i].name);
    for (const RestComparison& rest : rests) {
      html += fmt::format("<td class=\"number\">{:.{}f}</td>", list_numbers(rest)[i].value, first[i].decimals);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace taut::app
