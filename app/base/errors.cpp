
#include "app/base/errors.hpp"

#include <csignal>

namespace taut::app {
namespace {

// A signal handler can reach nothing but static storage.
volatile std::sig_atomic_t received_signal = 0;

void note_signal(int signal) { received_signal = signal; }

}  // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file at its size limit then fails to write with an error, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
}

void throw_if_interrupted() {
  if (received_signal != 0) throw Interrupted(received_signal);
}

void forget_interruption() { received_signal = 0; }

void end_by_signal(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::_Exit(128 + signal);
}

}  // namespace taut::app
