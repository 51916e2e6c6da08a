#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "app/viewer/state/viewer_state.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// From the held vertex to the hand, in metres.
using HandThread = std::array<glm::vec3, 2>;

/// The thread between cloth and a hand that it cannot follow, because it is held elsewhere or would have to
/// cross something. Empty if nothing is held, or if the two are so near to each other that the cloth is in
/// the hand. `garment` is one of those that the hand holds.
std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment,
                                      const ViewArea& area);

/// Adds the thread to what is drawn: in front of everything, faint where surfaces hide it. `thread` must live
/// as long as `frame` is used.
void add_thread(const HandThread& thread, renderer::FrameView& frame);

}  // namespace taut::app
