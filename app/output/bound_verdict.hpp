#pragma once

#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Says on standard error where a run was not what the scene asks for: where frames exceed the bound that the
/// solver promised, and where its time steps were too long for the fabric's stiffness against compression.
/// The exit code of the command: exit_promise_broken where a bound was exceeded, unless the scene allows it.
int judge_bound(const Scene& scene, const RunSummary& summary);

}  // namespace taut::app
