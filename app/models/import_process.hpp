#pragma once

#include <filesystem>

#include "app/models/model_arrays.hpp"

namespace taut::app {

// GCC says it with a macro, Clang with a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#define TAUT_SHADOW_MEMORY (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define TAUT_SHADOW_MEMORY 0
#endif
/// False in builds with AddressSanitizer and ThreadSanitizer: they reserve terabytes of address space, so
/// memory cannot be limited.
inline constexpr bool memory_is_limited = TAUT_SHADOW_MEMORY == 0;
#undef TAUT_ADDRESS_SANITIZER

/// Limits on reading one model.
struct ImportLimits {
  std::size_t memory_mib = 4096;       ///< address space; a million triangles need about a quarter of it
  int seconds = 18;                    ///< Wall time. With the work before and after, a model is refused within 20 s.
  std::filesystem::path program = {};  ///< that reads it; empty: see read_model_in_process()
};

/// The message through the pipe: a byte that says which, eight with the length, and the arrays or the reason.
enum class ImportAnswer : char { arrays = 'A', reason = 'R' };

/// Reads a model in a child process, which is killed if it exceeds the limits. Some damaged files crash
/// assimp, and in the same process nothing could be done about it.
///
/// The child runs `PROGRAM import-model FILE`. Unless the limits name it, the program is $TAUT_IMPORTER if
/// that is set; else this program if it is taut; else libexec/taut/taut-import of the folders above this
/// code's file, such as libtaut. Throws InputError with the reason, without the name of the file;
/// Interrupted.
ModelArrays read_model_in_process(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts);

/// Reads an image in the same way. Throws InputError that names the file and the reason; Interrupted.
TextureImage read_image(const std::filesystem::path& path);

/// Runs in the child process. Confines itself (import_confinement.hpp), reads the model and writes its arrays to
/// standard output, or the reason for failure. Ends the process.
[[noreturn]] void serve_import(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts);

}  // namespace taut::app
