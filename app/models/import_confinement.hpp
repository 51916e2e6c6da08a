#pragma once

#include "app/models/import_process.hpp"

namespace taut::app {

/// Limit on the processor time of reading a model, in s: eight, more for large files, at most that of the limits.
int max_processor_s(const std::filesystem::path& model, const ImportLimits& limits);

/// Descriptor to which a confined importer writes its answer.
inline constexpr int import_output = 3;

/// Confines this process, for good, to reading one model, because a damaged or malicious file may have a reader do
/// anything. It keeps `output` as `import_output`, the limits, named_files() to read (Landlock), and the system calls
/// that reading needs: others fail with EPERM, and those of other architectures end the process (seccomp).
///
/// Returns false where the kernel has no Landlock (before Linux 5.13, and in some containers): the process can then
/// read every file of its user, and still write none. Throws InputError with the reason where the kernel refuses
/// seccomp.
bool confine_import(const std::filesystem::path& model, const ImportLimits& limits, int output);

/// Returns the model's file and the files of its folder that belong to it: those of the same stem, such as dress.bin of
/// dress.gltf, and those whose names are in the bytes of the model or of a material library that it names. Folders
/// below count where the bytes hold their names; links count where they lead to a file in the model's folder. Names in
/// compressed files are not found.
std::vector<std::filesystem::path> named_files(const std::filesystem::path& model);

}  // namespace taut::app
