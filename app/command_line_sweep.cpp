#include <CLI/CLI.hpp>

#include "app/command_line_parts.hpp"
namespace taut::app {
namespace {

using Options = std::shared_ptr<SweepOptions>;

CLI::App* add(CLI::App& sweep, const Options& options, SweepAction action, const std::string& name,
              const std::string& meaning) {
  CLI::App* command = sweep.add_subcommand(name, meaning);
  command->callback([options, action] { options->action = action; });
  if (action != SweepAction::plan) {
    command->add_option("DIR", options->folder, "folder that taut sweep plan made")->required();
  }
  return command;
}

void add_index(CLI::App& command, const Options& options, const std::string& meaning) {
  command.add_option("--index", options->index, meaning)->check(CLI::NonNegativeNumber);
}

void add_chunk(CLI::App& command, const Options& options, const std::string& meaning) {
  command.add_option("--chunk", options->chunk, meaning)->check(CLI::Range(1, 1000000));
}

void add_plan(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::plan, "plan",
                          "Check a study and make the folder in which its runs are made");
  command->add_option("STUDY", options->study, "a TOML file: scene, frames, pictures, and [axes]")
      ->required();
  command->add_option("--output,-o", options->folder, "folder of the sweep")->required();
  command->footer(
      "A study:\n\n  scene = \"tshirt\"            as the argument SCENE of taut simulate, or relative to "
      "the study\n"
      "  frames = 120                optional\n  pictures = true             optional: of the last frames\n"
      "  [axes]                      any keys of scenes (taut help scene), each with a list of values\n"
      "  \"wind.speed\" = [0, 1, 10]\n  \"garment.file\" = [\"tshirt_1028\", \"my-dress.obj\"]\n\n"
      "Every combination is a run. Files are copied into the folder, which can be moved. Planned again, the "
      "same\nstudy changes nothing, but for another version of the program, which makes all runs anew.\n\n"
      "Examples:\n  taut sweep plan study.toml -o sweep\n");
}

void add_run(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::run, "run", "Make runs that are not done yet");
  add_index(*command, options, "one run, from 0");
  command->add_option("--task", options->task, "the runs of one task (default: $SLURM_ARRAY_TASK_ID)");
  add_chunk(*command, options, "runs of a task (default 1)");
  command->add_option("--offset", options->offset, "added to the number of the task")->capture_default_str();
  CLI::Option* all = command->add_flag("--all", options->all, "all runs");
  command->add_option("--jobs", options->jobs, "with --all: so many at a time (default: the processors)")
      ->needs(all)
      ->check(CLI::Range(1, 1024));
  command->footer(
      "A run that ended is left alone, one that was stopped (SIGTERM, SIGINT) goes on from its checkpoint, "
      "and "
      "two\nprocesses never spoil each other's work. Exit codes: 0 done, 3 a promise is broken, which is a "
      "result as\nwell, 1 a run failed, 75 stopped, or another process works on it: try again.\n\n"
      "Examples:\n  taut sweep run sweep --index 12\n  taut sweep run sweep --all --jobs 4\n");
}

void add_merge(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::merge, "merge",
                          "Write the table of all results and the sheet of their pictures");
  command->footer("Examples:\n  taut sweep merge sweep\n");
}

void add_submit(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::submit, "submit", "Hand the runs over to Slurm");
  command->add_flag("--slurm", options->slurm, "the one farm it knows")->required();
  command->add_flag("--missing", options->missing, "only what is missing");
  command->add_flag("--dry-run", options->dry_run, "print what would be handed over");
  add_chunk(*command, options, "runs of a task (default: as few as make 10000 tasks)");
  command->add_option("--mem", options->memory, "memory of a task of Slurm")->capture_default_str();
  command->add_option("--sbatch", options->sbatch, "one more option of sbatch; can be repeated")
      ->allow_extra_args(false);
  command->footer(
      "An array of tasks, several where it would be too long for this Slurm, and a job after them that makes "
      "the\ntable. What was stopped, killed or lost is handed over again with --missing.\n\n"
      "Examples:\n  taut sweep submit sweep --slurm --sbatch=--time=60 --sbatch=--partition=day\n"
      "  taut sweep submit sweep --slurm --missing\n  taut sweep submit sweep --slurm --dry-run\n");
}

void add_rest(CLI::App& sweep, const Options& options) {
  CLI::App* status = add(sweep, options, SweepAction::status, "status", "Say how many runs are done");
  status->add_flag("--missing", options->missing, "print which are not, as ranges for sbatch --array");
  status->footer("Examples:\n  taut sweep status sweep\n  taut sweep status sweep --missing\n");

  CLI::App* show = add(sweep, options, SweepAction::show, "show", "Print the scene of a run");
  add_index(*show, options, "the run, from 0");
  show->get_option("--index")->required();
  show->footer("Examples:\n  taut sweep show sweep --index 12 > run.toml && taut render run.toml\n");

  CLI::App* check =
      add(sweep, options, SweepAction::check, "check",
          "Make one run, write nothing, and print host, program and last state, to compare machines");
  add_index(*check, options, "the run (default 0)");
  check->footer(
      "Examples:\n  taut sweep check sweep\n"
      "  srun --nodes=4 --ntasks-per-node=1 taut sweep check sweep   the last two words of all lines are the "
      "same\n");
}

}  // namespace

std::function<int()> add_sweep(CLI::App& app) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* sweep = app.add_subcommand("sweep", "Simulate a scene with every combination of some values");
  sweep->require_subcommand(1);
  add_plan(*sweep, options);
  add_run(*sweep, options);
  add_rest(*sweep, options);
  add_merge(*sweep, options);
  add_submit(*sweep, options);
  sweep->footer(
      "taut sweep COMMAND --help says more.\n\nExamples:\n  taut sweep plan study.toml -o sweep\n"
      "  taut sweep run sweep --all\n  taut sweep merge sweep\n");
  return [options] { return run(*options); };
}

}  // namespace taut::app
