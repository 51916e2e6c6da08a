#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/library/border.hpp"
#include "app/models/inspection.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sewing/sewing.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::library {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::vector<app::Override> overrides_of(const TautOptions& options) {
  require(options.settings != nullptr || options.setting_count == 0, "found settings of NULL");
  require(options.setting_count <= 100000, "found more than 100000 settings");
  std::vector<app::Override> overrides;
  for (std::size_t k = 0; k < options.setting_count; ++k) {
    require(options.settings[k] != nullptr, "found a setting of NULL");
    const std::string text = options.settings[k];
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw ArgumentError("found the setting '" + text + "', expected KEY = VALUE, such as wind.speed = 4");
    }
    overrides.push_back({trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)), text});
  }
  return overrides;
}

app::Scene scene_of(const TautOptions& options, const std::vector<app::Override>& overrides) {
  const int named =
      (options.scene != nullptr ? 1 : 0) + (options.scene_text != nullptr ? 1 : 0) + (options.mesh != nullptr ? 1 : 0);
  require(named == 1, "expected exactly one of scene, scene_text and mesh");
  if (options.scene != nullptr) return app::find_scene(app::undrawn_format(), options.scene, overrides);
  if (options.scene_text != nullptr) {
    return app::read_scene(app::undrawn_format(), options.scene_text, "scene text", overrides);
  }
  app::Scene scene;
  scene.name = "mesh";
  scene.garment.given = std::make_shared<const app::ImportedModel>(model_from(options.mesh));
  scene.garment.mesh = app::MeshChoice::model;
  app::apply_overrides(app::undrawn_format(), overrides, scene);
  require(scene.garment.file.empty(), "garment.file: expected no file where a mesh is given");
  require(scene.garment.subdivisions == 0, "garment.subdivisions: expected a mesh that is subdivided already");
  return scene;
}

void set_importer(const TautOptions& options, app::Scene& scene) {
  if (options.importer != nullptr) {
    scene.garment.importer = options.importer;
    for (app::BodySource& source : scene.body_sources) source.importer = options.importer;
  }
}

void set_threads(const TautOptions& options, app::Scene& scene) {
  require(options.threads >= 0 && options.threads <= sim::most_threads, "threads: expected 1 to 64, or 0");
  if (options.threads > 0) scene.simulation.solver.bounded.threads = options.threads;
}

void put_bodies_in(const TautOptions& options, Start& start) {
  require(options.bodies != nullptr || options.body_count == 0, "found bodies of NULL");
  for (std::size_t k = 0; k < options.body_count; ++k) {
    GivenBody given = take_body(options.bodies[k], start.scene);
    const std::size_t number = put_in(given, start.scene);
    if (given.lent) start.lent[number] = std::move(*given.lent);
    start.listener.tell(given.remarks);
  }
}

}  // namespace

void Listener::tell(const std::vector<std::string>& lines) const {
  for (const std::string& line : lines) {
    if (log != nullptr) log(user, line.c_str());
  }
}

Start load(const TautOptions& options) {
  Start start;
  start.listener = {options.log, options.log_user};
  start.scene = scene_of(options, overrides_of(options));
  set_importer(options, start.scene);
  set_threads(options, start.scene);
  if (options.start != nullptr) {
    start.scene.garment.given_start_m = std::make_shared<const std::vector<sim::Vec3>>(points_from(options.start));
  }
  put_bodies_in(options, start);
  start.listener.tell(app::sew_and_load_bodies(start.scene));
  start.loaded = app::load_garment(start.scene);
  start.listener.tell(app::put_where_it_begins(start.loaded, start.scene));
  start.listener.tell(app::remarks_of(start.loaded));
  const app::StartRemarks remarks = app::remarks_on_start(start.scene, start.loaded);
  start.listener.tell(remarks.lines);
  start.crossings = remarks.crossings;
  if (options.struct_size == smallest_size<TautOptions>) {
    start.listener = {};  // a caller of then may have ended its log with the call
  }
  return start;
}

}  // namespace taut::library
