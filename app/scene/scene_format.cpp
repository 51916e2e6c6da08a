#include "app/scene/scene_format.hpp"

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

constexpr double degree = 0.017453292519943295;
// Size of a garment in metres. Outside this range double precision is too coarse for its details.
constexpr Range side_range_m = {.lowest = 1e-4, .highest = 1e4};
constexpr Range friction = {.lowest = 0.0, .highest = 10.0};
// Limit on values in the system that `implicit` solves. Above it, masses are lost to rounding and cloth floats at its
// start.
constexpr Range implicit_range = {.lowest = 0.0, .highest = 1e7};
// Ranges outside of which no cloth is simulated: squares of the numbers would be lost in double precision.
constexpr Range density = {.lowest = 1e-6, .highest = 1e4};
constexpr Range thickness = {.lowest = 1e-6, .highest = 10.0};
constexpr Range elongation = {.lowest = 1e-6, .highest = 1e3};
constexpr Range moderate = {.lowest = 0.0, .highest = 1e6};
constexpr Range stiffness = {.lowest = 0.0, .highest = 1e12};
constexpr Range fraction = {.lowest = 0.0, .highest = 1.0};

/// Returns the key for the promises that frames may break without failing the run.
Key<Scene> allow_key() {
  auto read = [](const toml::node& value, sim::BoundedSettings& bounded) {
    const std::optional<bool> both = value.value_exact<bool>();
    const std::optional<std::string> one = text_in(value);
    if (!both && one != "bound" && one != "contact") return false;
    bounded.allow_exceeding = both.value_or(one == "bound");
    bounded.allow_crossing = both.value_or(one == "contact");
    return true;
  };
  auto write = [](const sim::BoundedSettings& bounded) {
    return bounded.allow_exceeding == bounded.allow_crossing ? Json(bounded.allow_exceeding)
                                                             : Json(bounded.allow_exceeding ? "bound" : "contact");
  };
  return member_key<Scene>("solver.allow_exceeding", "", "true or false or \"bound\" or \"contact\"",
                           MEMBER(simulation.solver.bounded), read, write);
}

}  // namespace

toml::table read_landmarks_file(const std::filesystem::path& garment) {
  const std::filesystem::path path = landmarks_path(garment);
  std::error_code error;
  if (is_sewing_pattern(garment) || !std::filesystem::exists(path, error)) return {};
  return read_toml_text(read_text_file(path), path.string());
}

std::vector<Key<Scene>> scene_keys() {
  return {
      text_key<Scene>("title", MEMBER(title)),
      file_key<Scene>("garment.file", MEMBER(garment.file)),
      number_key<Scene>("garment.scale", "m", moderate, MEMBER(garment.scale)),
      up_key<Scene>("garment.up", MEMBER(garment.up)),
      weld_key(),
      choice_key<Scene, MeshChoice>(
          "garment.mesh",
          {{"auto", MeshChoice::automatic}, {"model", MeshChoice::model}, {"fitted", MeshChoice::fitted}},
          MEMBER(garment.mesh)),
      whole_key<Scene>("garment.triangles", {200, 200000}, MEMBER(garment.max_triangles)),
      whole_key<Scene>("garment.subdivisions", {0, 5}, MEMBER(garment.subdivisions)),
      whole_key<Scene>("garment.grid.columns", {2, 2000}, MEMBER(garment.grid.columns)),
      whole_key<Scene>("garment.grid.rows", {2, 2000}, MEMBER(garment.grid.rows)),
      number_key<Scene>("garment.grid.width", "m", side_range_m, MEMBER(garment.grid.width_m)),
      number_key<Scene>("garment.grid.height", "m", side_range_m, MEMBER(garment.grid.height_m)),
      choice_key<Scene, sim::GridPlane>(
          "garment.grid.plane", {{"vertical", sim::GridPlane::vertical}, {"horizontal", sim::GridPlane::horizontal}},
          MEMBER(garment.grid.plane)),
      vector_key<Scene>("garment.grid.top", "m", MEMBER(garment.grid.top_centre_m)),
      file_key<Scene>("garment.start", MEMBER(garment.start)),
      switch_key<Scene>("garment.untangle", MEMBER(garment.untangle)),
      number_key<Scene>("garment.areal_density", "kg/m2", density, MEMBER(material.areal_density_kg_per_m2)),
      choice_key<Scene, sim::FlexuralRule>("garment.flexural_rule",
                                           {{"angular", sim::FlexuralRule::angular},
                                            {"opposite-vertex", sim::FlexuralRule::opposite_vertex},
                                            {"none", sim::FlexuralRule::none}},
                                           MEMBER(mapping.flexural_rule)),
      number_key<Scene>("garment.flexural_angle", "degrees", {90.0, 180.0}, MEMBER(mapping.min_flexural_angle_rad),
                        degree),
      pins_key(),
      number_key<Scene>("pins.width", "m", {0.0, 10.0}, MEMBER(pin_width_m)),
      moving_pins_key(),
      vector_key<Scene>("pins.motion.amplitude", "m", MEMBER(surroundings.pin_motion.amplitude_m)),
      number_key<Scene>("pins.motion.frequency", "Hz", {0.0, 1e4, true}, MEMBER(surroundings.pin_motion.frequency_hz)),
      file_key<Scene>("start.checkpoint", MEMBER(checkpoint), true),
      number_key<Scene>("time.frame_rate", "Hz", {1.0, 10000.0}, MEMBER(simulation.frame_rate_hz)),
      whole_key<Scene>("time.frames", {1, 1000000}, MEMBER(frames)),
      choice_key<Scene>("solver.kind", make_choices(sim::all_solver_kinds), MEMBER(simulation.solver.kind)),
      whole_key<Scene>("solver.substeps", {0, 10000}, MEMBER(simulation.solver.substeps)),
      whole_key<Scene>("solver.max_substeps", {1, 10000}, MEMBER(simulation.solver.max_substeps)),
      whole_key<Scene>("solver.iterations", {1, 10000}, MEMBER(simulation.solver.strong.iterations)),
      number_key<Scene>("solver.compression", "", fraction, MEMBER(simulation.solver.strong.rigidity.compression)),
      number_key<Scene>("solver.flexural", "", fraction, MEMBER(simulation.solver.strong.rigidity.flexural)),
      number_key<Scene>("solver.max_stretch", "", moderate, MEMBER(simulation.solver.bounded.max_stretch)),
      whole_key<Scene>("solver.projections", {1, 1000}, MEMBER(simulation.solver.fast_projection.max_projections)),
      choice_key<Scene>("solver.bound", make_choices(sim::all_bound_kinds), MEMBER(simulation.solver.bounded.bound)),
      switch_key<Scene>("solver.contact", MEMBER(simulation.solver.bounded.contact)),
      switch_key<Scene>("solver.tethers", MEMBER(simulation.solver.bounded.tethers)),
      choice_key<Scene>("solver.vector_unit", make_choices(sim::all_vector_units),
                        MEMBER(simulation.solver.bounded.vector_unit)),
      whole_key<Scene>("solver.threads", {0, sim::max_threads}, MEMBER(simulation.solver.bounded.threads)),
      allow_key(),
      number_key<Scene>("solver.stiffness.structural", "N/m", not_negative,
                        MEMBER(simulation.solver.ideal.stiffness.structural_n_per_m)),
      number_key<Scene>("solver.stiffness.shear", "N/m", not_negative,
                        MEMBER(simulation.solver.ideal.stiffness.shear_n_per_m)),
      number_key<Scene>("solver.stiffness.flexural", "N/m", not_negative,
                        MEMBER(simulation.solver.ideal.stiffness.flexural_n_per_m)),
      number_key<Scene>("solver.stiffness.damping", "N s/m", not_negative,
                        MEMBER(simulation.solver.ideal.stiffness.damping_n_s_per_m)),
      number_key<Scene>("solver.implicit.stretch", "N/m", implicit_range,
                        MEMBER(simulation.solver.implicit.stretch_n_per_m)),
      number_key<Scene>("solver.implicit.shear", "N/m", implicit_range,
                        MEMBER(simulation.solver.implicit.shear_n_per_m)),
      number_key<Scene>("solver.implicit.damping", "s", moderate, MEMBER(simulation.solver.implicit.damping_s)),
      number_key<Scene>("solver.implicit.tolerance", "", {1e-12, 0.5}, MEMBER(simulation.solver.implicit.tolerance)),
      number_key<Scene>("solver.implicit.stretch_change", "", {1e-6, 1e3},
                        MEMBER(simulation.solver.implicit.max_stretch_change)),
      number_key<Scene>("rest.speed", "m/s", moderate, MEMBER(simulation.rest.speed_m_per_s)),
      whole_key<Scene>("rest.frames", {1, 1000000}, MEMBER(simulation.rest.frames)),
      vector_key<Scene>("gravity.acceleration", "m/s2", MEMBER(surroundings.forces.gravity_m_per_s2)),
      gravity_path_key(),
      number_key<Scene>("air.drag", "1/s", moderate, MEMBER(surroundings.forces.air_drag_per_s)),
      number_key<Scene>("wind.speed", "m/s", {0.0, 200.0}, MEMBER(surroundings.forces.wind.speed_m_per_s)),
      direction_key<Scene>("wind.direction", MEMBER(surroundings.forces.wind.direction)),
      number_key<Scene>("wind.gust_amplitude", "", {0.0, 10.0}, MEMBER(surroundings.forces.wind.gust_amplitude)),
      number_key<Scene>("wind.gust_period", "s", {1e-3, 1e6}, MEMBER(surroundings.forces.wind.gust_period_s)),
      number_key<Scene>("wind.gust_turn", "", {0.0, 10.0}, MEMBER(surroundings.forces.wind.gust_turn)),
      whole_key<Scene>("wind.seed", {0, 9e15}, MEMBER(surroundings.forces.wind.gust_seed)),
      number_key<Scene>("wind.pressure", "", moderate, MEMBER(surroundings.forces.wind.pressure_coefficient)),
      number_key<Scene>("wind.friction", "", moderate, MEMBER(surroundings.forces.wind.friction_coefficient)),
      forces_key(),
      bodies_key(),
      fabric_key(),
      number_key<Scene>("cloth.thickness", "m", thickness, MEMBER(material.thickness_m)),
      number_key<Scene>("cloth.friction", "", friction, MEMBER(material.friction)),
      number_key<Scene>("cloth.bending_rigidity", "N m", moderate, MEMBER(material.bending_rigidity_n_m)),
      number_key<Scene>("cloth.compression_stiffness", "N/m", stiffness,
                        MEMBER(material.compression_stiffness_n_per_m)),
      number_key<Scene>("cloth.tensile_warp", "N/m", stiffness, MEMBER(material.tensile_warp_n_per_m)),
      number_key<Scene>("cloth.tensile_weft", "N/m", stiffness, MEMBER(material.tensile_weft_n_per_m)),
      number_key<Scene>("cloth.shear", "N/m", stiffness, MEMBER(material.shear_n_per_m)),
      number_key<Scene>("cloth.warp_limit", "", elongation, MEMBER(material.warp_limit)),
      number_key<Scene>("cloth.weft_limit", "", elongation, MEMBER(material.weft_limit))};
}

SceneFormat<Scene> simulation_format() {
  const auto check = [](const Scene& scene, const Source& source) {
    if (const std::optional<std::string> reason = unpromised_bound_reason(scene)) fail(source, 0, *reason);
  };
  return {scene_keys(), check};
}

SceneFormat<Scene> undrawn_format() {
  SceneFormat<Scene> format = simulation_format();
  for (const char* section : {"camera", "picture"}) {
    const auto pass_over = [](const toml::node&, const Source&, Scene&) { return true; };
    format.keys.push_back({section, "", "a table", pass_over, [](const Scene&) { return Json(); }});
  }
  return format;
}

sim::Material find_fabric_material(const std::string& fabric, const std::string& option) {
  Scene scene;
  apply_overrides(undrawn_format(), std::vector<Override>{{"cloth.fabric", fabric, option}}, scene);
  return scene.material;
}

void require_one_garment(const toml::table& file, const Source& source) {
  const toml::node* garment = file.get("garment");
  const bool has_file = static_cast<bool>(file["garment"]["file"]);
  const bool has_grid = static_cast<bool>(file["garment"]["grid"]);
  if (has_file == has_grid) {
    fail(source, garment != nullptr ? line_number(*garment) : 0,
         std::string(has_file ? "both garment.file and [garment.grid] are" : "no garment is") +
             " given; expected one of [garment] file = \"...\" and [garment.grid]");
  }
}

// Checks that a named file exists, because readers do not know where it was named.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source, int line) {
  try {
    require_file(named);
  } catch (const InputError& error) {
    fail(source, line, "garment." + key + ": " + error.what());
  }
}

void require_garment(const toml::table& file, const Source& source, const GarmentSource& named,
                     const GarmentSource& used) {
  for (const auto& [name, member] : garment_files) {
    const toml::node* key = file["garment"][name].node();
    if (key != nullptr && used.*member == named.*member) require_named(name, named.*member, source, line_number(*key));
  }
}

}  // namespace taut::app
