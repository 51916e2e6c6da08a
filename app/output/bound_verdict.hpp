#pragma once

#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Where the solver promised a bound on stretch and a frame exceeds it, says so on standard error. The exit
/// code of the command: 1 then, unless the scene allows it.
int judge_bound(const Scene& scene, const RunSummary& summary);

}  // namespace taut::app
