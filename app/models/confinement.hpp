#pragma once

#include <filesystem>
#include <span>

namespace taut::app {

/// Takes from this process, for good, what reading a model needs nothing of, as a damaged or malicious file
/// may have a reader do anything: to open files but to read those in `readable`, folders with all that is in
/// them and single files; to open sockets; to start programs; to gain privileges. Files that are open stay
/// so. Returns whether files are kept from it, which older kernels cannot do (Landlock, Linux 5.13).
bool confine_to(std::span<const std::filesystem::path> readable);

}  // namespace taut::app
