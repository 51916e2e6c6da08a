#include "app/drawing/drawn_scene.hpp"

#include "app/scene/scene_format.hpp"
#include "renderer/surface/refined_mesh.hpp"
#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {

std::array<double, 2> shown_stretch_range(const DrawnScene& scene) {
  constexpr double most_without_bound = 0.05;
  const std::array from_zero = {
      0.0, std::max(stretch_bound(scene).value_or(most_without_bound), sim::smallest_promised_bound)};
  return scene.picture.stretch_range.value_or(from_zero);
}

std::optional<double> shown_bound(const DrawnScene& scene) {
  const bool holds_shown =
      scene.picture.stretch_of == StretchOf::springs || bound_kind(scene) == sim::BoundKind::surface;
  return holds_shown ? stretch_bound(scene) : std::nullopt;
}

const char* name_of(StretchOf shown) { return shown == StretchOf::springs ? "springs" : "surface"; }

const char* legend_title(StretchOf shown) {
  return shown == StretchOf::springs ? "stretch of springs" : "stretch of the surface";
}

const char* name_of(WhichSprings which) {
  constexpr std::array names = {"none", "structural", "shear", "flexural", "all"};
  return names[static_cast<std::size_t>(which)];
}

renderer::PictureSettings settings_of(const PictureStyle& style) {
  renderer::PictureSettings settings = style.settings;
  if (style.quality == DrawingQuality::draft) {
    settings.samples = 1;
    settings.sky_directions = 12;
    settings.shadow_taps = 8;
  }
  if (style.quality == DrawingQuality::high) {
    settings.supersampling = std::min(2 * settings.supersampling, 8);
    settings.shadow_map_px = 4096;
    settings.sky_directions = 64;
  }
  return settings;
}

float shortest_edge_px(const PictureStyle& style) {
  constexpr std::array lengths_px = {16.0F, renderer::shortest_split_px, 4.0F};
  return lengths_px[static_cast<std::size_t>(style.quality)];
}

renderer::Backdrop backdrop_of(const Background& background) {
  renderer::Backdrop backdrop;
  if (background.kind == BackgroundKind::colour) {
    backdrop.lower_colour = backdrop.upper_colour = background.colour;
  }
  backdrop.transparent = background.kind == BackgroundKind::transparent;
  return backdrop;
}

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides) {
  return read_scene_text(read_text_file(path), path.string(), overrides);
}

DrawnScene read_scene_text(const std::string& text, const std::string& name, std::span<const Override> overrides) {
  return read_scene(drawn_scene_format(), text, name, overrides);
}

DrawnScene find_scene(const std::string& name, std::span<const Override> overrides) {
  DrawnScene scene = find_scene(drawn_scene_format(), name, overrides);
  // The scene's floor may not be where another body stands.
  if (sets(overrides, "body.file") && !sets(overrides, "picture.ground")) scene.picture.ground = {};
  return scene;
}

void apply_overrides(std::span<const Override> overrides, DrawnScene& scene) {
  apply_overrides(drawn_scene_format(), overrides, scene);
}

void set_garment(const std::filesystem::path& file, DrawnScene& scene) {
  set_garment(file, static_cast<Scene&>(scene));
  scene.picture.show_pins = false;
}

Json scene_settings(const DrawnScene& scene) { return settings_of(drawn_scene_format(), scene); }

std::string scene_text(const DrawnScene& scene, GarmentNaming naming) {
  Json settings = scene_settings(scene);
  if (names_image(scene.picture.texture)) {
    settings["picture"]["texture"] = name_in_scene(scene.picture.texture, naming);
  }
  return text_of(std::move(settings), scene, naming);
}

std::string scene_help() {
  std::string text =
      "A scene file is TOML. Every key has a default, apart from the garment: one of\n"
      "garment.file and [garment.grid]. The same keys work with --set KEY=VALUE.\n"
      "A length, speed, weight, angle or time may carry its unit: \"1 mm\", \"36 km/h\".\n\n";
  const DrawnScene defaults;
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) text += describe_key(key, defaults);
  return text + list_entries_help();
}

namespace {

using Keys = std::vector<Key<DrawnScene>>;

constexpr double degree = 0.017453292519943295;
constexpr Range fraction = {.lowest = 0.0, .highest = 1.0};
constexpr Range acute = {.lowest = -89.0, .highest = 89.0};

Key<DrawnScene> number(std::string name, std::string unit, const Range& range, auto access, std::string meaning,
                       double factor = 1.0) {
  return number_key<DrawnScene>(std::move(name), std::move(unit), range, access, std::move(meaning), factor);
}
Key<DrawnScene> whole(std::string name, double lowest, double highest, auto access, std::string meaning) {
  return whole_key<DrawnScene>(std::move(name), {lowest, highest}, access, std::move(meaning));
}

std::optional<std::array<double, 2>> two_rising_numbers(const toml::node& value) {
  const toml::array* list = value.as_array();
  if (list == nullptr || list->size() != 2) return std::nullopt;
  const auto low = finite_number(list->front());
  const auto high = finite_number(list->back());
  return low && high && *low < *high ? std::optional(std::array{*low, *high}) : std::nullopt;
}

glm::vec3 to_vec3(const std::array<double, 3>& numbers) {
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
}

Json list_of(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// A key whose text "auto", which leaves the member empty, is what a file need not say; a command line takes
/// back with it what a file says. `found(value)` is empty for what is not as expected.
template <class Access, class Found, class Write>
Key<DrawnScene> auto_key(std::string name, std::string expected, Access access, std::string meaning, Found found,
                         Write write) {
  return member_key<DrawnScene>(
      std::move(name), "m", std::move(expected), access, std::move(meaning),
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
  const auto lower = three_numbers(list->front());
  const auto upper = three_numbers(list->back());
  for (std::size_t i = 0; lower && upper && i < 3; ++i) {
    if ((*lower)[i] > (*upper)[i]) return std::nullopt;
  }
  return lower && upper ? std::optional(renderer::Box{to_vec3(*lower), to_vec3(*upper)}) : std::nullopt;
}

template <class Access> Key<DrawnScene> point_key(std::string name, Access access, std::string meaning) {
  return auto_key(
      std::move(name), "three numbers [x, y, z] or \"auto\"", access, std::move(meaning),
      [](const toml::node& value) {
        const auto point = three_numbers(value);
        return point ? std::optional(to_vec3(*point)) : std::nullopt;
      },
      list_of);
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
  return member_key<DrawnScene>("picture.ground", "m", "\"auto\", \"none\" or a number", MEMBER(picture.ground),
                                "height of the floor; auto: on a level plane, or else below all there is", read, write);
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
  return member_key<DrawnScene>(
      "picture.background", "", "\"studio\", \"none\" or a colour, \"#rrggbb\" or a name such as \"white\"",
      MEMBER(picture.background), "what is behind; none: transparent but for shadows; on a colour shadows fall as well",
      read, write);
}

Key<DrawnScene> texture_key() {
  auto read = [](const toml::node& value, const Source& source, std::filesystem::path& texture) {
    const auto text = text_in(value);
    if (text) texture = names_image(*text) ? beside(source, *text) : std::filesystem::path(*text);
    return text.has_value();
  };
  return member_key<DrawnScene>(
      "picture.texture", "", "a file name or \"none\"", MEMBER(picture.texture),
      "an image on the garment's texture coordinates, relative to the scene file, over the cloth's colours; "
      "not set: the model's own images, where it has any and outside_colour is not set",
      read, [](const auto& texture) { return texture.empty() ? Json() : Json(texture.string()); });
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
    keys.push_back({std::move(key.name), std::move(key.unit), std::move(key.expected), std::move(key.meaning),
                    std::move(key.read), std::move(key.write)});
  }
  keys.insert(
      keys.end(),
      {number("camera.azimuth", "degrees", {-360.0, 360.0}, MEMBER(camera.framing.azimuth_rad),
              "0: from the front (+z), 90: from +x", degree),
       number("camera.elevation", "degrees", acute, MEMBER(camera.framing.elevation_rad), "above the horizon", degree),
       number("camera.margin", "", {0.0, 0.45}, MEMBER(camera.framing.margin),
              "free border, as a fraction of the picture"),
       number("camera.field_of_view", "degrees", {1.0, 120.0}, MEMBER(camera.framing.vertical_fov_rad),
              "from the lower to the upper edge of the picture", degree),
       choice_key<DrawnScene, CameraFit>(
           "camera.fit", {{"frames", CameraFit::frames}, {"reach", CameraFit::reach}}, MEMBER(camera.fit),
           "what fills a picture without camera.box and camera.eye: the garment in all frames that are "
           "drawn, which are simulated first; or what it can reach, and pictures come as they are simulated"),
       switch_key<DrawnScene>("camera.follow", MEMBER(camera.follow), "the camera moves with the garment"),
       auto_key("camera.box", "two corners [[x, y, z], [x, y, z]], the smaller coordinates first, or \"auto\"",
                MEMBER(camera.box), "what has to be in the picture; not set: what camera.fit says", box_in,
                [](const renderer::Box& box) {
                  return Json::array({list_of(box.lower), list_of(box.upper)});
                }),
       point_key("camera.eye", MEMBER(camera.eye), "with camera.target: where from, exactly"),
       point_key("camera.target", MEMBER(camera.target), "what the eye looks at"),
       whole("picture.width", 16, 16384, MEMBER(picture.settings.width_px), "in pixels"),
       whole("picture.height", 16, 16384, MEMBER(picture.settings.height_px), "in pixels"),
       choice_key<DrawnScene, DrawingQuality>(
           "picture.quality",
           {{"draft", DrawingQuality::draft}, {"normal", DrawingQuality::normal}, {"high", DrawingQuality::high}},
           MEMBER(picture.quality), "how much work a picture is; high: for print"),
       whole("picture.samples", 1, 16, MEMBER(picture.settings.samples), "in a pixel; lowered to what OpenGL offers"),
       whole("picture.supersampling", 1, 8, MEMBER(picture.settings.supersampling),
             "drawn so many times as wide and high, then averaged"),
       switch_key<DrawnScene>("picture.shadows", MEMBER(picture.settings.shadows), "of the key light"),
       ground_key(),
       background_key(),
       choice_key<DrawnScene, SurfaceLook>(
           "picture.surface",
           {{"shaded", SurfaceLook::shaded}, {"stretch", SurfaceLook::stretch}, {"wireframe", SurfaceLook::wireframe}},
           MEMBER(picture.surface), "what the cloth shows"),
       switch_key<DrawnScene>("picture.wireframe", MEMBER(picture.wireframe),
                              "draws the structural springs over the surface"),
       choice_key<DrawnScene>("picture.springs", named(all_which_springs), MEMBER(picture.springs),
                              "which springs are drawn over the surface"),
       switch_key<DrawnScene>("picture.smooth", MEMBER(picture.smooth),
                              "draws a smooth surface along the simulated vertices, at most 4 mm from them; "
                              "false: the simulated triangles"),
       switch_key<DrawnScene>(
           "picture.wrinkles", MEMBER(picture.wrinkles),
           "draws, where cloth is shorter than at rest, the small wrinkles that its mesh cannot show"),
       choice_key<DrawnScene>("picture.stretch_of", named(all_stretch_of), MEMBER(picture.stretch_of),
                              "what the colours show the stretch of: at each vertex the largest of the "
                              "springs there, or of the triangles in any direction"),
       member_key<DrawnScene>(
           "picture.stretch_range", "", "two numbers [low, high], the lower first", MEMBER(picture.stretch_range),
           "stretch shown as the two ends of the colours; not set: from 0 to the solver's bound, or to 0.05 "
           "where it has none",
           [](const toml::node& value, auto& range) { return store(two_rising_numbers(value), range); },
           [](const auto& range) { return range ? Json(*range) : Json(); }),
       colour_key<DrawnScene>("picture.outside_colour", MEMBER(picture.cloth.outside_colour), "of the cloth's outside"),
       colour_key<DrawnScene>("picture.inside_colour", MEMBER(picture.cloth.inside_colour),
                              "of the cloth's inside; not set: a paler and greyer shade of its outside"),
       number("picture.roughness", "", {0.05, 1.0}, MEMBER(picture.cloth.roughness),
              "of the cloth: from glossy to matt"),
       number("picture.sheen", "", fraction, MEMBER(picture.cloth.sheen),
              "of the cloth: how much of the light its fibres reflect that stand off"),
       number("picture.sheen_roughness", "", {0.4, 1.0}, MEMBER(picture.cloth.sheen_roughness),
              "of these fibres: from a narrow fringe to a veil"),
       number("picture.translucency", "", fraction, MEMBER(picture.cloth.translucency),
              "of the cloth: share of the light that passes through"),
       choice_key<DrawnScene>("picture.weave", named(renderer::all_weave_kinds), MEMBER(picture.cloth.weave_kind),
                              "of the cloth, seen from near"),
       number("picture.threads", "1/m", {1.0, 1e6}, MEMBER(picture.cloth.threads_per_m),
              "how many threads, or stitches of a knit, lie side by side"),
       number("picture.weave_contrast", "", {0.0, 10.0}, MEMBER(picture.cloth.weave),
              "how much threads differ in brightness; 0: none are seen"),
       number("picture.unevenness", "", fraction, MEMBER(picture.cloth.unevenness),
              "how much yarns differ from each other and along their length"),
       colour_key<DrawnScene>("picture.stitch_colour", MEMBER(picture.cloth.stitch_colour),
                              "of the threads of hems and seams; not set: a lighter shade of the cloth"),
       texture_key(),
       switch_key<DrawnScene>("picture.rest_outline", MEMBER(picture.rest_outline),
                              "draws the garment's borders where they were modelled"),
       switch_key<DrawnScene>("picture.show_pins", MEMBER(picture.show_pins), "as red balls"),
       switch_key<DrawnScene>("picture.show_wind", MEMBER(picture.show_wind),
                              "as arrows on the side it comes from, longer for more"),
       switch_key<DrawnScene>("picture.legend", MEMBER(picture.legend),
                              "a colour bar where the cloth shows its stretch")});
  return {std::move(keys), check_whole};
}

}  // namespace taut::app
