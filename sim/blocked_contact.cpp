#include "sim/blocked_contact.hpp"

namespace taut::sim {
namespace {

bool is_pinned(Index vertex, const Pins& pins) {
  return std::binary_search(pins.vertices.begin(), pins.vertices.end(), vertex);
}

std::string listed(const std::vector<Index>& vertices) {
  std::string text;
  for (const Index vertex : vertices) text += (text.empty() ? "" : ", ") + std::to_string(vertex);
  return text;
}

std::string name_of(const ContactSide& side, const Pins& pins, std::span<const Body> bodies) {
  if (side.body) {
    const std::string& name = bodies[*side.body].name;
    return name.empty() ? "body " + std::to_string(*side.body) : "the body '" + name + '\'';
  }
  std::vector<Index> pinned;
  std::copy_if(side.vertices.begin(), side.vertices.end(), std::back_inserter(pinned),
               [&](Index vertex) { return is_pinned(vertex, pins); });
  if (side.vertices.size() == 1) {
    return (pinned.empty() ? "vertex " : "the pinned vertex ") + listed(side.vertices);
  }
  const std::string kind = side.vertices.size() == 2 ? "the edge" : "the triangle";
  return kind + " of the vertices " + listed(side.vertices) +
         (pinned.empty() ? "" : ", of which " + listed(pinned) + (pinned.size() == 1 ? " is" : " are") + " pinned");
}

/// Whether nothing of it can give way.
bool is_led(const ContactSide& side, const Pins& pins) {
  return side.body ||
         std::all_of(side.vertices.begin(), side.vertices.end(), [&](Index vertex) { return is_pinned(vertex, pins); });
}

std::string formatted(const char* format, double a, double b = 0.0, double c = 0.0) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, a, b, c);
  return text.data();
}

/// The relation of the two.
std::string meeting(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies) {
  const auto& [first, second] = blocked.sides;
  const std::string one = name_of(first, pins, bodies);
  if (second == ContactSide{}) return one + " moves too fast to be kept apart from what it meets";
  const std::string other = name_of(second, pins, bodies);
  const bool is_first_led = is_led(first, pins);
  const bool is_second_led = is_led(second, pins);
  if (is_first_led == is_second_led) {
    return one + " and " + other + (is_first_led ? " close in on each other" : " cannot be kept from crossing");
  }
  return (is_first_led ? one : other) + " closes in on " + (is_first_led ? other : one);
}

}  // namespace

std::string describe(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies) {
  const Vec3& at = blocked.place_m;
  std::string text = meeting(blocked, pins, bodies);
  if (blocked.behind) text += ", which " + name_of(*blocked.behind, pins, bodies) + " keeps from giving way";
  if (blocked.sides[1] != ContactSide{}) {
    text += blocked.distance_m > 0.0 ? formatted("; they are %.3g mm apart", 1e3 * blocked.distance_m)
                                     : "; they touch already";
  }
  return text + formatted(" at [%.5f, %.5f, %.5f] m", at.x, at.y, at.z);
}

ContactBlocked::ContactBlocked(BlockedContact blocked, const Pins& pins, std::span<const Body> bodies, double time_s)
    : std::runtime_error("something would cross at " + formatted("%.4f s: ", time_s) + describe(blocked, pins, bodies)),
      blocked_(std::move(blocked)),
      time_s_(time_s) {}

}  // namespace taut::sim
