#pragma once

#include "app/scene/scene_file.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// The camera of a scene's pictures.
struct CameraSettings {
  bool follow = false;  ///< moves with the mean of the garment's vertices
  renderer::Framing framing = {.azimuth_rad = 0.35F, .elevation_rad = 0.17F, .vertical_fov_rad = 0.5F};
  std::optional<renderer::Box> box;  ///< box in metres that the picture must show; empty: the garment in all frames
  std::optional<glm::vec3> eye;      ///< position in metres; replaces framing together with `target`
  std::optional<glm::vec3> target;   ///< position in metres
};

/// Look of the cloth's surface.
enum class SurfaceLook {
  shaded,
  stretch,    ///< coloured by stretch
  wireframe,  ///< structural springs over a pale surface, which hides the springs behind it
};

/// Measured elements whose stretch is shown as colours.
enum class StretchOf {
  springs,  ///< each vertex shows the largest stretch of its structural springs
  surface,  ///< each vertex shows the largest stretch of its triangles
};

/// Springs that are drawn over the surface.
enum class WhichSprings { none, structural, shear, flexural, all };

inline constexpr std::array all_which_springs = {WhichSprings::none, WhichSprings::structural, WhichSprings::shear,
                                                 WhichSprings::flexural, WhichSprings::all};

/// The background of a picture.
enum class BackgroundKind {
  studio,       ///< floor that curves up into a wall
  colour,       ///< one colour; shadows still fall on the floor
  transparent,  ///< transparent; only the floor's shadows are drawn
};

/// Background of a picture.
struct Background {
  BackgroundKind kind = BackgroundKind::studio;
  renderer::Colour colour = renderer::rgb(0xFFFFFF);

  bool operator==(const Background&) const = default;
};

/// Position of a picture's floor.
enum class GroundKind {
  automatic,  ///< level plane if there is one, else slightly below everything shown
  none,       ///< no floor
  fixed,      ///< Ground::height_m
};

/// Floor of a picture.
struct Ground {
  GroundKind kind = GroundKind::automatic;
  double height_m = 0.0;
};

/// Value of PictureStyle::texture for no texture.
inline constexpr const char* no_texture = "none";

/// Returns true if `texture` is an image file.
inline bool names_image(const std::filesystem::path& texture) { return !texture.empty() && texture != no_texture; }

/// Drawing effort of a picture.
enum class DrawingQuality {
  draft,   ///< one sample per pixel, fewer directions of light
  normal,  ///< for screens
  high,    ///< for print: doubled width and height, then averaged; finer light and surfaces
  final,   ///< mean of many passes, each with its own light: slow
};

/// Style of a scene's pictures.
struct PictureStyle {
  DrawingQuality quality = DrawingQuality::normal;
  int passes = 64;  ///< number of passes at the final quality
  renderer::PictureSettings settings;
  SurfaceLook surface = SurfaceLook::shaded;
  bool wireframe = false;  ///< draws the springs over the surface
  bool wrinkles = true;    ///< adds wrinkles that the mesh is too coarse for, where cloth is compressed
  bool smooth = true;      ///< draws a smooth surface through the vertices instead of the simulated triangles
  StretchOf stretch_of = StretchOf::surface;
  /// Stretch at the two ends of the colours; empty: automatic, see shown_stretch_range().
  std::optional<std::array<double, 2>> stretch_range;
  renderer::ColourMap stretch_colours = renderer::ColourMap::viridis;  ///< cannot be set in a file
  renderer::SurfaceStyle cloth;
  std::filesystem::path texture;  ///< image on the cloth; empty: the model's own colours; may be no_texture
  Ground ground;
  Background background;
  WhichSprings springs = WhichSprings::none;
  bool rest_outline = false;  ///< draws the garment's borders at rest
  bool show_pins = true;
  bool show_wind = false;  ///< draws arrows
  bool legend = true;      ///< draws the colour bar if the surface shows stretch
};

/// A scene and its drawing style: everything that a scene file can set.
struct DrawnScene : Scene {
  CameraSettings camera;
  PictureStyle picture;
};

/// Returns the stretch at the two ends of the colours. By default they show 0 to the solver's bound, or to 0.05 if
/// there is no bound.
std::array<double, 2> shown_stretch_range(const DrawnScene& scene);

/// Returns the solver's bound, to mark it beside the colours. Empty if there is none or if it bounds another measure
/// than the colours show.
std::optional<double> shown_bound(const DrawnScene& scene);

inline constexpr std::array all_stretch_of = {StretchOf::springs, StretchOf::surface};

/// Returns the renderer's settings for the style at its quality.
renderer::PictureSettings to_picture_settings(const PictureStyle& style);

/// Returns the length in pixels below which edges of the drawn surface are not halved.
float min_edge_px(const PictureStyle& style);

/// Returns the renderer's backdrop for this background.
renderer::Backdrop to_backdrop(const Background& background);

/// Returns the name that files use.
const char* to_name(WhichSprings which);
const char* to_name(StretchOf shown);

/// Returns the title of the colour bar.
const char* legend_title(StretchOf shown);

template <class S> struct SceneFormat;

/// Returns all keys of a scene file, including the keys of its pictures.
SceneFormat<DrawnScene> drawn_scene_format();

// The functions of scene_format.hpp and scene_text.hpp for that format:

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides = {});
DrawnScene read_scene_text(const std::string& text, const std::string& name, std::span<const Override> overrides = {});
DrawnScene find_scene(const std::string& name, std::span<const Override> overrides);
void apply_overrides(std::span<const Override> overrides, DrawnScene& scene);
/// Returns the input files of a Scene, and the image that is printed on the cloth.
std::vector<std::filesystem::path> input_files(const DrawnScene& scene);
/// Throws UsageError if an output is a file that the scene was read from, or one of `read`, from which its garment was
/// made.
void require_inputs_kept(const std::vector<std::filesystem::path>& outputs, const DrawnScene& scene,
                         const std::vector<std::filesystem::path>& read);
/// Sets the garment as for a Scene, and hides its pins.
void set_garment(const std::filesystem::path& file, DrawnScene& scene);
nlohmann::ordered_json scene_settings(const DrawnScene& scene);
std::string scene_text(const DrawnScene& scene, GarmentNaming naming = GarmentNaming::in_assets);

/// Returns a help text with all keys, their units, defaults, ranges and meanings.
std::string scene_help();

/// A direction to look from, as angles of camera.azimuth and camera.elevation in degrees.
struct ViewSide {
  const char* name;
  double azimuth_deg;
  double elevation_deg;
};

/// Named directions. The window has keys for the first four.
inline constexpr std::array<ViewSide, 6> sides = {{{"front", 0.0, 5.0},
                                                   {"side", 90.0, 5.0},
                                                   {"back", 180.0, 5.0},
                                                   {"three-quarter", 38.0, 15.0},
                                                   {"left", -90.0, 5.0},
                                                   {"top", 0.0, 85.0}}};

}  // namespace taut::app
