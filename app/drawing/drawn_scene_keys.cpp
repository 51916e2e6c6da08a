#include <glm/trigonometric.hpp>
#include <utility>

#include "app/drawing/drawn_scene_file.hpp"
#include "app/drawing/drawn_scene_lists.hpp"
#include "app/scene/scene_format.hpp"
#include "app/scene/scene_keys.hpp"

namespace taut::app {
namespace {

using Keys = std::vector<Key<DrawnScene>>;

constexpr double degree = 0.017453292519943295;
constexpr Range acute = {.lowest = -89.0, .highest = 89.0};

Key<DrawnScene> number(std::string name, std::string unit, const Range& range, auto access,
                       std::string meaning, double factor = 1.0) {
  return number_key<DrawnScene>(std::move(name), std::move(unit), range, access, std::move(meaning), factor);
}
Key<DrawnScene> whole(std::string name, double lowest, double highest, auto access, std::string meaning) {
  return whole_key<DrawnScene>(std::move(name), {lowest, highest}, access, std::move(meaning));
}

void add_camera(Keys& keys) {
  keys.push_back(number("camera.azimuth", "degrees", {-360.0, 360.0}, MEMBER(camera.framing.azimuth_rad),
                        "0: from the front (+z), 90: from +x", degree));
  keys.push_back(number("camera.elevation", "degrees", acute, MEMBER(camera.framing.elevation_rad),
                        "above the horizon", degree));
  keys.push_back(number("camera.margin", "", {0.0, 0.45}, MEMBER(camera.framing.margin),
                        "free border, as a fraction of the picture"));
  keys.push_back(number("camera.field_of_view", "degrees", {1.0, 120.0},
                        MEMBER(camera.framing.vertical_fov_rad),
                        "from the lower to the upper edge of the picture", degree));
  keys.push_back(choice_key<DrawnScene, CameraFit>(
      "camera.fit", {{"frames", CameraFit::frames}, {"reach", CameraFit::reach}}, MEMBER(camera.fit),
      "what fills a picture without camera.box and camera.eye: the garment in all frames that are drawn, "
      "which are simulated first; or what it can reach, and pictures come as they are simulated"));
  keys.push_back(
      switch_key<DrawnScene>("camera.follow", MEMBER(camera.follow), "the camera moves with the garment"));
  keys.push_back(camera_box_key());
  keys.push_back(camera_eye_key());
  keys.push_back(camera_target_key());
}

void add_cloth(Keys& keys) {
  keys.push_back(colour_key<DrawnScene>("picture.outside_colour", MEMBER(picture.cloth.outside_colour),
                                        "of the cloth's outside"));
  keys.push_back(
      colour_key<DrawnScene>("picture.inside_colour", MEMBER(picture.cloth.inside_colour),
                             "of the cloth's inside; not set: a paler and greyer shade of its outside"));
  constexpr Range fraction = {.lowest = 0.0, .highest = 1.0};
  keys.push_back(number("picture.roughness", "", {0.05, 1.0}, MEMBER(picture.cloth.roughness),
                        "of the cloth: from glossy to matt"));
  keys.push_back(number("picture.sheen", "", fraction, MEMBER(picture.cloth.sheen),
                        "of the cloth: brightness of its fibres seen from the side"));
  keys.push_back(number("picture.translucency", "", fraction, MEMBER(picture.cloth.translucency),
                        "of the cloth: share of the light that passes through"));
  keys.push_back(choice_key<DrawnScene>("picture.weave", named(renderer::all_weave_kinds),
                                        MEMBER(picture.cloth.weave_kind), "of the cloth, seen from near"));
  keys.push_back(number("picture.threads", "1/m", {1.0, 1e6}, MEMBER(picture.cloth.threads_per_m),
                        "how many threads, or stitches of a knit, lie side by side"));
  keys.push_back(number("picture.weave_contrast", "", {0.0, 10.0}, MEMBER(picture.cloth.weave),
                        "how much threads differ in brightness; 0: none are seen"));
}

void add_picture(Keys& keys) {
  keys.push_back(whole("picture.width", 16, 16384, MEMBER(picture.settings.width_px), "in pixels"));
  keys.push_back(whole("picture.height", 16, 16384, MEMBER(picture.settings.height_px), "in pixels"));
  keys.push_back(choice_key<DrawnScene, DrawingQuality>(
      "picture.quality",
      {{"draft", DrawingQuality::draft}, {"normal", DrawingQuality::normal}, {"high", DrawingQuality::high}},
      MEMBER(picture.quality), "how much work a picture is; high: for print"));
  keys.push_back(whole("picture.samples", 1, 16, MEMBER(picture.settings.samples),
                       "in a pixel; lowered to what OpenGL offers"));
  keys.push_back(whole("picture.supersampling", 1, 8, MEMBER(picture.settings.supersampling),
                       "drawn so many times as wide and high, then averaged"));
  keys.push_back(
      switch_key<DrawnScene>("picture.shadows", MEMBER(picture.settings.shadows), "of the key light"));
  keys.push_back(ground_key());
  keys.push_back(background_key());
  keys.push_back(choice_key<DrawnScene, SurfaceLook>("picture.surface",
                                                     {{"shaded", SurfaceLook::shaded},
                                                      {"stretch", SurfaceLook::stretch},
                                                      {"wireframe", SurfaceLook::wireframe}},
                                                     MEMBER(picture.surface), "what the cloth shows"));
  keys.push_back(switch_key<DrawnScene>("picture.wireframe", MEMBER(picture.wireframe),
                                        "draws the structural springs over the surface"));
  keys.push_back(choice_key<DrawnScene>("picture.springs", named(all_which_springs),
                                        MEMBER(picture.springs.which),
                                        "which springs are drawn over the surface"));
  keys.push_back(choice_key<DrawnScene, SpringColours>(
      "picture.springs_by", {{"kind", SpringColours::kind}, {"order", SpringColours::order}},
      MEMBER(picture.springs.colours),
      "what their colours mean: their kind, or the order in which the paper's sweep corrects them, from dark "
      "to bright"));
  keys.push_back(spring_patch_key());
  keys.push_back(switch_key<DrawnScene>("picture.smooth", MEMBER(picture.smooth),
                                        "draws a smooth surface along the simulated vertices, at most 4 mm "
                                        "from them; false: the simulated triangles"));
  keys.push_back(choice_key<DrawnScene>(
      "picture.stretch_of", named(all_stretch_of), MEMBER(picture.stretch_of),
      "what the colours show the stretch of: at each vertex the largest of the springs there, or of the "
      "triangles in any direction"));
  keys.push_back(stretch_range_key());
  add_cloth(keys);
  keys.push_back(texture_key());
  keys.push_back(switch_key<DrawnScene>("picture.rest_outline", MEMBER(picture.rest_outline),
                                        "draws the garment's borders where they were modelled"));
  keys.push_back(switch_key<DrawnScene>("picture.show_pins", MEMBER(picture.show_pins), "as red balls"));
  keys.push_back(switch_key<DrawnScene>("picture.show_wind", MEMBER(picture.show_wind),
                                        "as arrows on the side it comes from, longer for more"));
  keys.push_back(switch_key<DrawnScene>("picture.legend", MEMBER(picture.legend),
                                        "a colour bar where the cloth shows its stretch"));
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
  add_camera(keys);
  add_picture(keys);
  return {std::move(keys), check_whole};
}

}  // namespace taut::app
