#include "app/output/run_report.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {

extern const char* const statistics_texts;  ///< assets/texts/statistics.toml

namespace {

/// Column of the statistics of a frame.
struct FrameColumn {
  const char* name;
  Json (*value)(const FrameRecord&);
  bool needs_verification = false;
};

// JSON has no infinity; -1 means no frame. Both become null.
Json number_json(double number) { return std::isfinite(number) ? Json(number) : Json(); }

Json number_json(int number) { return number >= 0 ? Json(number) : Json(); }

#define VALUE(of_record) [](const FrameRecord& r) -> Json { return of_record; }
const FrameColumn frame_columns[] = {
    {"frame", VALUE(r.frame)},
    {"time_s", VALUE(r.time_s)},
    {"max_stretch", VALUE(r.stretch.max)},
    {"p99_stretch", VALUE(r.stretch.p99)},
    {"max_surface_stretch", VALUE(r.surface_stretch.max)},
    {"p99_surface_stretch", VALUE(r.surface_stretch.p99)},
    {"mean_stretch", VALUE(r.stretch.mean)},
    {"raw_max_stretch", VALUE(r.raw_max_stretch)},
    {"bound_kept", VALUE(r.bound_kept)},
    {"substeps", VALUE(r.substeps)},
    {"max_compression", VALUE(r.stretch.max_compression)},
    {"rms_speed", VALUE(r.rms_speed_m_per_s)},
    {"kinetic_energy", VALUE(r.energy.kinetic_j)},
    {"potential_energy", VALUE(r.energy.potential_j)},
    {"wind_force", VALUE(glm::length(r.wind.force_n))},
    {"wind_power", VALUE(r.wind.power_w)},
    {"convergence", VALUE(r.convergence_m)},
    {"sim_ms", VALUE(r.sim_ms)},
    {"draw_ms", VALUE(r.draw_ms)},
    {"encode_ms", VALUE(r.encode_ms)},
    {"state_hash", VALUE(fmt::format("{:016x}", r.state_hash))},
    {"asleep", VALUE(r.asleep)},
    {"detections", VALUE(r.contact.detections)},
    {"partial_detections", VALUE(r.contact.partial_detections)},
    {"contact_pairs", VALUE(r.contact.max_pairs)},
    {"smallest_distance", VALUE(number_json(r.contact.min_distance_m))},
    {"measured_crossings", VALUE(r.contact.crossing_pairs)},
    {"left_out_share", VALUE(r.contact.excluded_area_fraction)},
    {"crossing_pairs", VALUE(r.crossing_pairs.value_or(0)), true},
};
#undef VALUE

bool is_written(const FrameColumn& column, bool is_verified) { return is_verified || !column.needs_verification; }

Json record_json(const FrameRecord& record) {
  Json json = Json::object();
  for (const FrameColumn& column : frame_columns) {
    if (is_written(column, record.crossing_pairs.has_value())) json[column.name] = column.value(record);
  }
  return json;
}

// Replaces bytes of file names that are not UTF-8.
std::string to_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

/// Returns the named members of a summary, and means.
Json summary_json(const RunSummary& summary) {
  Json json = Json::object();
  for_each_field(summary, [&](const char* name, const auto& number) {
    if (name == nullptr) return;
    // Each mean comes before the member that it belongs to.
    if (&number == static_cast<const void*>(&summary.final_rms_speed_m_per_s)) {
      json["mean_substeps"] = summary.mean_substeps();
    } else if (&number == static_cast<const void*>(&summary.total_sim_ms)) {
      json["mean_sim_ms"] = summary.mean_sim_ms();
    }
    json[name] = number_json(number);
  });
  return json;
}

namespace fs = std::filesystem;

// Returns the number of bytes up to the end of that frame's line.
std::uintmax_t end_of_frame(const fs::path& path, StatisticsFormat format, const RunDescription& run, int frame) {
  if (!fs::exists(path)) {
    throw InputError("cannot go on with '" + path.string() +
                     "': there is no such file; the run goes on in the statistics of its first part, so name "
                     "that file, or none");
  }
  const std::string text = read_text_file(path, max_run_bytes);
  const std::string names = statistics_header(StatisticsFormat::csv, run);
  if (format == StatisticsFormat::csv && !text.starts_with(names)) {
    throw InputError("cannot go on with '" + path.string() + "': found the columns " + text.substr(0, text.find('\n')) +
                     ", expected " + names.substr(0, names.size() - 1));
  }
  const std::string start = '\n' + statistics_line_start(format, frame);
  const std::size_t line = text.find(start);
  const std::size_t end = line == std::string::npos ? line : text.find('\n', line + start.size());
  if (end == std::string::npos) {
    throw InputError("cannot go on with '" + path.string() + "': it has no line of frame " + std::to_string(frame) +
                     ", after which the run goes on");
  }
  return end + 1;
}

}  // namespace

StatisticsFormat statistics_format(const std::filesystem::path& file) {
  // A file without an ending, such as /dev/stdout, gets JSON lines.
  if (file.has_extension() && file.extension() != ".jsonl" && file.extension() != ".csv") {
    throw UsageError("--stats " + file.string() + ": expected a file name that ends in .jsonl or .csv");
  }
  return file.extension() == ".csv" ? StatisticsFormat::csv : StatisticsFormat::json_lines;
}

std::string statistics_header(StatisticsFormat format, const RunDescription& run) {
  if (format == StatisticsFormat::json_lines) {
    Json versions = {{"program", program_version()}, {"compiler", compiler_version()}};
    if (!run.gl_renderer.empty()) versions["gl_renderer"] = run.gl_renderer;
    return to_line({{"scene", run.scene.name},
                    {"garment",
                     {{"vertices", run.garment.mesh.positions.size()},
                      {"triangles", run.garment.mesh.triangles.size()},
                      {"springs", springs_json(run.garment.springs)},
                      {"pins", run.pins}}},
                    {"settings", scene_settings(run.scene)},
                    {"versions", versions}});
  }
  std::string names;
  for (const FrameColumn& column : frame_columns) {
    if (is_written(column, run.is_verified)) names += (names.empty() ? "" : ",") + std::string(column.name);
  }
  return names + '\n';
}

std::string statistics_line(StatisticsFormat format, const FrameRecord& record) {
  if (format == StatisticsFormat::json_lines) return to_line(record_json(record));
  const auto to_cell = [](const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); };
  return join(collect<std::string>(record_json(record), to_cell), ",") + '\n';
}

std::string statistics_end(StatisticsFormat format, const RunSummary& summary) {
  return format == StatisticsFormat::json_lines ? to_line({{"summary", summary_json(summary)}}) : "";
}

std::string statistics_line_start(StatisticsFormat format, int frame) {
  return (format == StatisticsFormat::json_lines ? "{\"frame\":" : "") + std::to_string(frame) + ',';
}

std::string statistics_help() {
  const toml::table texts = toml::parse(statistics_texts);
  std::string text = texts["about"].value_or(std::string()) + '\n';
  for (const FrameColumn& column : frame_columns) {
    text += fmt::format("  {:<19} {:<4} {}\n", column.name, texts[column.name][0].value_or(""),
                        texts[column.name][1].value_or(""));
  }
  return text;
}

StatisticsFile::StatisticsFile(const fs::path& file, const RunDescription& run, std::optional<int> last_kept)
    : path_(file), format_(statistics_format(file)) {
  if (last_kept) fs::resize_file(file, end_of_frame(file, format_, run, *last_kept));
  is_plain_ = !fs::exists(file) || fs::is_regular_file(file);
  file_.reset(std::fopen(file.c_str(), last_kept || !is_plain_ ? "ab" : "wb"));
  if (!file_) fail_to_write(path_, std::generic_category().message(errno));
  if (!last_kept) write(statistics_header(format_, run));
}

void StatisticsFile::write(const std::string& lines) {
  std::error_code ignored;
  const std::uintmax_t whole = is_plain_ ? fs::file_size(path_, ignored) : 0;
  if (std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size() && std::fflush(file_.get()) == 0) return;
  const int reason = errno;
  if (is_plain_ && whole > 0) {
    fs::resize_file(path_, whole, ignored);
  } else if (is_plain_) {
    fs::remove(path_, ignored);
  }
  fail_to_write(path_, std::generic_category().message(reason));
}

}  // namespace taut::app
