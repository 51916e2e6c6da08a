#include "app/sweeps/sweep_run.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "app/base/files.hpp"
#include "app/base/stopwatch.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/frame_loop.hpp"
#include "app/output/picture_record.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/output/run_report.hpp"
#include "app/sewing/sewn_scene.hpp"
#include "app/sweeps/sweep_results.hpp"

namespace taut::app {
namespace {

constexpr int checkpoint_every = 60;

AttemptEnd end_named(const std::string& name) {
  return name == "done" ? AttemptEnd::done : name == "broken" ? AttemptEnd::broken : AttemptEnd::failed;
}

const char* name_of(AttemptEnd end) {
  return end == AttemptEnd::done ? "done" : end == AttemptEnd::broken ? "broken" : "failed";
}

/// The simulation of a run, at its start.
struct Loaded {
  DrawnScene scene;
  LoadedGarment garment;
  sim::Simulation simulation;

  static Loaded of(DrawnScene scene) {
    sew_and_load_bodies(scene);
    LoadedGarment garment = load_garment(scene);
    put_where_it_begins(garment, scene);
    sim::Simulation simulation = make_simulation(scene, garment);
    return {std::move(scene), std::move(garment), std::move(simulation)};
  }
};

// As `taut render` draws its last frame.
renderer::Image draw(Loaded& run) {
  const std::vector<sim::Vec3>& positions = run.simulation.state().current;
  const double time_s = run.simulation.state().time_s;
  if (is_fitted(run.scene)) {
    FittedView fitted(run.scene, run.simulation.garment());
    fitted.add(positions, run.garment.shown_m(positions), time_s);
    fitted.place_camera(run.scene);
  }
  OffscreenRenderer offscreen("auto");
  GarmentPainter painter(offscreen.renderer(), run.scene, run.simulation.garment(), run.simulation.pins().vertices,
                         drawn_colours(run.scene, run.garment));
  return painter.draw(positions, time_s);
}

class SweepRun {
 public:
  SweepRun(const Sweep& sweep, std::size_t run, RunLock& lock)
      : sweep_(sweep), run_(run), lock_(lock), checkpoint_(sweep.file(run, ".checkpoint")) {
    saved_.scene_name = sweep.scene_hash(run) + ' ' + sweep.program;
  }

  Attempt go(const ProgressCallback& report) {
    Attempt attempt;
    try {
      attempt = simulate(report);
    } catch (const Interrupted&) {
      save();
      return {AttemptEnd::stopped, fmt::format("stopped after frame {}", saved_.frame)};
    } catch (const PromiseBroken& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const sim::Diverged& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const sim::ContactBlocked& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const std::runtime_error& error) {
      attempt = {AttemptEnd::failed, error.what()};
    } catch (const std::bad_alloc&) {
      attempt = {AttemptEnd::failed, "not enough memory"};
    } catch (...) {
      save();  // another job has ended this one
      throw;
    }
    write(attempt);
    return attempt;
  }

 private:
  Attempt simulate(const ProgressCallback& report) {
    loaded_.emplace(Loaded::of(sweep_.scene(run_)));
    sim::Simulation& simulation = loaded_->simulation;
    const int frames = loaded_->scene.frames;
    if (!resume()) saved_.frame = go_to_start(loaded_->scene, simulation);
    FrameOutputs outputs;
    outputs.start_frame = saved_.frame;
    outputs.overlap = false;
    outputs.report = [&](const FrameRecord& record) {
      saved_.frame = record.frame;
      saved_.summary.add(record);
      lock_.beat();
      if (record.frame % checkpoint_every == 0 && record.frame < frames) save();
      if (report) report(static_cast<double>(record.frame) / frames);
    };
    run_frames(simulation, frames, outputs);
    if (sweep_.pictures) {
      const std::vector<renderer::PngText> texts = {{"taut-sweep", sweep_.describe(run_)}};
      write_file(sweep_.file(run_, ".png"), renderer::encode_png(draw(*loaded_), texts));
    }
    const std::string excess = describe_excess(loaded_->scene, saved_.summary);
    const bool is_broken = !excess.empty() && !loaded_->scene.simulation.solver.bounded.allow_exceeding;
    return {is_broken ? AttemptEnd::broken : AttemptEnd::done, is_broken ? excess : ""};
  }

  /// Whether it goes on from where an earlier attempt at this very run stopped.
  bool resume() {
    if (std::error_code error; !std::filesystem::exists(checkpoint_, error)) return false;
    try {
      RunCheckpoint saved = read_run_checkpoint(checkpoint_);
      if (saved.scene_name != saved_.scene_name) return false;
      restore(checkpoint_, saved, loaded_->simulation);
      saved_ = std::move(saved);
      return true;
    } catch (const InputError&) {
      return false;  // damaged: the run begins anew
    }
  }

  void save() {
    if (loaded_ && saved_.summary.frames > 0) {
      saved_.simulation = sim::encode(loaded_->simulation.save(), loaded_->simulation.garment());
      write_run_checkpoint(checkpoint_, saved_);
    }
  }

  void write(const Attempt& attempt) {
    Json result = {{"index", run_},
                   {"values", sweep_.values(run_)},
                   {"scene", sweep_.scene_hash(run_)},
                   {"program", sweep_.program},
                   {"end", name_of(attempt.end)}};
    if (!attempt.what.empty()) result["where"] = attempt.what;
    if (loaded_ && saved_.summary.frames > 0) {
      result["vertices"] = loaded_->simulation.garment().mesh.positions.size();
      result["triangles"] = loaded_->simulation.garment().mesh.triangles.size();
      result["state_hash"] = hash_text(sim::hash(loaded_->simulation.state()));
      result.update(Json::parse(statistics_end(StatisticsFormat::json_lines, saved_.summary))["summary"]);
    }
    result["host"] = host_name();
    write_text_file(sweep_.file(run_, ".json"), result.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
  }

  const Sweep& sweep_;
  std::size_t run_;
  RunLock& lock_;
  std::filesystem::path checkpoint_;
  RunCheckpoint saved_;
  std::optional<Loaded> loaded_;
};

/// The result of an earlier attempt that need not be tried again.
std::optional<Attempt> earlier(const Sweep& sweep, std::size_t run) {
  const std::optional<Json> result = result_of(sweep, run);
  return result && is_final(*result)
             ? std::optional(Attempt{end_named(result->value("end", "")), result->value("where", ""), false})
             : std::nullopt;
}

/// Removes what a process left half written that was killed at the run. Requires the run's lock; others may
/// be trying to take that.
void remove_unfinished(const Sweep& sweep, std::size_t run) {
  namespace fs = std::filesystem;
  const fs::path any = sweep.file(run, ".");
  std::vector<fs::path> unfinished;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(any.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    const bool is_of_run = name.starts_with(any.filename().string()) && name.find(".lock") == std::string::npos;
    if (is_of_run && name.find(".part-") != std::string::npos) unfinished.push_back(entry.path());
  }
  for (const fs::path& file : unfinished) fs::remove(file, ignored);
}

namespace fs = std::filesystem;

std::string this_job() {
  const char* job = std::getenv("SLURM_JOB_ID");
  return job != nullptr && *job != '\0' ? job : "-";
}

std::string owner_in(const fs::path& file) {
  std::ifstream in(file);
  std::string owner;
  std::getline(in, owner);
  return owner;
}

/// Whether a process of this machine is gone, or has ended and was not waited for.
bool is_over(pid_t process) {
  if (::kill(process, 0) != 0) return errno == ESRCH;
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(in, line);
  const std::size_t name_end = line.rfind(") ");  // the name may have anything in it
  return name_end != std::string::npos && line.find_first_of("ZX", name_end + 2) == name_end + 2;
}

bool has_ended(const std::string& owner) {
  std::istringstream in(owner);
  std::string host, job;
  pid_t process = 0;
  in >> host >> process >> job;
  // A job that was put back in the queue has the same number, in another process.
  const bool is_this_job = job != "-" && job == this_job() && process != ::getpid();
  return is_this_job || (host == host_name() && process > 0 && is_over(process));
}

/// Both times are of the file's machine: clocks may differ.
bool is_stale(const fs::path& lock, const fs::path& just_written) {
  std::error_code error;
  const auto touched = fs::last_write_time(lock, error);
  return !error && fs::last_write_time(just_written, error) - touched > RunLock::stale_after;
}

/// Puts `own` in the place of a lock that was left behind. Of several that try only one does: they queue at
/// what was left, and who comes later finds that another lock is there. Where files cannot be locked nobody
/// queues, and the last one has it.
bool take_over(const fs::path& own, const fs::path& lock) {
  const Descriptor left(::open(lock.c_str(), O_RDWR | O_CLOEXEC));
  if (::flock(left.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat opened {
  }, named{};
  if (::fstat(left.number(), &opened) != 0 || ::stat(lock.c_str(), &named) != 0 || opened.st_ino != named.st_ino ||
      !(has_ended(owner_in(lock)) || is_stale(lock, own))) {
    return false;
  }
  return ::rename(own.c_str(), lock.c_str()) == 0;
}

/// Where there are no hard links.
bool take_without_link(const fs::path& own, const fs::path& lock) {
  return ::renameat2(AT_FDCWD, own.c_str(), AT_FDCWD, lock.c_str(), RENAME_NOREPLACE) == 0 ||
         (errno == EINVAL && ::rename(own.c_str(), lock.c_str()) == 0);
}

}  // namespace

Attempt attempt_run(const Sweep& sweep, std::size_t run, const ProgressCallback& report) {
  if (const auto there = earlier(sweep, run)) return *there;
  prepare_folder_of(sweep.file(run, ".json"));
  RunLock lock(sweep.file(run, ".lock"));
  if (!lock.is_held()) return {AttemptEnd::busy, lock.owner() + " works on it"};
  remove_unfinished(sweep, run);
  // It may have come while this process waited for nothing but a file system.
  const auto there = earlier(sweep, run);
  return there ? *there : SweepRun(sweep, run, lock).go(report);
}

std::string hash_of_run(const Sweep& sweep, std::size_t run) {
  Loaded loaded = Loaded::of(sweep.scene(run));
  FrameOutputs outputs;
  try {
    outputs.start_frame = go_to_start(loaded.scene, loaded.simulation);
    run_frames(loaded.simulation, loaded.scene.frames, outputs);
  } catch (const PromiseBroken&) {
    // It ends there on every machine.
  } catch (const sim::Diverged&) {
    // As well.
  }
  return hash_text(sim::hash(loaded.simulation.state()));
}

void WorstEnd::add(AttemptEnd end) {
  const bool has_to_be_tried_again = end == AttemptEnd::stopped || end == AttemptEnd::busy;
  if (has_to_be_tried_again || code_ == exit_can_be_resumed) {
    code_ = exit_can_be_resumed;
  } else if (end == AttemptEnd::failed || code_ == exit_bad_input) {
    code_ = exit_bad_input;
  } else if (end == AttemptEnd::broken) {
    code_ = exit_promise_broken;
  }
}

void require_planned_program(const Sweep& sweep) {
  const std::string program = program_hash();
  if (program != sweep.program) {
    throw InputError(
        "'{}' was planned for the program {}, found {}; taut sweep plan again makes all runs anew with this "
        "one",
        sweep.folder.string(), sweep.program, program);
  }
}

RunLock::RunLock(fs::path file)
    : file_(std::move(file)), owner_(host_name() + ' ' + std::to_string(::getpid()) + ' ' + this_job()) {
  const fs::path own = file_.string() + '-' + host_name() + '-' + std::to_string(::getpid());
  write_text_file(own, owner_ + '\n');
  std::error_code error;
  // The answer of a network file system may be lost, and it says to the second try that the name is taken.
  bool is_taken = ::link(own.c_str(), file_.c_str()) == 0 || fs::hard_link_count(own, error) == 2;
  const std::string other = owner_in(file_);
  if (!is_taken) is_taken = fs::exists(file_, error) ? take_over(own, file_) : take_without_link(own, file_);
  is_held_ = is_taken && owner_in(file_) == owner_;
  owner_ = is_held_ ? owner_ : other;
  fs::remove(own, error);
  touched_ = std::chrono::steady_clock::now();
}

RunLock::~RunLock() {
  if (is_held_ && owner_in(file_) == owner_) {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
}

void RunLock::beat() {
  constexpr std::chrono::seconds often_enough{20};
  if (const auto now = std::chrono::steady_clock::now(); now - touched_ > often_enough) {
    ::utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);  // now, by the clock of the file's machine
    touched_ = now;
  }
}

}  // namespace taut::app
