#include "app/drawing/drawn_scene_lists.hpp"

#include <utility>

namespace taut::app {
namespace {

std::optional<std::array<double, 2>> two_rising_numbers(const Value& value) {
  if (value.list() == nullptr || value.list()->size() != 2) {
    return std::nullopt;
  }
  const auto low = finite_number(value.list()->front());
  const auto high = finite_number(value.list()->back());
  return low && high && *low < *high ? std::optional(std::array{*low, *high}) : std::nullopt;
}

glm::vec3 to_vec3(const std::array<double, 3>& numbers) {
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
}

Value list_of(const glm::vec3& v) {
  return app::list_of({v.x, v.y, v.z});
}

bool read_camera_box(const Value& value, const Source&, DrawnScene& scene) {
  if (value.list() == nullptr || value.list()->size() != 2) {
    return false;
  }
  const auto lower = three_numbers(value.list()->front());
  const auto upper = three_numbers(value.list()->back());
  for (std::size_t i = 0; lower && upper && i < 3; ++i) {
    if ((*lower)[i] > (*upper)[i]) {
      return false;
    }
  }
  if (lower && upper) {
    scene.camera.box = renderer::Box{to_vec3(*lower), to_vec3(*upper)};
  }
  return lower && upper;
}

Value write_camera_box(const DrawnScene& scene) {
  const auto& box = scene.camera.box;
  return box ? Value{ValueList{list_of(box->lower), list_of(box->upper)}} : Value{};
}

Key<DrawnScene> camera_point_key(std::string name, std::optional<glm::vec3> CameraSettings::*member,
                                 std::string meaning) {
  auto read = [member](const Value& value, const Source&, DrawnScene& scene) {
    const auto point = three_numbers(value);
    if (point) {
      scene.camera.*member = to_vec3(*point);
    }
    return point.has_value();
  };
  auto write = [member](const DrawnScene& scene) {
    const auto& point = scene.camera.*member;
    return point ? list_of(*point) : Value{};
  };
  return {std::move(name), "m", "three numbers [x, y, z]", std::move(meaning), read, write};
}

bool read_ground(const Value& value, const Source&, DrawnScene& scene) {
  Ground& ground = scene.picture.ground;
  if (const auto height = finite_number(value)) {
    ground = {GroundKind::fixed, *height};
    return true;
  }
  if (value.text() == nullptr || (*value.text() != "auto" && *value.text() != "none")) {
    return false;
  }
  ground = {*value.text() == "auto" ? GroundKind::automatic : GroundKind::none, 0.0};
  return true;
}

Value write_ground(const DrawnScene& scene) {
  const Ground& ground = scene.picture.ground;
  if (ground.kind == GroundKind::fixed) {
    return {ground.height_m};
  }
  return {std::string(ground.kind == GroundKind::automatic ? "auto" : "none")};
}

}  // namespace

Key<DrawnScene> camera_box_key() {
  return {"camera.box",
          "m",
          "two corners [[x, y, z], [x, y, z]], the smaller coordinates first",
          "what has to be in the picture; not set: all that the garment can reach",
          read_camera_box,
          write_camera_box};
}

Key<DrawnScene> camera_eye_key() {
  return camera_point_key("camera.eye", &CameraSettings::eye, "with camera.target: where from, exactly");
}

Key<DrawnScene> camera_target_key() {
  return camera_point_key("camera.target", &CameraSettings::target, "what the eye looks at");
}

Key<DrawnScene> ground_key() {
  return {"picture.ground",
          "m",
          "\"auto\", \"none\" or a number",
          "height of the floor; auto: on a level plane collider, or else below all there is",
          read_ground,
          write_ground};
}

Key<DrawnScene> stretch_range_key() {
  auto read = [](const Value& value, const Source&, DrawnScene& scene) {
    const auto range = two_rising_numbers(value);
    if (range) {
      scene.picture.stretch_range = *range;
    }
    return range.has_value();
  };
  auto write = [](const DrawnScene& scene) {
    const auto& range = scene.picture.stretch_range;
    return range ? Value{ValueList{Value{(*range)[0]}, Value{(*range)[1]}}} : Value{};
  };
  return {"picture.stretch_range",
          "",
          "two numbers [low, high], the lower first",
          "stretch shown as the two ends of the colours; not set: from 0 to the solver's bound, or to 0.05 "
          "where it has none",
          read,
          write};
}

}  // namespace taut::app
