#pragma once

#include <string>

namespace taut::app {

/// One line on the terminal that says how far a run is; nothing where standard error is no terminal.
class Progress {
 public:
  Progress(std::string what, int last);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(int done, double max_stretch);

 private:
  std::string what_;
  int last_;
  bool on_terminal_;
  bool shown_ = false;
};

}  // namespace taut::app
