#pragma once

#include <string>
#include <vector>

#include "app/garment/inspection.hpp"
#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// What --stats writes: one JSON object. `gl_renderer` is empty where nothing was drawn.
std::string statistics_json(const Scene& scene, const sim::Garment& garment, const std::string& gl_renderer,
                            const std::vector<FrameRecord>& records);

/// The same as `describe` (inspection.hpp), for programs.
std::string inspection_json(const Inspection& inspection);

}  // namespace taut::app
