#include <nlohmann/json.hpp>

#include "app/bench/bench_output.hpp"
#include "app/bench/engines/bullet_engine.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const Run& run, const BenchResults& results) {
  const RunFacts facts = facts_of(run);
  Json over = Json::array();
  for (const double bound : results.bounds) {
    over.push_back({{"bound", bound}, {"frames", frames_over(run, bound)}});
  }
  Json json = {{"engine", run.entrant.engine},
               {"settings", run.entrant.settings},
               {"bound", nullptr},
               {"bound_holds", nullptr},
               {"end", name_of(run.end)},
               {"frames", run.frames.size()},
               {"median_ms", facts.median_ms},
               {"mean_ms", facts.mean_ms},
               {"p99_ms", facts.p99_ms},
               {"max_raw_stretch", facts.raw_stretch},
               {"max_stretch", facts.stretch},
               {"max_p99_stretch", facts.p99_stretch},
               {"max_surface_stretch", facts.surface_stretch},
               {"max_p99_surface_stretch", facts.p99_surface_stretch},
               {"frames_over", over},
               {"frames_not_certified", facts.not_certified},
               {"median_substeps", facts.median_substeps},
               {"most_substeps", facts.most_substeps},
               {"projections_per_s", facts.projections_per_s}};
  if (run.entrant.bound) {
    json["bound"] = *run.entrant.bound;
  }
  if (run.entrant.held) {
    json["bound_holds"] = name_of(*run.entrant.held);
  }
  return json;
}

std::size_t index_of(const Heat& heat, const Run& run) {
  return static_cast<std::size_t>(&run - heat.runs.data());
}

Json cell_json(const Heat& heat, const std::string& engine, double bound) {
  Json json = {{"bound", bound}, {"engine", engine}};
  const Run* best = best_run(heat, engine, bound);
  const Run* closest = closest_run(heat, engine, bound);
  json["kept"] = best != nullptr;
  if (const Run* told = best != nullptr ? best : closest) {
    const RunFacts facts = facts_of(*told);
    json["run"] = index_of(heat, *told);
    json["median_ms"] = facts.median_ms;
    json["max_stretch"] = facts.stretch;
    json["max_p99_stretch"] = facts.p99_stretch;
    json["max_surface_stretch"] = facts.surface_stretch;
    json["max_p99_surface_stretch"] = facts.p99_surface_stretch;
    json["of_sweep"] = facts.projections_per_s / heat.sweeps.back().springs_per_s;
    const double strong = strong_projections_per_s(heat);
    json["times_strong_projections_per_s"] = strong > 0.0 ? Json(facts.projections_per_s / strong) : Json();
  }
  return json;
}

Json fronts_json(const Heat& heat, const std::vector<std::string>& engines, StretchMeasure measure) {
  Json fronts = Json::object();
  for (const std::string& engine : engines) {
    std::vector<DataPoint> points;
    std::vector<std::size_t> runs;
    for (const Run& run : heat.runs) {
      if (run.entrant.engine == engine && run.end == RunEnd::finished && !run.frames.empty()) {
        points.push_back({facts_of(run).median_ms, stretch_by(measure, facts_of(run))});
        runs.push_back(index_of(heat, run));
      }
    }
    fronts[engine] = Json::array();
    for (const std::size_t i : pareto_front(points)) {
      fronts[engine].push_back(runs[i]);
    }
  }
  return fronts;
}

Json ratios_json(const Heat& heat) {
  Json ratios = Json::array();
  for (const std::string peer : {"bullet", "strong"}) {
    for (const StretchMeasure measure : stretch_measures) {
      const auto ratio = speed_ratio(heat, 0.01, peer, 0.05, measure);
      if (!ratio) {
        continue;
      }
      ratios.push_back({{"by", name_of(measure)},
                        {"bounded_bound", 0.01},
                        {"bounded_ms", ratio->bounded_ms},
                        {"peer", peer},
                        {"peer_bound", 0.05},
                        {"peer_ms", ratio->peer_ms},
                        {"peer_settings", ratio->peer_settings},
                        {"times_faster", ratio->ratio()}});
    }
  }
  return ratios;
}

Json sweeps_json(const Heat& heat) {
  Json sweeps = Json::array();
  for (const SweepSpeed& sweep : heat.sweeps) {
    sweeps.push_back({{"vector_unit", sweep.unit}, {"springs_per_s", sweep.springs_per_s}});
  }
  return sweeps;
}

Json heat_json(const Heat& heat, const BenchResults& results) {
  const std::vector<std::string> engines = engines_in(results);
  Json settings = Json::object();
  for (const Setting& setting : settings_of(heat.scene, heat.size)) {
    settings[setting.key] = setting.value;
  }
  Json json = {{"scene", heat.scene.name},
               {"meaning", heat.scene.meaning},
               {"triangles", heat.size.triangles},
               {"model", "tshirt_" + std::to_string(heat.size.model)},
               {"base_scene", bench_base_scene},
               {"scene_settings", settings},
               {"springs", {{"structural", heat.structural_springs}, {"flexural", heat.flexural_springs}}},
               {"sweeps", sweeps_json(heat)},
               {"cells", Json::array()},
               {"ratios", ratios_json(heat)},
               {"pareto_fronts", fronts_json(heat, engines, StretchMeasure::worst_edge)},
               {"pareto_fronts_p99", fronts_json(heat, engines, StretchMeasure::p99)},
               {"runs", Json::array()}};
  for (const double bound : results.bounds) {
    for (const std::string& engine : engines) {
      json["cells"].push_back(cell_json(heat, engine, bound));
    }
  }
  for (const Run& run : heat.runs) {
    json["runs"].push_back(run_json(run, results));
  }
  return json;
}

Json growth_json(const BenchResults& results) {
  Json all = Json::array();
  for (const std::string& scene : bench_scene_names()) {
    for (const double bound : results.bounds) {
      for (const std::string& engine : engines_in(results)) {
        if (const auto growth = growth_of(results, scene, engine, bound)) {
          all.push_back({{"scene", scene},
                         {"bound", bound},
                         {"engine", engine},
                         {"exponent", growth->exponent},
                         {"sizes", growth->sizes}});
        }
      }
    }
  }
  return all;
}

}  // namespace

Json machine_json(const Machine& machine) {
  return {{"processor", machine.processor}, {"threads", machine.threads},   {"system", machine.system},
          {"load", machine.load},           {"compiler", machine.compiler}, {"program", machine.program}};
}

std::string bench_json(const BenchResults& results, const Machine& machine) {
  Json json = {{"machine", machine_json(machine)},
               {"bullet", bullet_version().empty() ? Json() : Json(bullet_version())},
               {"frames", results.frames},
               {"frame_rate", results.frame_rate_hz},
               {"bounds", results.bounds},
               {"ablation", results.is_ablation},
               {"growth", growth_json(results)},
               {"heats", Json::array()}};
  for (const Heat& heat : results.heats) {
    json["heats"].push_back(heat_json(heat, results));
  }
  return json.dump(2) + "\n";
}

}  // namespace taut::app
