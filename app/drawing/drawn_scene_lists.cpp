#include "app/drawing/drawn_scene_lists.hpp"

#include <utility>

namespace taut::app {
namespace {

std::optional<std::array<double, 2>> two_rising_numbers(const toml::node& value) {
  const toml::array* list = value.as_array();
  if (list == nullptr || list->size() != 2) {
    return std::nullopt;
  }
  const auto low = finite_number(list->front());
  const auto high = finite_number(list->back());
  return low && high && *low < *high ? std::optional(std::array{*low, *high}) : std::nullopt;
}

glm::vec3 to_vec3(const std::array<double, 3>& numbers) {
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
}

Json list_of(const glm::vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

// A file need not say so; a command line takes back with it what a file says.
bool is_auto(const toml::node& value) {
  return text_in(value) == "auto";
}

bool read_camera_box(const toml::node& value, const Source&, DrawnScene& scene) {
  if (is_auto(value)) {
    scene.camera.box.reset();
    return true;
  }
  const toml::array* list = value.as_array();
  if (list == nullptr || list->size() != 2) {
    return false;
  }
  const auto lower = three_numbers(list->front());
  const auto upper = three_numbers(list->back());
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

Json write_camera_box(const DrawnScene& scene) {
  const auto& box = scene.camera.box;
  return box ? Json::array({list_of(box->lower), list_of(box->upper)}) : Json();
}

Key<DrawnScene> camera_point_key(std::string name, std::optional<glm::vec3> CameraSettings::*member,
                                 std::string meaning) {
  auto read = [member](const toml::node& value, const Source&, DrawnScene& scene) {
    const auto point = three_numbers(value);
    scene.camera.*member = point ? std::optional(to_vec3(*point)) : std::nullopt;
    return point.has_value() || is_auto(value);
  };
  auto write = [member](const DrawnScene& scene) {
    const auto& point = scene.camera.*member;
    return point ? list_of(*point) : Json();
  };
  return {std::move(name), "m", "three numbers [x, y, z] or \"auto\"", std::move(meaning), read, write};
}

bool read_ground(const toml::node& value, const Source&, DrawnScene& scene) {
  Ground& ground = scene.picture.ground;
  if (const auto height = finite_number(value)) {
    ground = {GroundKind::fixed, *height};
    return true;
  }
  const auto text = text_in(value);
  if (text != "auto" && text != "none") {
    return false;
  }
  ground = {text == "auto" ? GroundKind::automatic : GroundKind::none, 0.0};
  return true;
}

Json write_ground(const DrawnScene& scene) {
  const Ground& ground = scene.picture.ground;
  if (ground.kind == GroundKind::fixed) {
    return ground.height_m;
  }
  return ground.kind == GroundKind::automatic ? "auto" : "none";
}

}  // namespace

Key<DrawnScene> camera_box_key() {
  return {"camera.box",
          "m",
          "two corners [[x, y, z], [x, y, z]], the smaller coordinates first, or \"auto\"",
          "what has to be in the picture; not set: what camera.fit says",
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
          "height of the floor; auto: on a level plane, or else below all there is",
          read_ground,
          write_ground};
}

Key<DrawnScene> background_key() {
  auto read = [](const toml::node& value, const Source&, DrawnScene& scene) {
    Background& background = scene.picture.background;
    const auto text = text_in(value);
    if (text == "studio" || text == "none") {
      background = {text == "none" ? BackgroundKind::transparent : BackgroundKind::studio, {}};
      return true;
    }
    const auto colour = colour_value(value);
    if (colour) {
      background = {BackgroundKind::colour, *colour};
    }
    return colour.has_value();
  };
  auto write = [](const DrawnScene& scene) -> Json {
    const Background& background = scene.picture.background;
    if (background.kind == BackgroundKind::colour) {
      return colour_text(background.colour);
    }
    return background.kind == BackgroundKind::transparent ? "none" : "studio";
  };
  return {"picture.background",
          "",
          "\"studio\", \"none\" or a colour, \"#rrggbb\" or a name such as \"white\"",
          "what is behind; none: transparent but for shadows; on a colour shadows fall as well",
          read,
          write};
}

Key<DrawnScene> spring_patch_key() {
  auto read = [](const toml::node& value, const Source&, DrawnScene& scene) {
    const toml::array* list = value.as_array();
    std::array<double, 4> numbers{};
    bool are_numbers = list != nullptr && list->size() == numbers.size();
    for (std::size_t i = 0; are_numbers && i < numbers.size(); ++i) {
      are_numbers = store(finite_number((*list)[i]), numbers[i]);
    }
    if (are_numbers && numbers[3] > 0.0) {
      scene.picture.springs.patch = SpringBall{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
    } else {
      scene.picture.springs.patch.reset();
    }
    return scene.picture.springs.patch.has_value() || is_auto(value);
  };
  auto write = [](const DrawnScene& scene) {
    const std::optional<SpringBall>& patch = scene.picture.springs.patch;
    return patch ? Json::array({patch->middle_m.x, patch->middle_m.y, patch->middle_m.z, patch->radius_m})
                 : Json();
  };
  return {"picture.springs_patch",
          "m",
          "four numbers [x, y, z, radius], or \"auto\"",
          "springs are shown within this ball of the garment at rest; auto: everywhere",
          read,
          write};
}

Key<DrawnScene> texture_key() {
  auto read = [](const toml::node& value, const Source& source, DrawnScene& scene) {
    const auto text = text_in(value);
    if (text) {
      const bool is_file = !text->empty() && *text != no_texture;
      scene.picture.texture = is_file ? beside(source, *text) : std::filesystem::path(*text);
    }
    return text.has_value();
  };
  auto write = [](const DrawnScene& scene) {
    const std::filesystem::path& texture = scene.picture.texture;
    return texture.empty() ? Json() : Json(texture.string());
  };
  return {
      "picture.texture",
      "",
      "a file name or \"none\"",
      "an image on the garment's texture coordinates, relative to the scene file, over the cloth's colours; "
      "not set: the model's own images, where it has any and outside_colour is not set",
      read,
      write};
}

Key<DrawnScene> stretch_range_key() {
  auto read = [](const toml::node& value, const Source&, DrawnScene& scene) {
    return store(two_rising_numbers(value), scene.picture.stretch_range);
  };
  auto write = [](const DrawnScene& scene) {
    const auto& range = scene.picture.stretch_range;
    return range ? Json(*range) : Json();
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
