#include "app/sewing/sewing.hpp"

#include "app/base/interruption.hpp"
#include "app/base/words.hpp"
#include "app/bodies/fit.hpp"
#include "app/bodies/wearing.hpp"
#include "app/models/obj_writing.hpp"
#include "app/models/scene_crossings.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/scene/scene_format.hpp"
#include "app/scene/scene_key.hpp"
#include "app/sewing/placing.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

constexpr double cm = 0.01;
/// More time steps help no garment that is too small, which then takes minutes to be refused.
constexpr int most_substeps = 250;
// Where it comes to rest does not depend on the air, but how soon does: it gets thicker by that much every so
// many frames.
constexpr double resting_drag_per_s = 6.0;
constexpr double thicker = 1.5;
constexpr int frames_to_thicker = 60;
/// Over all of it, until it rests. Cloth that is nearly too small takes as many in each frame as others in all.
constexpr double most_sweeps = 150e3;
constexpr double of_one_limb = 0.6;  ///< of a girth, at most

[[noreturn]] void refuse_open(SewnGarment garment) {
  const SewnPieces& sewn = garment.sewn;
  const std::string message =
      fmt::format("a seam stays open: {}, by {:.1f} cm at {}{}",
                  garment.pattern.describe(garment.pattern.stitches[sewn.open_stitch]), sewn.gap_m / cm,
                  describe_place(sewn.gap_place_m), sewn.reason.empty() ? "" : "; " + sewn.reason);
  throw SewingFailed(message, std::move(garment));
}

/// Makes outer layers of their own fabrics.
sim::Garment of_fabrics(sim::Garment cloth, const SewnGarment& garment) {
  if (garment.over_fabrics.empty()) return cloth;
  std::vector<sim::Material> others;
  for (const std::string& fabric : garment.over_fabrics) others.push_back(material_of(fabric, "--over-fabric"));
  std::vector<std::uint8_t> layer_of(cloth.mesh.positions.size());
  for (std::size_t v = 0; v < garment.pieces.flat_m.size(); ++v) {
    layer_of[garment.sewn.vertex_of[v]] =
        static_cast<std::uint8_t>(garment.pieces.layer_of[garment.pieces.panel_of[v]]);
  }
  try {
    return sim::with_others(std::move(cloth), std::move(layer_of), std::move(others));
  } catch (const std::invalid_argument& error) {
    throw InputError("--over-fabric: {}; expected a fabric for all (--fabric)", error.what());
  }
}

/// Says in which panel it is stretched most, and beside which seam.
std::string describe_tightest(const SewnGarment& garment) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const std::vector<double> stretch = sim::triangle_surface_stretch(garment.sewn.garment, mesh.positions);
  const auto t = static_cast<std::size_t>(std::ranges::max_element(stretch) - stretch.begin());
  const Vec3 at_m = mesh.positions[mesh.triangles[t][0]];
  std::size_t nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < garment.pieces.seams.size(); ++s) {
    for (const auto& [a, b] : garment.pieces.seams[s]) {
      const double off_m = glm::distance(mesh.positions[garment.sewn.vertex_of[a]], at_m);
      nearest = off_m < least_m ? s : nearest;
      least_m = std::min(least_m, off_m);
    }
  }
  const sim::Index panel = garment.pieces.panel_of[garment.pieces.triangles[t][0]];
  return fmt::format("it is tightest in the panel '{}', beside the seam of {}", garment.pattern.panels[panel].name,
                     garment.pattern.describe(garment.pattern.stitches[nearest]));
}

/// Lets the body grow into what was sewn, and that come to rest.
void wear(const Scene& scene, const SewingSettings& settings, const std::function<void(const std::string&)>& stage,
          SewnGarment& garment) {
  SewnPieces& sewn = garment.sewn;
  sewn.garment = of_fabrics(sim::with_material(std::move(sewn.garment), scene.material), garment);
  // As of any garment that begins where it lies.
  sewn.garment.parted_m.clear();
  RunSettings run = scene.simulation;
  run.solver.max_substeps = std::min(run.solver.max_substeps, most_substeps);
  sim::Surroundings thick_air = scene.surroundings;
  double& air_per_s = thick_air.forces.air_drag_per_s;
  air_per_s = std::max(air_per_s, resting_drag_per_s);
  // In it cloth that comes loose is no faster than it can be kept apart.
  sim::Simulation simulation(sim::share(sewn.garment), {}, simulation_settings(run), thick_air,
                             sewn.garment.mesh.positions);
  const auto keep = [&] {
    sewn.garment.mesh.positions = simulation.state().current;
    garment.time_s = simulation.state().time_s;
  };
  std::vector<FitRow> fit = fit_of(scene, sewn.garment, sewn.garment.mesh.positions);
  // Where the body is thin a level may meet one limb alone.
  std::erase_if(fit, [](const FitRow& row) { return row.garment_m < of_one_limb * row.body_m; });
  const auto refuse = [&](const std::exception& error) {
    keep();
    const std::string tight = describe_tightness(scene, sewn.garment, sewn.garment.mesh.positions, fit);
    const std::string message =
        "its seams are closed, but it cannot be worn: " + (error.what() + describe_misfit(fit)) + "; " +
        describe_tightest(garment) + (tight.empty() ? "" : "; " + tight);
    throw SewingFailed(message, std::move(garment));
  };
  try {
    stage("the body grows into it");
    dress(scene, simulation);
    simulation.set_settings(simulation_settings(scene.simulation));
    double sweeps = 0.0;
    for (; garment.frames < settings.frames && !simulation.state().asleep && sweeps < most_sweeps; ++garment.frames) {
      throw_if_interrupted();
      stage(fmt::format("worn for {} of {} frames", garment.frames, settings.frames));
      if (garment.frames % frames_to_thicker == 0) {
        simulation.set_surroundings(thick_air);
        air_per_s *= thicker;
      }
      simulation.advance_frame(throw_if_interrupted);
      sweeps += simulation.last_report().sweeps;
    }
  } catch (const InputError& error) {
    refuse(error);
  } catch (const PromiseBroken& error) {
    refuse(error);
  } catch (const sim::ContactBlocked& error) {
    refuse(error);
  }
  garment.is_at_rest = simulation.state().asleep;
  garment.rms_speed_m_per_s = sim::rms_speed(simulation.change());
  keep();
}

void verify(const Scene& scene, SewnGarment& garment) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const BodyMeasures& measures = dressed_body(scene).wearer->measures;
  if (sim::extent_of(mesh.positions).upper.y < measures.levels[measures.fork].height_m) {
    throw SewingFailed("its seams are closed, but it does not stay on the body: it falls down", std::move(garment));
  }
  const Surface cloth = {mesh.positions, mesh.triangles};
  for (const SceneCrossings& crossings : scene_crossings(cloth, scene.surroundings.bodies, garment.time_s)) {
    if (!crossings.pairs.empty()) {
      const std::string found = describe(crossings, cloth, scene.surroundings.bodies);
      throw SewingFailed("when it is worn, " + found, std::move(garment));
    }
  }
  garment.max_stretch = largest_stretch(mesh, mesh.positions).surface;
  const double bound = scene.simulation.solver.bounded.max_stretch;
  if (garment.max_stretch > bound + bound_rounding) {
    throw SewingFailed(
        fmt::format("its seams are closed, but worn for {} frames it is stretched by {:.3f} %; expected at "
                    "most solver.max_stretch = {:g}",
                    garment.frames, 100.0 * garment.max_stretch, bound),
        std::move(garment));
  }
}

CutPieces cut(const std::filesystem::path& file, const SewingPattern& pattern, int triangles) {
  try {
    return cut_pieces(pattern, triangles);
  } catch (const std::invalid_argument& error) {
    throw InputError("cannot use '{}': {}", file.string(), error.what());
  }
}

/// Keeps the pattern and how it is placed, and the first moment in which half of it is closed.
void keep_step(double share, const sim::Garment& now, const std::vector<Vec3>& positions_m, SewnGarment& garment) {
  constexpr double half = 0.5;
  if (garment.steps.empty()) {
    std::vector<Vec3> flat_m;
    for (const sim::Vec2& at : garment.pieces.flat_m) flat_m.emplace_back(at, 0.0);
    garment.steps = {{"the pattern", now, std::move(flat_m), garment.time_s},
                     {"placed", now, positions_m, garment.time_s}};
  } else if (garment.steps.size() == 2 && share >= half) {
    garment.steps.push_back({"half closed", now, positions_m, garment.time_s});
  }
}

}  // namespace

SewnGarment sew(Scene& scene, const SewingSettings& settings, const std::function<void(const std::string&)>& stage) {
  SewnGarment garment;
  std::vector<std::filesystem::path> files = {scene.garment.file};
  files.insert(files.end(), settings.over.begin(), settings.over.end());
  garment.over_fabrics = settings.over_fabrics;
  stage("meshing its panels");
  for (const std::filesystem::path& file : files) {
    SewingPattern pattern = read_sewing_pattern(file);
    CutPieces pieces = cut(file, pattern, settings.triangles / static_cast<int>(files.size()));
    for (std::string& remark : bring_to_body(pattern, scene, pieces)) {
      garment.remarks.push_back((files.size() > 1 ? file.stem().string() + ": " : "") + remark);
    }
    if (garment.pattern.panels.empty()) {
      garment.pattern = std::move(pattern);
      garment.pieces = std::move(pieces);
    } else {
      garment.over_names.push_back(file.stem().string());
      add_pattern(garment.over_names.back(), std::move(pattern), garment.pattern);
      add_over(pieces, garment.pieces);
    }
  }
  for (std::string& remark : place_pieces(garment.pieces, scene)) garment.remarks.push_back(std::move(remark));
  garment.time_s = thin_time_s(scene);
  garment.sewn =
      close_seams(garment.pieces, scene, garment.time_s,
                  [&](double share, const sim::Garment& now, const std::vector<Vec3>& positions_m) {
                    stage(fmt::format("drawing its seams together, {:.0f} % are closed", std::floor(100.0 * share)));
                    keep_step(share, now, positions_m, garment);
                  });
  if (garment.sewn.gap_m > 0.0) refuse_open(std::move(garment));
  wear(scene, settings, stage, garment);
  verify(scene, garment);
  return garment;
}

std::string obj_of(const SewnGarment& garment) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  std::vector<glm::vec2> corner_uv;
  for (const auto& corners : mesh.cut_m) {
    for (const sim::Vec2& corner : corners) corner_uv.emplace_back(corner / metres_per_uv_of_cut);
  }
  FileFaces faces = faces_of(mesh, corner_uv);
  for (std::size_t p = 0; p < garment.pattern.panels.size(); ++p) {
    faces.sections.push_back({garment.pieces.panel_triangles[p], "g " + garment.pattern.panels[p].name});
  }
  return obj_text(faces, mesh.positions, {});
}

std::string landmarks_of(const SewnGarment& garment) {
  std::string text = "# As it is cut: lengths at rest are those of the texture coordinates, which are cm.\n" +
                     fmt::format("metres_per_uv = {}\nis_cut = true\n", metres_per_uv_of_cut);
  if (!garment.over_names.empty()) {
    text += fmt::format("\n# Garments that are worn over each other.\nlayers = {}\n", garment.over_names.size() + 1);
  }
  if (!garment.over_fabrics.empty()) text += "\n# Of groups whose names begin so.\n[fabrics]\n";
  for (std::size_t k = 0; k < garment.over_fabrics.size(); ++k) {
    text += toml_text(garment.over_names[k] + ".") + " = " + toml_text(garment.over_fabrics[k]) + "\n";
  }
  text += "\n# Vertices along its seams, from 0.\n[seams]\n";
  for (std::size_t s = 0; s < garment.pieces.seams.size(); ++s) {
    std::string vertices;
    for (const auto& [a, b] : garment.pieces.seams[s]) {
      vertices += (vertices.empty() ? "" : ", ") + std::to_string(garment.sewn.vertex_of[a]);
    }
    text += toml_text(garment.pattern.describe(garment.pattern.stitches[s])) + " = [" + vertices + "]\n";
  }
  return text;
}

}  // namespace taut::app
