#include <CLI/CLI.hpp>

#include "app/base/suggest.hpp"
#include "app/command_line_parts.hpp"
namespace taut::app {

std::function<int()> add_bench(CLI::App& app) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand(
      "bench", "Measure the time of a frame, its stretch, and whether any frame breaks a promise");
  command->add_flag("--contact", options->contact, "all scenes about contact and being worn: takes an hour");
  command->add_flag(
      "--quick", options->quick,
      "a shirt that hangs, in winds, and on someone who walks, 60 frames of each, on one thread: "
      "three minutes at most (default)");
  command->add_option("--scenes", options->scenes, "some of the rows alone")->delimiter(',');
  command
      ->add_option(
          "--bounds", options->bounds,
          "largest stretches to be kept, such as 0.05,0.01: a row for each (default: as the scene has it)")
      ->delimiter(',')
      ->check(CLI::Range(1e-5, 1.0));
  command
      ->add_option("--runs", options->runs,
                   "so many runs of each scene, each with its start moved at random by a "
                   "twentieth of the cloth's thickness (default: one run of the scene as it is)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--frames", options->frames, "frames of each run (default: as the scene has it)")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--csv", options->csv, "print a table (CSV) of all runs instead");
  command->add_flag("--quiet", options->quiet, "print neither progress nor the table");
  command->footer(
      "Ends with exit code 3 if a frame breaks a promise.\n\nExamples:\n"
      "  taut bench                                   whether a shirt keeps up with the clock\n"
      "  taut bench --bounds 0.05,0.01,0.001 --scenes wind-10   time against stretch\n"
      "  taut bench --contact --runs 10               whether cloth crosses, stretches or does neither\n");
  return [options] { return run(*options); };
}

}  // namespace taut::app
