#pragma once

#include <sys/types.h>

#include "prelude.hpp"

namespace taut::app {

/// A file descriptor, closed with this object; -1: none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }

 private:
  int number_;
};

/// Command line, environment and standard streams of a program to start.
struct ChildCommand {
  std::vector<std::string> arguments;  ///< program first; searched in $PATH if its name has no slash
  std::string variable = {};           ///< "NAME=VALUE", added to this program's environment; empty: none
  int input = -1;                      ///< descriptors of the standard streams; -1: /dev/null
  int output = -1;
  int errors = -1;
  /// Puts the child in a process group of its own. Ctrl-C then interrupts this program alone, which decides about the
  /// child.
  bool own_group = false;
};

/// A running program. The destructor kills it.
class ChildProcess {
 public:
  /// Starts the program. Throws std::system_error if that fails.
  explicit ChildProcess(ChildCommand command);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the end and returns the status of waitpid. Call it only once.
  int wait();
  /// Returns true if `wait` would return at once.
  bool has_ended() const;

 private:
  pid_t process_ = -1;  ///< -1: ended
};

/// Describes a status of waitpid: "exit code 1" or "signal 9".
std::string describe_end(int status);

}  // namespace taut::app
