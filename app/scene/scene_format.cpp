#include "app/scene/scene_format.hpp"

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

constexpr double degree = 0.017453292519943295;
// Smaller or larger, nothing on it can be told in double precision from its place.
constexpr Range side = {.lowest = 1e-4, .highest = 1e4};
constexpr Range friction = {.lowest = 0.0, .highest = 10.0};
// Of what `implicit` solves for: with more, masses are lost beside it to rounding, and cloth floats where it
// began.
constexpr Range solvable = {.lowest = 0.0, .highest = 1e7};
constexpr Range fraction = {.lowest = 0.0, .highest = 1.0};

Key<Scene> number(std::string name, std::string unit, const Range& range, auto access, std::string meaning,
                  double factor = 1.0) {
  return number_key<Scene>(std::move(name), std::move(unit), range, access, std::move(meaning), factor);
}
Key<Scene> whole(std::string name, double lowest, double highest, auto access, std::string meaning) {
  return whole_key<Scene>(std::move(name), {lowest, highest}, access, std::move(meaning));
}

/// For which promise a frame that breaks it does not fail the run.
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
  return member_key<Scene>(
      "solver.allow_exceeding", "", "true or false or \"bound\" or \"contact\"", MEMBER(simulation.solver.bounded),
      "bounded: a frame does not fail the run whose bound could not be kept (\"bound\"), or in which pins or "
      "bodies make something cross (\"contact\"); true: neither does",
      read, write);
}

}  // namespace

std::vector<Key<Scene>> scene_keys() {
  return {
      text_key<Scene>("title", MEMBER(title), "shown by `taut scenes`"),
      file_key<Scene>("garment.file", MEMBER(garment.file),
                      "a 3D model, relative to the scene file; without it: a grid"),
      number("garment.scale", "m", not_negative, MEMBER(garment.scale),
             "the model's unit of length; 0: what the file says, or else a guess from its size"),
      up_key<Scene>("garment.up", MEMBER(garment.up),
                    "the model's direction that is up; auto: what the file says, or else a guess from its size"),
      weld_key(),
      choice_key<Scene, MeshChoice>(
          "garment.mesh",
          {{"auto", MeshChoice::automatic}, {"model", MeshChoice::model}, {"fitted", MeshChoice::fitted}},
          MEMBER(garment.mesh),
          "the mesh that is simulated: the model's own; or a fitted one of a single clean wall, which the "
          "model then follows; auto: the model's own where it is fit to be simulated"),
      whole("garment.triangles", 200, 200000, MEMBER(garment.most_triangles),
            "fitted: the most triangles; more show finer folds and cost more"),
      whole("garment.subdivisions", 0, 5, MEMBER(garment.subdivisions),
            "of the model: each makes four of every triangle and keeps the shape"),
      whole("garment.grid.columns", 2, 2000, MEMBER(garment.grid.columns), "mass points across"),
      whole("garment.grid.rows", 2, 2000, MEMBER(garment.grid.rows), "mass points down"),
      number("garment.grid.width", "m", side, MEMBER(garment.grid.width_m), "of the cloth"),
      number("garment.grid.height", "m", side, MEMBER(garment.grid.height_m), "of the cloth"),
      choice_key<Scene, sim::GridPlane>(
          "garment.grid.plane", {{"vertical", sim::GridPlane::vertical}, {"horizontal", sim::GridPlane::horizontal}},
          MEMBER(garment.grid.plane), "how the grid lies when the clock starts"),
      vector_key<Scene>("garment.grid.top", "m", MEMBER(garment.grid.top_centre_m), "the middle of row 0"),
      file_key<Scene>("garment.start", MEMBER(garment.start),
                      "where the cloth begins, which keeps the rest shape above: a model of its vertices in "
                      "their order, in metres with y up, as taut simulate --export writes it"),
      switch_key<Scene>("garment.untangle", MEMBER(garment.untangle),
                        "true: where the cloth crosses itself at the start it is moved apart before the run; "
                        "the rest shape stays"),
      number("garment.areal_density", "kg/m2", positive, MEMBER(material.areal_density_kg_per_m2),
             "heavier cloth answers wind less"),
      choice_key<Scene, sim::FlexuralRule>("garment.flexural_rule",
                                           {{"angular", sim::FlexuralRule::angular},
                                            {"opposite-vertex", sim::FlexuralRule::opposite_vertex},
                                            {"none", sim::FlexuralRule::none}},
                                           MEMBER(mapping.flexural_rule), "which vertices flexural springs join"),
      number("garment.flexural_angle", "degrees", {90.0, 180.0}, MEMBER(mapping.smallest_flexural_angle_rad),
             "angular rule: the smallest angle joined; less means more springs, stiffer cloth", degree),
      pins_key(),
      number("pins.width", "m", {0.0, 10.0}, MEMBER(pin_width_m),
             "of the cloth that is held around each pin, as by a clothes peg; 0: the vertices alone"),
      moving_pins_key(),
      vector_key<Scene>("pins.motion.amplitude", "m", MEMBER(surroundings.pin_motion.amplitude_m),
                        "all pins swing by this much, as on a shaken hanger"),
      number("pins.motion.frequency", "Hz", {0.0, 1e4, true}, MEMBER(surroundings.pin_motion.frequency_hz),
             "how often they swing"),
      file_key<Scene>("start.checkpoint", MEMBER(checkpoint),
                      "the run begins with this saved moment, relative to the scene file; without it: as modelled",
                      true),
      number("time.frame_rate", "Hz", {1.0, 10000.0}, MEMBER(simulation.frame_rate_hz), "frames in a simulated second"),
      whole("time.frames", 1, 1000000, MEMBER(frames), "length of the run"),
      choice_key<Scene>("solver.kind", named(sim::all_solver_kinds), MEMBER(simulation.solver.kind),
                        "how springs answer"),
      whole("solver.substeps", 0, 10000, MEMBER(simulation.solver.substeps),
            "time steps in a frame; more stretch less and cost in proportion; 0: as many as needed"),
      whole("solver.max_substeps", 1, 10000, MEMBER(simulation.solver.max_substeps),
            "the most that a solver may choose"),
      whole("solver.iterations", 1, 10000, MEMBER(simulation.solver.strong.iterations),
            "strong: sweeps of the constraint in a step; more stretch less, stiffer"),
      number("solver.compression", "", fraction, MEMBER(simulation.solver.strong.rigidity.compression),
             "strong: how much of its error a too short spring corrects; less folds more easily"),
      number("solver.flexural", "", fraction, MEMBER(simulation.solver.strong.rigidity.flexural),
             "strong: how much of its error a flexural spring corrects; less bends more easily"),
      number("solver.max_stretch", "", not_negative, MEMBER(simulation.solver.bounded.max_stretch),
             "bounded: no frame shows what solver.bound names stretched more; provot: springs stretched more "
             "are pulled back; vassilev: those stretch no further; fast-projection: what is left of strain"),
      whole("solver.projections", 1, 1000, MEMBER(simulation.solver.fast_projection.most_projections),
            "fast-projection: the most in a step; more come nearer to solver.max_stretch"),
      choice_key<Scene>("solver.bound", named(sim::all_bound_kinds), MEMBER(simulation.solver.bounded.bound),
                        "bounded: what is held: every spring; or the surface, which is every triangle in "
                        "every direction, and springs too"),
      switch_key<Scene>("solver.contact", MEMBER(simulation.solver.bounded.contact),
                        "bounded: keeps the cloth from crossing itself too, not only bodies; costs more"),
      switch_key<Scene>("solver.tethers", MEMBER(simulation.solver.bounded.tethers),
                        "bounded: cloth is held by long threads from its pins too; less work"),
      choice_key<Scene>("solver.vector_unit", named(sim::all_vector_units),
                        MEMBER(simulation.solver.bounded.vector_unit),
                        "bounded: instructions to use; none changes a result"),
      whole("solver.threads", 0, sim::most_threads, MEMBER(simulation.solver.bounded.threads),
            "bounded: none changes a result; 0: more than one above some 20000 triangles"),
      allow_key(),
      number("solver.stiffness.structural", "N/m", not_negative,
             MEMBER(simulation.solver.ideal.stiffness.structural_n_per_m), "ideal, provot, vassilev: of mesh edges"),
      number("solver.stiffness.shear", "N/m", not_negative, MEMBER(simulation.solver.ideal.stiffness.shear_n_per_m),
             "ideal, provot, vassilev, fast-projection: of grid diagonals"),
      number("solver.stiffness.flexural", "N/m", not_negative,
             MEMBER(simulation.solver.ideal.stiffness.flexural_n_per_m), "the same: of flexural springs"),
      number("solver.stiffness.damping", "N s/m", not_negative,
             MEMBER(simulation.solver.ideal.stiffness.damping_n_s_per_m), "the same: of every spring"),
      number("solver.implicit.stretch", "N/m", solvable, MEMBER(simulation.solver.implicit.stretch_n_per_m),
             "implicit: of the surface along warp and weft; more stretches less and costs more"),
      number("solver.implicit.shear", "N/m", solvable, MEMBER(simulation.solver.implicit.shear_n_per_m),
             "implicit: against shear; half of the stretch's is alike in all directions"),
      number("solver.implicit.damping", "s", not_negative, MEMBER(simulation.solver.implicit.damping_s),
             "implicit: of each stiffness, in parts of it; more comes to rest sooner"),
      number("solver.implicit.tolerance", "", {1e-12, 0.5}, MEMBER(simulation.solver.implicit.tolerance),
             "implicit: the residual that linear systems are solved to; less costs more"),
      number("solver.implicit.stretch_change", "", {1e-6, 1e3},
             MEMBER(simulation.solver.implicit.largest_stretch_change),
             "implicit: a step that changes a triangle's stretch by more is halved"),
      number("rest.speed", "m/s", not_negative, MEMBER(simulation.rest.speed_m_per_s),
             "cloth that goes no further than by this speed (root mean square) counts as at rest and is put "
             "to sleep"),
      whole("rest.frames", 1, 1000000, MEMBER(simulation.rest.frames), "at rest in so many frames"),
      vector_key<Scene>("gravity.acceleration", "m/s2", MEMBER(surroundings.forces.gravity_m_per_s2), "y is up"),
      gravity_path_key(),
      number("air.drag", "1/s", not_negative, MEMBER(surroundings.forces.air_drag_per_s),
             "how fast the air slows cloth down; more comes to rest sooner"),
      number("wind.speed", "m/s", {0.0, 200.0}, MEMBER(surroundings.forces.wind.speed_m_per_s),
             "the paper's wind value"),
      vector_key<Scene>("wind.direction", "", MEMBER(surroundings.forces.wind.direction),
                        "where the air goes, of any length", {.may_be_zero = false}),
      number("wind.gust_amplitude", "", {0.0, 10.0}, MEMBER(surroundings.forces.wind.gust_amplitude),
             "how much gusts change the speed, as a fraction of it"),
      number("wind.gust_period", "s", positive, MEMBER(surroundings.forces.wind.gust_period_s), "from gust to gust"),
      number("wind.gust_turn", "", {0.0, 10.0}, MEMBER(surroundings.forces.wind.gust_turn),
             "how far gusts turn the wind, as the tangent of the angle"),
      whole("wind.seed", 0, 9e15, MEMBER(surroundings.forces.wind.gust_seed), "the same seed gives the same gusts"),
      number("wind.pressure", "", not_negative, MEMBER(surroundings.forces.wind.pressure_coefficient),
             "force coefficient of cloth met head on"),
      number("wind.friction", "", not_negative, MEMBER(surroundings.forces.wind.friction_coefficient),
             "force coefficient of air that strokes along cloth"),
      forces_key(),
      bodies_key(),
      fabric_key(),
      number("cloth.thickness", "m", not_negative, MEMBER(material.thickness_m),
             "of one layer, as a gauge measures it; kept to bodies, and by bounded between layers too"),
      number("cloth.friction", "", friction, MEMBER(material.friction),
             "Coulomb's coefficient, between layers and of bodies that have none of their own"),
      number("cloth.bending_rigidity", "N m", not_negative, MEMBER(material.bending_rigidity_n_m),
             "bounded, implicit: of the fabric, whatever its mesh; a soft jersey 5e-6, denim 98e-6"),
      number("cloth.compression_stiffness", "N/m", not_negative, MEMBER(material.compression_stiffness_n_per_m),
             "bounded: of springs that are too short; less crumples more easily"),
      number("cloth.tensile_warp", "N/m", not_negative, MEMBER(material.tensile_warp_n_per_m),
             "bounded, surface: tension over strain along the warp; 0 in all three: cloth gives as far as "
             "solver.max_stretch lets it"),
      number("cloth.tensile_weft", "N/m", not_negative, MEMBER(material.tensile_weft_n_per_m),
             "the same along the weft"),
      number("cloth.shear", "N/m", not_negative, MEMBER(material.shear_n_per_m), "the same against shear, per radian"),
      number("cloth.warp_limit", "", positive, MEMBER(material.warp_limit),
             "the strain at which its threads lock along the warp"),
      number("cloth.weft_limit", "", positive, MEMBER(material.weft_limit), "the same along the weft")};
}

SceneFormat<Scene> simulation_format() {
  const auto check = [](const Scene& scene, const Source& source) {
    if (const std::optional<std::string> reason = beyond_promise(scene)) fail(source, 0, *reason);
  };
  return {scene_keys(), check};
}

SceneFormat<Scene> undrawn_format() {
  SceneFormat<Scene> format = simulation_format();
  for (const char* section : {"camera", "picture"}) {
    const auto pass_over = [](const toml::node&, const Source&, Scene&) { return true; };
    format.keys.push_back({section, "", "a table", "", pass_over, [](const Scene&) { return Json(); }});
  }
  return format;
}

sim::Material material_of(const std::string& fabric, const std::string& option) {
  Scene scene;
  apply_overrides(undrawn_format(), std::vector<Override>{{"cloth.fabric", fabric, option}}, scene);
  return scene.material;
}

void require_one_garment(const toml::table& file, const Source& source) {
  const toml::node* garment = file.get("garment");
  const bool has_file = static_cast<bool>(file["garment"]["file"]);
  const bool has_grid = static_cast<bool>(file["garment"]["grid"]);
  if (has_file == has_grid) {
    fail(source, garment != nullptr ? line_of(*garment) : 0,
         std::string(has_file ? "both garment.file and [garment.grid] are" : "no garment is") +
             " given; expected one of [garment] file = \"...\" and [garment.grid]");
  }
}

// Here and not where it is read, which does not know who names it.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source, int line) {
  try {
    require_file(named);
  } catch (const InputError& error) {
    fail(source, line, "garment." + key + ": " + error.what());
  }
}

void require_garment_of(const toml::table& file, const Source& source, const GarmentSource& named,
                        const GarmentSource& used) {
  for (const auto& [name, member] : garment_files) {
    const toml::node* key = file["garment"][name].node();
    if (key != nullptr && used.*member == named.*member) {
      require_named(name, named.*member, source, line_of(*key));
    }
  }
}

}  // namespace taut::app
