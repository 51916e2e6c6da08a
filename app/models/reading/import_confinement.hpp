#pragma once

#include "app/models/reading/import_process.hpp"

namespace taut::app {

/// Returns the limit on the processor time of reading a model, in s: eight, more for large files, at most the limits'
/// seconds.
int max_processor_s(const std::filesystem::path& model, const ImportLimits& limits);

/// Descriptor to which a confined importer writes its answer.
inline constexpr int import_output = 3;

/// Confines this process, for good, to reading one model, because a damaged or malicious file may make a reader do
/// anything. It keeps `output` as `import_output`, the limits, read access to named_files() (Landlock), and the system
/// calls that reading needs. Other calls fail with EPERM, and calls of other architectures end the process (seccomp).
///
/// Returns false if the kernel has no Landlock (before Linux 5.13, and in some containers). The process can then read
/// every file of its user, and still write none. Throws InputError with the reason if the kernel refuses seccomp.
bool confine_import(const std::filesystem::path& model, const ImportLimits& limits, int output);

/// Returns the model's file and the files of its folder that belong to it: files of the same stem, such as dress.bin of
/// dress.gltf, and files whose names are in the bytes of the model or of a material library that it names. Folders
/// below count if the bytes contain their names, links if they lead to a file in the model's folder. Names in
/// compressed files are not found.
std::vector<std::filesystem::path> named_files(const std::filesystem::path& model);

}  // namespace taut::app
