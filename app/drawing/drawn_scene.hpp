#pragma once

#include "app/scene/scene_file.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// The camera of a scene's pictures.
struct CameraSettings {
  bool follow = false;  ///< moves with the garment, by as much as the mean of its vertices
  renderer::Framing framing = {.azimuth_rad = 0.35F, .elevation_rad = 0.17F, .vertical_fov_rad = 0.5F};
  std::optional<renderer::Box> box;  ///< what has to be in the picture, in metres; empty: the garment in all frames
  std::optional<glm::vec3> eye;      ///< in metres; with `target` it replaces framing
  std::optional<glm::vec3> target;   ///< in metres
};

/// How the cloth's surface is drawn.
enum class SurfaceLook {
  shaded,
  stretch,    ///< coloured by stretch
  wireframe,  ///< structural springs over a pale surface, which hides those behind it
};

/// Of what the stretch is shown as colours.
enum class StretchOf {
  springs,  ///< at each vertex the largest of the structural springs there
  surface,  ///< at each vertex the largest of the triangles there
};

/// Which springs are drawn over the surface.
enum class WhichSprings { none, structural, shear, flexural, all };

inline constexpr std::array all_which_springs = {WhichSprings::none, WhichSprings::structural, WhichSprings::shear,
                                                 WhichSprings::flexural, WhichSprings::all};

/// The background of a picture.
enum class BackgroundKind {
  studio,       ///< a floor that runs into a wall
  colour,       ///< one colour; shadows still fall on the floor
  transparent,  ///< an alpha channel; of the floor the shadows stay
};

/// The background of a picture.
struct Background {
  BackgroundKind kind = BackgroundKind::studio;
  renderer::Colour colour = renderer::rgb(0xFFFFFF);

  bool operator==(const Background&) const = default;
};

/// Where the floor of a picture is.
enum class GroundKind {
  automatic,  ///< on a level plane if there is one, else a little below all that is shown
  none,       ///< no floor
  fixed,      ///< at Ground::height_m
};

/// The floor of a picture.
struct Ground {
  GroundKind kind = GroundKind::automatic;
  double height_m = 0.0;
};

/// Means no texture, where PictureStyle::texture is this.
inline constexpr const char* no_texture = "none";

/// Whether this names an image.
inline bool names_image(const std::filesystem::path& texture) { return !texture.empty() && texture != no_texture; }

/// How much work a picture is.
enum class DrawingQuality {
  draft,   ///< one sample in a pixel, fewer directions of light
  normal,  ///< for the screen
  high,    ///< for print: twice as wide and high and averaged, finer light and surfaces
};

/// How a scene's pictures are drawn.
struct PictureStyle {
  DrawingQuality quality = DrawingQuality::normal;
  renderer::PictureSettings settings;
  SurfaceLook surface = SurfaceLook::shaded;
  bool wireframe = false;  ///< the springs drawn over the surface
  bool wrinkles = true;    ///< where cloth is shortened, those that the mesh is too coarse for
  bool smooth = true;      ///< a smooth surface along the vertices instead of the simulated triangles
  StretchOf stretch_of = StretchOf::surface;
  /// Stretch at the two ends of the colours; empty: shown_stretch_range().
  std::optional<std::array<double, 2>> stretch_range;
  renderer::ColourMap stretch_colours = renderer::ColourMap::viridis;  ///< not a key of the file
  renderer::SurfaceStyle cloth;
  std::filesystem::path texture;  ///< an image on the cloth; empty: the model's own colours; or no_texture
  Ground ground;
  Background background;
  WhichSprings springs = WhichSprings::none;
  bool rest_outline = false;  ///< draws the garment's borders where they were modelled
  bool show_pins = true;
  bool show_wind = false;  ///< as arrows
  bool legend = true;      ///< the colour bar, if the surface shows the stretch
};

/// A scene and how it is drawn: all that a scene file can say.
struct DrawnScene : Scene {
  CameraSettings camera;
  PictureStyle picture;
};

/// The stretch at the two ends of the colours. If the scene does not set it: from 0 to the solver's bound, or
/// to 0.05 if there is no bound.
std::array<double, 2> shown_stretch_range(const DrawnScene& scene);

/// The bound to be marked beside the colours: the solver's. Empty if it has none or does not hold what the
/// colours show.
std::optional<double> shown_bound(const DrawnScene& scene);

inline constexpr std::array all_stretch_of = {StretchOf::springs, StretchOf::surface};

/// The settings that the renderer draws with: those of the style at its quality.
renderer::PictureSettings settings_of(const PictureStyle& style);

/// Edges of the drawn surface that are shorter in the picture, in pixels, are not halved.
float shortest_edge_px(const PictureStyle& style);

/// The renderer's backdrop for this background.
renderer::Backdrop backdrop_of(const Background& background);

/// The names used in files.
const char* name_of(WhichSprings which);
const char* name_of(StretchOf shown);

/// The title of the colours' legend.
const char* legend_title(StretchOf shown);

template <class S> struct SceneFormat;

/// All keys of a scene file, those of the picture included.
SceneFormat<DrawnScene> drawn_scene_format();

// The functions of scene_format.hpp and scene_text.hpp for that format.

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides = {});
DrawnScene read_scene_text(const std::string& text, const std::string& name, std::span<const Override> overrides = {});
DrawnScene find_scene(const std::string& name, std::span<const Override> overrides);
void apply_overrides(std::span<const Override> overrides, DrawnScene& scene);
/// As that of a Scene, and the image that is printed on the cloth.
std::vector<std::filesystem::path> input_files(const DrawnScene& scene);
/// Throws UsageError if an output is a file that the scene was read from, or one of `read`, which its garment was made of.
void require_inputs_kept(const std::vector<std::filesystem::path>& outputs, const DrawnScene& scene,
                         const std::vector<std::filesystem::path>& read);
/// As that of a Scene, but drawn without balls at its pins.
void set_garment(const std::filesystem::path& file, DrawnScene& scene);
nlohmann::ordered_json scene_settings(const DrawnScene& scene);
std::string scene_text(const DrawnScene& scene, GarmentNaming naming = GarmentNaming::in_assets);

/// All keys with unit, default, range and meaning, as text for people.
std::string scene_help();

/// From where a scene is seen. Angles as those of camera.azimuth and camera.elevation, in degrees.
struct Side {
  const char* name;
  double azimuth_deg;
  double elevation_deg;
};

/// The sides that have a name. The window has keys for the first four.
inline constexpr std::array<Side, 6> sides = {{{"front", 0.0, 5.0},
                                               {"side", 90.0, 5.0},
                                               {"back", 180.0, 5.0},
                                               {"three-quarter", 38.0, 15.0},
                                               {"left", -90.0, 5.0},
                                               {"top", 0.0, 85.0}}};

}  // namespace taut::app
