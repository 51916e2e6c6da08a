#include "app/viewer/viewer_state.hpp"

#include <algorithm>

namespace taut::app {
namespace {

constexpr double short_message_s = 4.0;
constexpr double error_message_s = 12.0;
constexpr std::size_t most_messages = 4;

}  // namespace

std::optional<double> stretch_bound(const Scene& scene) {
  const sim::SolverSettings& solver = scene.simulation.solver;
  const bool keeps_bound = solver.kind != sim::SolverKind::ideal && solver.kind != sim::SolverKind::strong;
  return keeps_bound ? std::optional(solver.max_stretch) : std::nullopt;
}

void tell(ViewerState& state, const std::string& text, bool is_error) {
  std::erase_if(state.messages, [&](const Message& old) { return old.text == text; });
  if (state.messages.size() >= most_messages) {
    state.messages.erase(state.messages.begin());
  }
  state.messages.push_back({text, is_error, is_error ? error_message_s : short_message_s});
}

}  // namespace taut::app
