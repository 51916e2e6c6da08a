#include "app/viewer/picture/hand_thread.hpp"

#include <glm/geometric.hpp>

#include "app/drawing/framing.hpp"

namespace taut::app {
namespace {

// Cloth hangs from the hand by a spring, and follows it late: less than this apart it is in the hand. Smaller
// shows threads of millimetres whenever the hand moves.
constexpr float least_m = 0.005F;
// The same in the picture. Smaller shows a dot on cloth that is far away.
constexpr float least_px = 4.0F;

// Dark with a light rim shows on cloth and ground of any colour.
constexpr renderer::Colour rim_colour = renderer::rgb(0xFFFFFF);
constexpr renderer::Colour core_colour = renderer::rgb(0x1C1C1C);
constexpr float rim_width_px = 4.5F;
constexpr float core_width_px = 2.0F;
constexpr float rim_diameter_px = 11.0F;
constexpr float core_diameter_px = 7.5F;
constexpr float opacity_behind_surfaces = 0.35F;

}  // namespace

std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment,
                                      const ViewArea& area) {
  if (!state.held) {
    return std::nullopt;
  }
  const std::vector<glm::vec3> ends = to_float({garment.positions()[state.held->vertex], state.held->hand_m});
  const auto from_px = state.camera.pixel_of(ends[0], area);
  const auto to_px = state.camera.pixel_of(ends[1], area);
  const bool is_apart = glm::distance(ends[0], ends[1]) > least_m &&
                        (!from_px || !to_px || glm::distance(*from_px, *to_px) > least_px);
  return is_apart ? std::optional(HandThread{ends[0], ends[1]}) : std::nullopt;
}

void add_thread(const HandThread& thread, renderer::FrameView& frame) {
  for (const bool hidden : {false, true}) {
    renderer::LineView line{.points = thread,
                            .colours = std::span(&rim_colour, 1),
                            .width_px = rim_width_px,
                            .opacity = hidden ? 1.0F : opacity_behind_surfaces,
                            .hidden_by_surfaces = hidden};
    frame.lines.push_back(line);
    line.colours = std::span(&core_colour, 1);
    line.width_px = core_width_px;
    frame.lines.push_back(line);
  }
  renderer::PointView ends{.centres = thread,
                           .colours = std::span(&rim_colour, 1),
                           .diameter_px = rim_diameter_px,
                           .hidden_by_surfaces = false};
  frame.points.push_back(ends);
  ends.colours = std::span(&core_colour, 1);
  ends.diameter_px = core_diameter_px;
  frame.points.push_back(ends);
}

}  // namespace taut::app
