#include <CLI/CLI.hpp>
#include <memory>

#include "app/base/suggest.hpp"
#include "app/bench/cases.hpp"
#include "app/bench/entrants.hpp"
#include "app/command_line_parts.hpp"

namespace taut::app {
namespace {

std::vector<int> bench_triangles() {
  std::vector<int> triangles;
  for (const BenchSize& size : bench_sizes()) {
    triangles.push_back(size.triangles);
  }
  return triangles;
}

void add_bench_extent(CLI::App& command, BenchOptions& options) {
  command.add_option("--sizes", options.sizes, "triangles of the shirt, some of 1028,5280,10600,42400,84480")
      ->delimiter(',')
      ->check(CLI::IsMember(bench_triangles()));
  command
      .add_option("--scenes", options.scenes,
                  "some of " + joined(bench_scene_names(), ",") + "; with --contact some of its rows")
      ->delimiter(',');
  command.add_option("--bounds", options.bounds, "largest stretches to be kept (default 0.05,0.01,0.001)")
      ->delimiter(',')
      ->check(CLI::Range(1e-5, 1.0));
  command.add_option("--engines", options.engines, "some of " + joined(engine_names(), ","))
      ->delimiter(',')
      ->check(CLI::IsMember(engine_names()));
  command.add_option("--seconds", options.seconds, "simulated time (default 2, with --full 10)")
      ->check(CLI::Range(0.01, 3600.0));
  command
      .add_option("--limit", options.slowest_frame_ms,
                  "ms per frame above which a setting is given up (default 250, with --full 500)")
      ->check(CLI::PositiveNumber);
}

void add_contact(CLI::App& command, BenchOptions& options) {
  CLI::Option* contact = command.add_flag("--contact", options.contact,
                                          "instead of all that, the scenes about contact: what they cost, "
                                          "and whether any frame breaks a promise; "
                                          "ends with exit code 3 if one does");
  for (const char* other : {"--sizes", "--bounds", "--engines", "--seconds", "--limit", "--full",
                            "--ablation", "--output", "--shapes"}) {
    contact->excludes(other);
  }
  CLI::Option* quick = command.add_flag("--quick", options.quick,
                                        "with --contact: a shirt that hangs, in winds, and on someone who "
                                        "walks, 60 frames of each, on one thread: "
                                        "three minutes at most");
  quick->needs(contact);
  command
      .add_option("--runs", options.runs,
                  "with --contact: so many runs of each scene, each with its start moved at random by a "
                  "twentieth of the cloth's thickness (default: one run of the scene as it is)")
      ->check(CLI::Range(1, 1000))
      ->needs(contact)
      ->excludes(quick);
  command
      .add_option("--frames", options.frames,
                  "with --contact: frames of each run (default: as the scene has it)")
      ->check(CLI::Range(1, 1000000))
      ->needs(contact);
}

}  // namespace

std::function<int()> add_bench(CLI::App& app) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command =
      app.add_subcommand("bench", "Measure time per frame against stretch, side by side with other engines");
  add_bench_extent(*command, *options);
  command->add_flag("--full", options->full, "every scene, every size and more settings: takes hours");
  command
      ->add_flag("--ablation", options->ablation,
                 "the bounded solver holding springs and surface, and without one of its parts at a time")
      ->excludes("--engines");
  command->add_option("--output", options->output, "folder for bench.json, bench.png and bench.pdf");
  command->add_option("--shapes", options->shapes,
                      "folder for the most stretched shape of every run, SCENE_TRIANGLES_RUN.obj");
  add_contact(*command, *options);
  command->add_flag("--json", options->json, "print JSON instead of the table");
  command->add_flag("--quiet", options->quiet, "print neither progress nor the table");
  command->footer(
      "Examples:\n  taut bench                                   about a minute\n"
      "  taut bench --scenes wind --sizes 10600 --bounds 0.01 --seconds 5\n"
      "  taut bench --ablation --bounds 0.01          what each part of the solver is good for\n"
      "  taut bench --full --output bench             every cell, 10 simulated seconds each\n"
      "  taut bench --contact --quick                 whether a shirt keeps up with the clock\n"
      "  taut bench --contact --runs 10               whether cloth crosses, stretches or does neither\n");
  return [options] { return run(*options); };
}

}  // namespace taut::app
