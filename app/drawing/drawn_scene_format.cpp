#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {
namespace {

using Keys = std::vector<Key<DrawnScene>>;

constexpr double degree = 0.017453292519943295;
constexpr Range fraction = {.lowest = 0.0, .highest = 1.0};
constexpr Range acute = {.lowest = -89.0, .highest = 89.0};

glm::vec3 to_vec3(const std::array<double, 3>& numbers) {
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
}

Json to_json_list(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// Makes a key whose default is "auto", which leaves the member empty. On a command line "auto" also cancels the file's
/// value. `found(value)` parses other values and returns nothing if a value is invalid.
template <class Access, class Found, class Write>
Key<DrawnScene> auto_key(std::string name, std::string expected, Access access, Found found, Write write) {
  return member_key<DrawnScene>(
      std::move(name), "m", std::move(expected), access,
      [=](const toml::node& value, auto& member) {
        const bool is_auto = text_in(value) == "auto";
        const auto read = is_auto ? std::nullopt : found(value);
        member = is_auto || read ? read : member;
        return is_auto || read;
      },
      [=](const auto& member) { return member ? write(*member) : Json(); });
}

std::optional<renderer::Box> box_in(const toml::node& value) {
  const toml::array* list = value.as_array();
  if (list == nullptr || list->size() != 2) return std::nullopt;
  const auto lower = numbers_in<3>(list->front());
  const auto upper = numbers_in<3>(list->back());
  for (std::size_t i = 0; lower && upper && i < 3; ++i) {
    if ((*lower)[i] > (*upper)[i]) return std::nullopt;
  }
  return lower && upper ? std::optional(renderer::Box{to_vec3(*lower), to_vec3(*upper)}) : std::nullopt;
}

template <class Access> Key<DrawnScene> point_key(std::string name, Access access) {
  return auto_key(
      std::move(name), "three numbers [x, y, z] or \"auto\"", access,
      [](const toml::node& value) {
        const auto point = numbers_in<3>(value);
        return point ? std::optional(to_vec3(*point)) : std::nullopt;
      },
      to_json_list);
}

Key<DrawnScene> ground_key() {
  auto read = [](const toml::node& value, Ground& ground) {
    if (const auto height = finite_number(value)) {
      ground = {GroundKind::fixed, *height};
      return true;
    }
    const auto text = text_in(value);
    const bool is_word = text == "auto" || text == "none";
    ground = is_word ? Ground{text == "auto" ? GroundKind::automatic : GroundKind::none, 0.0} : ground;
    return is_word;
  };
  auto write = [](const Ground& ground) -> Json {
    return ground.kind == GroundKind::fixed       ? Json(ground.height_m)
           : ground.kind == GroundKind::automatic ? Json("auto")
                                                  : Json("none");
  };
  return member_key<DrawnScene>("picture.ground", "m", "\"auto\", \"none\" or a number", MEMBER(picture.ground), read,
                                write);
}

Key<DrawnScene> background_key() {
  auto read = [](const toml::node& value, Background& background) {
    const auto text = text_in(value);
    if (text == "studio" || text == "none") {
      background = {text == "none" ? BackgroundKind::transparent : BackgroundKind::studio, {}};
      return true;
    }
    const auto colour = colour_value(value);
    background = colour ? Background{BackgroundKind::colour, *colour} : background;
    return colour.has_value();
  };
  auto write = [](const Background& background) -> Json {
    return background.kind == BackgroundKind::colour        ? colour_text(background.colour)
           : background.kind == BackgroundKind::transparent ? "none"
                                                            : "studio";
  };
  return member_key<DrawnScene>("picture.background", "", "\"studio\", \"none\" or a colour, \"#rrggbb\"",
                                MEMBER(picture.background), read, write);
}

Key<DrawnScene> texture_key() {
  auto read = [](const toml::node& value, const Source& source, std::filesystem::path& texture) {
    const auto text = text_in(value);
    if (text) texture = names_image(*text) ? find_beside(source, *text) : std::filesystem::path(*text);
    return text.has_value();
  };
  return member_key<DrawnScene>("picture.texture", "", "a file name or \"none\"", MEMBER(picture.texture), read,
                                [](const auto& texture) { return texture.empty() ? Json() : Json(texture.string()); });
}

void check_whole(const DrawnScene& scene, const Source& source) {
  if (scene.camera.eye.has_value() != scene.camera.target.has_value()) {
    fail(source, 0, "camera.eye and camera.target are needed together; one is missing");
  }
  if (scene.camera.eye && *scene.camera.eye == *scene.camera.target) {
    fail(source, 0, "camera.eye and camera.target are the same point");
  }
  simulation_format().check(scene, source);
}

}  // namespace

SceneFormat<DrawnScene> drawn_scene_format() {
  Keys keys;
  for (Key<Scene>& key : scene_keys()) {
    keys.push_back(
        {std::move(key.name), std::move(key.unit), std::move(key.expected), std::move(key.read), std::move(key.write)});
  }
  keys.insert(
      keys.end(),
      {number_key<DrawnScene>("camera.azimuth", "degrees", {-360.0, 360.0}, MEMBER(camera.framing.azimuth_rad), degree),
       number_key<DrawnScene>("camera.elevation", "degrees", acute, MEMBER(camera.framing.elevation_rad), degree),
       number_key<DrawnScene>("camera.margin", "", {0.0, 0.45}, MEMBER(camera.framing.margin)),
       number_key<DrawnScene>("camera.field_of_view", "degrees", {1.0, 120.0}, MEMBER(camera.framing.vertical_fov_rad),
                              degree),
       switch_key<DrawnScene>("camera.follow", MEMBER(camera.follow)),
       auto_key("camera.box", "two corners [[x, y, z], [x, y, z]], the smaller coordinates first, or \"auto\"",
                MEMBER(camera.box), box_in,
                [](const renderer::Box& box) {
                  return Json::array({to_json_list(box.lower), to_json_list(box.upper)});
                }),
       point_key("camera.eye", MEMBER(camera.eye)),
       point_key("camera.target", MEMBER(camera.target)),
       whole_key<DrawnScene>("picture.width", {16, 16384}, MEMBER(picture.settings.width_px)),
       whole_key<DrawnScene>("picture.height", {16, 16384}, MEMBER(picture.settings.height_px)),
       choice_key<DrawnScene, DrawingQuality>("picture.quality",
                                              {{"draft", DrawingQuality::draft},
                                               {"normal", DrawingQuality::normal},
                                               {"high", DrawingQuality::high},
                                               {"final", DrawingQuality::final}},
                                              MEMBER(picture.quality)),
       whole_key<DrawnScene>("picture.passes", {1, renderer::max_passes}, MEMBER(picture.passes)),
       whole_key<DrawnScene>("picture.samples", {1, 16}, MEMBER(picture.settings.samples)),
       whole_key<DrawnScene>("picture.supersampling", {1, 8}, MEMBER(picture.settings.supersampling)),
       switch_key<DrawnScene>("picture.shadows", MEMBER(picture.settings.shadows)),
       ground_key(),
       background_key(),
       choice_key<DrawnScene, SurfaceLook>(
           "picture.surface",
           {{"shaded", SurfaceLook::shaded}, {"stretch", SurfaceLook::stretch}, {"wireframe", SurfaceLook::wireframe}},
           MEMBER(picture.surface)),
       switch_key<DrawnScene>("picture.wireframe", MEMBER(picture.wireframe)),
       choice_key<DrawnScene>("picture.springs", make_choices(all_which_springs), MEMBER(picture.springs)),
       switch_key<DrawnScene>("picture.smooth", MEMBER(picture.smooth)),
       switch_key<DrawnScene>("picture.wrinkles", MEMBER(picture.wrinkles)),
       choice_key<DrawnScene>("picture.stretch_of", make_choices(all_stretch_of), MEMBER(picture.stretch_of)),
       member_key<DrawnScene>(
           "picture.stretch_range", "", "two numbers [low, high], the lower first", MEMBER(picture.stretch_range),
           [](const toml::node& value, auto& range) {
             const auto found = numbers_in<2>(value);
             return found && found->front() < found->back() && store(found, range);
           },
           [](const auto& range) { return range ? Json(*range) : Json(); }),
       colour_key<DrawnScene>("picture.outside_colour", MEMBER(picture.cloth.outside_colour)),
       colour_key<DrawnScene>("picture.inside_colour", MEMBER(picture.cloth.inside_colour)),
       number_key<DrawnScene>("picture.roughness", "", {0.05, 1.0}, MEMBER(picture.cloth.roughness)),
       number_key<DrawnScene>("picture.sheen", "", fraction, MEMBER(picture.cloth.sheen)),
       number_key<DrawnScene>("picture.sheen_roughness", "", {0.4, 1.0}, MEMBER(picture.cloth.sheen_roughness)),
       number_key<DrawnScene>("picture.translucency", "", fraction, MEMBER(picture.cloth.translucency)),
       choice_key<DrawnScene>("picture.weave", make_choices(renderer::all_weave_kinds),
                              MEMBER(picture.cloth.weave_kind)),
       number_key<DrawnScene>("picture.threads", "1/m", {1.0, 1e6}, MEMBER(picture.cloth.threads_per_m)),
       number_key<DrawnScene>("picture.weave_contrast", "", {0.0, 10.0}, MEMBER(picture.cloth.weave)),
       number_key<DrawnScene>("picture.unevenness", "", fraction, MEMBER(picture.cloth.unevenness)),
       colour_key<DrawnScene>("picture.stitch_colour", MEMBER(picture.cloth.stitch_colour)),
       texture_key(),
       switch_key<DrawnScene>("picture.rest_outline", MEMBER(picture.rest_outline)),
       switch_key<DrawnScene>("picture.show_pins", MEMBER(picture.show_pins)),
       switch_key<DrawnScene>("picture.show_wind", MEMBER(picture.show_wind)),
       switch_key<DrawnScene>("picture.legend", MEMBER(picture.legend))});
  return {std::move(keys), check_whole};
}

}  // namespace taut::app
