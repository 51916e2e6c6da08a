#include "app/viewer/state/viewer_state.hpp"

#include <algorithm>

namespace taut::app {
namespace {

// How long messages are shown. Errors stay longer.
constexpr double short_message_s = 4.0;
constexpr double error_message_s = 12.0;
// With more messages the oldest disappears.
constexpr std::size_t most_messages = 4;

}  // namespace

const char* name_of(ClipFormat format) {
  constexpr std::array names = {"PC2", "MDD", "glTF", "VTK", "OBJ"};
  return names[static_cast<std::size_t>(format)];
}

const Snapshot* compared(const ViewerState& state) {
  return state.newest->compared ? state.shown->compared.get() : nullptr;
}

const char* solver_of(const Snapshot& garment) {
  return sim::name_of(sim::kind_of(garment.settings.solver.method));
}

const char* slower_solver(const Snapshot& newest) {
  const bool is_second = newest.compared && newest.compared->record.sim_ms > newest.record.sim_ms;
  return solver_of(is_second ? *newest.compared : newest);
}

const Snapshot& pointed_at(const ViewerState& state) {
  const Snapshot* second = state.at_compared ? compared(state) : nullptr;
  return second != nullptr ? *second : *state.shown;
}

void tell(ViewerState& state, const std::string& text, bool is_error) {
  std::erase_if(state.messages, [&](const Message& old) { return old.text == text; });
  if (state.messages.size() >= most_messages) {
    state.messages.erase(state.messages.begin());
  }
  state.messages.push_back({text, is_error, is_error ? error_message_s : short_message_s});
}

}  // namespace taut::app
