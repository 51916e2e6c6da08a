#include "app/sweeps/farm.hpp"

#include <unistd.h>

#include "app/base/child_process.hpp"
#include "app/base/errors.hpp"
#include "app/output/picture_record.hpp"
#include "app/sweeps/sweep_results.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string full(const fs::path& path) { return fs::absolute(path).lexically_normal().string(); }

/// This program and arguments as one line for Bash, with full paths.
std::string this_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {fs::read_symlink("/proc/self/exe").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return shell_line(command);
}

std::string task_command(const Sweep& sweep, const FarmSettings& settings) {
  return this_command({"sweep", "run", full(sweep.folder), "--chunk", std::to_string(settings.chunk)});
}

/// As sbatch reads it in a script: in quotes.
std::string sbatch_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) quoted.append(letter == '"' || letter == '\\' ? "\\" : "").append(1, letter);
  return quoted + '"';
}

/// A log beside the runs, whose name may have Slurm's symbols while its folder's has none.
std::string sbatch_log(const Sweep& sweep, const std::string& name) {
  std::string path;
  for (const char letter : full(sweep.folder / "slurm")) path.append(letter == '%' ? 2 : 1, letter);
  return sbatch_quoted(path + '/' + name);
}

}  // namespace

std::vector<ArrayJob> array_jobs(std::span<const std::size_t> missing, std::size_t chunk, std::size_t max_array_size) {
  std::vector<ArrayJob> jobs;
  std::vector<std::size_t> tasks;  // of the array at hand, from its offset
  std::size_t offset = 0;
  const auto finish = [&] {
    if (!tasks.empty()) {
      jobs.push_back({offset, ranges_text(tasks)});
      tasks.clear();
    }
  };
  for (const std::size_t run : missing) {
    const std::size_t task = run / chunk;
    if (task - offset >= max_array_size) {
      finish();
      offset = task - task % max_array_size;
    }
    if (tasks.empty() || tasks.back() != task - offset) tasks.push_back(task - offset);
  }
  finish();
  return jobs;
}

std::size_t usual_chunk(std::size_t runs) {
  constexpr std::size_t most_tasks = 10000;
  return std::max<std::size_t>(1, (runs + most_tasks - 1) / most_tasks);
}

std::string slurm_script(const Sweep& sweep, const FarmSettings& settings) {
  std::string text = fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --output={}\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --mem={}\n"
      "#SBATCH --cpus-per-task=1\n"
      "#SBATCH --requeue\n"
      "# Half a minute to save what was simulated, before time is up.\n"
      "#SBATCH --signal=B:TERM@30\n",
      sbatch_quoted("taut-" + sweep.scene_name), sbatch_log(sweep, "%A.log"), settings.memory);
  for (const std::string& option : settings.sbatch) text += "#SBATCH " + option + '\n';
  return text + "exec " + task_command(sweep, settings) + " --offset \"$1\"\n";
}

std::string merge_script(const Sweep& sweep) {
  return fmt::format("#!/bin/bash\n#SBATCH --job-name=taut-merge\n#SBATCH --output={}\nexec {}\n",
                     sbatch_log(sweep, "merge.log"), this_command({"sweep", "merge", full(sweep.folder)}));
}

std::string output_of(const std::vector<std::string>& command) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  const Descriptor read_end(ends[0]);
  std::optional<Descriptor> write_end(std::in_place, ends[1]);
  try {
    ChildProcess child({.arguments = command, .output = ends[1], .errors = STDERR_FILENO});
    write_end.reset();  // or the end of what it prints would never come
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    if (const int status = child.wait(); status != 0) {
      throw InputError("'" + shell_line(command) + "' ended with " + describe_end(status));
    }
    return text;
  } catch (const std::system_error& error) {
    throw InputError("cannot start '" + command.front() + "': " + error.code().message() +
                     "; expected the programs of Slurm on this machine");
  }
}

}  // namespace taut::app
