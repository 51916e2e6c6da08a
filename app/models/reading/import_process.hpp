#pragma once

#include <filesystem>

#include "app/models/reading/model_arrays.hpp"

namespace taut::app {

// GCC reports sanitizers with a macro, Clang with a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_SHADOW_MEMORY 1
#elif defined(__has_feature)
#define TAUT_SHADOW_MEMORY (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define TAUT_SHADOW_MEMORY 0
#endif
/// False in builds with AddressSanitizer or ThreadSanitizer, which reserve terabytes of address space, so that memory
/// cannot be limited.
inline constexpr bool memory_is_limited = TAUT_SHADOW_MEMORY == 0;
#undef TAUT_ADDRESS_SANITIZER

/// Limits on reading one model.
struct ImportLimits {
  std::size_t memory_mib = 4096;       ///< address space; a million triangles need about a quarter of it
  int seconds = 18;                    ///< processor time; a model is refused after six times as long in any case
  std::filesystem::path program = {};  ///< program that reads it; empty: see read_model_in_process()
};

/// Kind of the message through the pipe: a byte for the kind, eight for the length, then the arrays or the reason.
enum class ImportAnswer : char { arrays = 'A', reason = 'R' };

/// Reads a model in a child process, which is killed if it exceeds the limits. Some damaged files crash assimp, and the
/// same process would crash with it.
///
/// The child runs `PROGRAM import-model FILE`. The program is the first of these that exists: the program in the
/// limits; $TAUT_IMPORTER; this program if it is taut; libexec/taut/taut-import of the folders above this code's file,
/// such as libtaut. Throws InputError with the reason, without the name of the file; Interrupted.
ModelArrays read_model_in_process(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts);

/// Reads an image in the same way. Throws InputError that names the file and the reason; Interrupted.
TextureImage read_image(const std::filesystem::path& path);

/// Runs in the child process. Confines itself (import_confinement.hpp), reads the model and writes its arrays to
/// standard output, or the reason for failure. Ends the process.
[[noreturn]] void serve_import(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts);

}  // namespace taut::app
