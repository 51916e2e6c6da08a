#include "app/viewer/session/input_queue.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace taut::app {
namespace {

using renderer::ButtonChanged;
using renderer::KeyChanged;
using renderer::PointerMoved;
using renderer::WindowEvent;

template <class Event>
const Event* as(const SessionEvent& event) {
  const auto* from_window = std::get_if<WindowEvent>(&event);
  return from_window != nullptr ? std::get_if<Event>(from_window) : nullptr;
}

bool moves_pointer(const SessionEvent& event) {
  return as<PointerMoved>(event) != nullptr || std::holds_alternative<PointAt>(event);
}

// Whether the events of a frame hide from it that `next` came after them. What is let go would never have
// seen the last place it was dragged to.
bool has_to_wait(const SessionEvent& next, const std::vector<SessionEvent>& taken) {
  return std::any_of(taken.begin(), taken.end(), [&](const SessionEvent& before) {
    const auto* button = as<ButtonChanged>(before);
    const auto* key = as<KeyChanged>(before);
    const auto* next_button = as<ButtonChanged>(next);
    const auto* next_key = as<KeyChanged>(next);
    // Files are loaded one after the other, and what is wrong with each is said.
    const bool drops_two =
        as<renderer::FileDropped>(before) != nullptr && as<renderer::FileDropped>(next) != nullptr;
    const bool lets_go = next_button != nullptr && !next_button->down;
    return drops_two || (lets_go && moves_pointer(before)) ||
           (button != nullptr && (moves_pointer(next) || next_button != nullptr)) ||
           (key != nullptr && next_key != nullptr && key->key == next_key->key &&
            key->down != next_key->down);
  });
}

}  // namespace

std::vector<SessionEvent> InputQueue::take_frame() {
  std::vector<SessionEvent> taken;
  while (!waiting_.empty() && !has_to_wait(waiting_.front(), taken)) {
    const bool replaces = !taken.empty() && moves_pointer(taken.back()) && moves_pointer(waiting_.front());
    if (replaces) {
      taken.pop_back();
    }
    taken.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return taken;
}

}  // namespace taut::app
