#include "app/models/reading/import_process.hpp"

// Reads a model in a process of its own for programs that use libtaut. Takes the arguments of `taut import-model`.
int main(int count, char** arguments) {
  taut::app::ImportLimits limits;
  int parts = 0;
  for (int k = 2; k + 2 < count; k += 2) {
    const std::string option = arguments[k];
    const int value = std::atoi(arguments[k + 1]);
    if (option == "--memory") {
      limits.memory_mib = static_cast<std::size_t>(value);
    } else if (option == "--seconds") {
      limits.seconds = value;
    } else if (option == "--parts") {
      parts = value;
    }
  }
  if (count != 9) {
    std::fputs("taut-import reads models for libtaut, which starts it by itself\n", stderr);
    return 2;
  }
  taut::app::serve_import(arguments[count - 1], limits, static_cast<taut::app::ReadParts>(parts));
}
