#include "sim/blocked_contact.hpp"

namespace taut::sim {
namespace {

bool is_pinned(Index vertex, const Pins& pins) {
  return std::binary_search(pins.vertices.begin(), pins.vertices.end(), vertex);
}

std::string join_numbers(const std::vector<Index>& vertices) {
  std::string text;
  for (const Index vertex : vertices) text += (text.empty() ? "" : ", ") + std::to_string(vertex);
  return text;
}

std::string to_name(const ContactSide& side, const Pins& pins, std::span<const Body> bodies) {
  if (side.body) {
    const std::string& name = bodies[*side.body].name;
    return name.empty() ? "body " + std::to_string(*side.body) : "the body '" + name + '\'';
  }
  std::vector<Index> pinned;
  std::copy_if(side.vertices.begin(), side.vertices.end(), std::back_inserter(pinned),
               [&](Index vertex) { return is_pinned(vertex, pins); });
  if (side.vertices.size() == 1) {
    return (pinned.empty() ? "vertex " : "the pinned vertex ") + join_numbers(side.vertices);
  }
  const std::string kind = side.vertices.size() == 2 ? "the edge" : "the triangle";
  return kind + " of the vertices " + join_numbers(side.vertices) +
         (pinned.empty() ? ""
                         : ", of which " + join_numbers(pinned) + (pinned.size() == 1 ? " is" : " are") + " pinned");
}

/// Returns whether the side is a body, or cloth whose vertices are all pinned.
bool is_kinematic(const ContactSide& side, const Pins& pins) {
  return side.body ||
         std::all_of(side.vertices.begin(), side.vertices.end(), [&](Index vertex) { return is_pinned(vertex, pins); });
}

std::string format_numbers(const char* format, double a, double b = 0.0, double c = 0.0) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, a, b, c);
  return text.data();
}

/// Returns the clause that says how the two sides meet.
std::string describe_meeting(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies) {
  const auto& [first, second] = blocked.sides;
  const std::string one = to_name(first, pins, bodies);
  if (second == ContactSide{}) return one + " moves too fast to be kept apart from what it meets";
  const std::string other = to_name(second, pins, bodies);
  const bool is_first_led = is_kinematic(first, pins);
  const bool is_second_led = is_kinematic(second, pins);
  if (is_first_led == is_second_led) {
    return one + " and " + other + (is_first_led ? " close in on each other" : " cannot be kept from crossing");
  }
  return (is_first_led ? one : other) + " closes in on " + (is_first_led ? other : one);
}

}  // namespace

std::string describe(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies) {
  const Vec3& at = blocked.place_m;
  std::string text = describe_meeting(blocked, pins, bodies);
  if (blocked.behind) text += ", which " + to_name(*blocked.behind, pins, bodies) + " keeps from giving way";
  if (blocked.sides[1] != ContactSide{}) {
    text += blocked.distance_m > 0.0 ? format_numbers("; they are %.3g mm apart", 1e3 * blocked.distance_m)
                                     : "; they touch already";
  }
  return text + format_numbers(" at [%.5f, %.5f, %.5f] m", at.x, at.y, at.z);
}

ContactBlocked::ContactBlocked(BlockedContact blocked, const Pins& pins, std::span<const Body> bodies, double time_s)
    : std::runtime_error("something would cross at " + format_numbers("%.4f s: ", time_s) +
                         describe(blocked, pins, bodies)),
      blocked_(std::move(blocked)),
      time_s_(time_s) {}

}  // namespace taut::sim
