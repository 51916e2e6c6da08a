#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/command_line.hpp"
#include "sim/simulation.hpp"

// A command reads a scene (scene_file), loads its garment (garment_loading), and passes a simulation to run_frames
// (frame_loop), which calls the outputs that the command chose.

namespace {

int report(const std::exception& error, int exit_code) {
  std::fflush(stdout);
  std::fprintf(stderr, "taut: error: %s\n", taut::app::printable(error.what()).c_str());
  return exit_code;
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace taut::app;
  try {
    watch_for_interruption();
    const int exit_code = run_command_line({arguments, static_cast<std::size_t>(argument_count)});
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw std::system_error(errno, std::generic_category(), "cannot write to the standard output");
    }
    return exit_code;
  } catch (const Interrupted& interrupted) {
    report(interrupted, exit_bad_input);
    end_by_signal(interrupted.signal);
  } catch (const std::exception& error) {
    const bool is_broken = is_any<PromiseBroken, taut::sim::Diverged, taut::sim::ContactBlocked>(error);
    const int other = is_any<UsageError>(error) ? exit_wrong_usage : exit_bad_input;
    return report(error, is_broken ? exit_promise_broken : other);
  }
}
