#pragma once

#include <cstddef>
#include <filesystem>

#include "app/models/model_arrays.hpp"

namespace taut::app {

// GCC says it with a macro, Clang with a feature.
#if defined(__SANITIZE_ADDRESS__)
#define TAUT_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#define TAUT_ADDRESS_SANITIZER __has_feature(address_sanitizer)
#else
#define TAUT_ADDRESS_SANITIZER 0
#endif
/// AddressSanitizer reserves terabytes of address space: in its builds there is no limit on memory.
inline constexpr bool memory_is_limited = TAUT_ADDRESS_SANITIZER == 0;
#undef TAUT_ADDRESS_SANITIZER

/// What reading one model may cost.
struct ImportLimits {
  std::size_t memory_mib = 4096;  ///< of address space; a million triangles take about a quarter
  int seconds = 18;               ///< on the clock; with what comes before and after, a refusal within 20 s
};

/// Reads a model in a process of its own, which is ended where it takes too much: assimp crashes on some
/// damaged files, and an error handler does not help against that. The process is `taut import-model FILE`,
/// run from $TAUT_IMPORTER, this very program where it is taut, or the program of the build folder.
/// Throws InputError with the reason, which does not name the file; Interrupted.
ModelArrays read_model_in_process(const std::filesystem::path& path, const ImportLimits& limits);

/// The other process: keeps to the limits, reads the model and hands its arrays, or the reason why there are
/// none, to standard output. Returns the exit code.
int serve_import(const std::filesystem::path& path, const ImportLimits& limits);

}  // namespace taut::app
