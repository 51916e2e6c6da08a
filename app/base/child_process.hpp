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

/// How a program is started.
struct ChildCommand {
  std::vector<std::string> arguments;  ///< the program first, looked for in $PATH where its name has no slash
  std::string variable = {};           ///< "NAME=VALUE" beside this program's environment; empty: none
  int input = -1;                      ///< descriptors for its standard streams; -1: nothing is there
  int output = -1;
  int errors = -1;
  /// A Ctrl-C at the terminal reaches this program alone, which then decides what becomes of the child.
  bool own_group = false;
};

/// A running program; killed with this object.
class ChildProcess {
 public:
  /// Starts the program. Throws std::system_error if that fails.
  explicit ChildProcess(ChildCommand command);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the end and returns the status of waitpid. Must be called only once.
  int wait();
  /// Whether `wait` would return at once.
  bool has_ended() const;

 private:
  pid_t process_ = -1;  ///< -1: ended
};

/// A status of waitpid in words: "exit code 1" or "signal 9".
std::string describe_end(int status);

}  // namespace taut::app
