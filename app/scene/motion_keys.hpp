#pragma once

#include <cmath>

#include "app/scene/scene_key.hpp"
#include "sim/rigid_motion.hpp"

namespace taut::app {

/// A path as a list of [time, x, y, z] with rising times. Empty for anything else.
std::optional<std::vector<sim::PathPoint>> path_in(const toml::node& value);

/// Makes a direction one of length 1. What has it already keeps its bits, so that what is written reads back
/// as the same.
void normalise(sim::Vec3& direction);

/// Completes a motion after all its keys were read. Throws by `fail` (scene_value.hpp) if it ends before it
/// begins.
void check_motion(const Source& source, int line, sim::RigidMotion& motion);

/// Keys that are not in use are not written.
template <class T, class IsUsed>
Key<T> written_if(Key<T> key, IsUsed is_used) {
  key.write = [write = std::move(key.write), is_used](const T& entry) {
    return is_used(entry) ? write(entry) : Json();
  };
  return key;
}

/// A key for the path that `path_of` returns, of an entry that is const or not.
template <class T, class Access>
Key<T> path_key(std::string name, std::string unit, Access path_of, std::string meaning) {
  auto read = [=](const toml::node& value, const Source&, T& entry) {
    return store(path_in(value), path_of(entry));
  };
  auto write = [=](const T& entry) {
    Json list;
    for (const sim::PathPoint& point : path_of(entry)) {
      list.push_back({point.time_s, point.offset.x, point.offset.y, point.offset.z});
    }
    return list;
  };
  return {std::move(name),
          "s, " + unit,
          "a list of [time, x, y, z], the times rising",
          meaning + "; straight in between, held before and after",
          read,
          write};
}

/// Adds the keys of a motion; `motion` returns the one of an entry, const or not.
template <class T, class Access>
void add_motion(std::vector<Key<T>>& keys, Access motion) {
  const auto add = [&](Key<T> key, auto is_used) { keys.push_back(written_if(std::move(key), is_used)); };
  const auto add_times = [&](const std::string& part_name, auto part, auto is_used) {
    constexpr Range time = {.lowest = 0.0, .highest = 1e6};
    add(number_key<T>(
            part_name + ".from", "s", time, [=](auto& e) -> auto& { return part(e).from_s; },
            "when it begins; not set: at 0"),
        is_used);
    add(number_key<T>(
            part_name + ".until", "s", time, [=](auto& e) -> auto& { return part(e).until_s; },
            "when it ends; not set: never"),
        [=](const T& e) { return std::isfinite(part(e).until_s); });
  };
  const auto shift = [=](auto& e) -> auto& {
    return motion(e).shift;
  };
  const auto shifts = [=](const T& e) { return shift(e) != sim::Shift{}; };
  add(vector_key<T>(
          "shift.velocity", "m/s", [=](auto& e) -> auto& { return shift(e).velocity_m_per_s; },
          "it moves along a line"),
      shifts);
  add_times("shift", shift, shifts);
  const auto spin = [=](auto& e) -> auto& {
    return motion(e).spin;
  };
  const auto spins = [=](const T& e) { return spin(e) != sim::Spin{}; };
  add(vector_key<T>(
          "spin.about", "m", [=](auto& e) -> auto& { return spin(e).about_m; },
          "it turns about the line through this point, before it is moved"),
      spins);
  add(vector_key<T>("spin.axis", "", [=](auto& e) -> auto& { return spin(e).axis; },
                    "the line's direction, of any length; not set: up", {.may_be_zero = false}),
      spins);
  add(number_key<T>(
          "spin.turns_per_second", "",
          {-1000.0, 1000.0}, [=](auto& e) -> auto& { return spin(e).turns_per_s; },
          "counter-clockwise seen from where the axis points"),
      spins);
  add_times("spin", spin, spins);
  keys.push_back(path_key<T>(
      "path", "m", [=](auto& e) -> auto& { return motion(e).path; },
      "how far it is from where it was modelled"));
}

}  // namespace taut::app
