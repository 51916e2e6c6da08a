#pragma once

#include <string>

#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Says in how many frames the solver's bound was exceeded, in which first and by how much. Empty: in none.
std::string describe_excess(const Scene& scene, const RunSummary& summary);

/// Says how many pairs of triangles crossed at the start and cross at the end, and which part of the cloth contact leaves
/// out around them. Empty: nothing crossed.
std::string describe_crossings(const RunSummary& summary);

/// Prints to standard error how a run differs from what the scene asks for. That is: frames exceeded the
/// solver's bound, something may have crossed where the scene accepts that, or time steps were too long for
/// the fabric's stiffness against compression. Returns the exit code of the command: exit_promise_broken if
/// the bound was exceeded and the scene does not allow it, else 0.
int judge_bound(const Scene& scene, const RunSummary& summary);

}  // namespace taut::app
