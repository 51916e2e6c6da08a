#pragma once

#include "app/base/progress.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "renderer/gl/picture_target.hpp"

namespace taut::app {

/// How well the scene is drawn. The resolution is always that of the window: with software rendering,
/// enlarging a picture of half the size costs as much as drawing the whole one.
struct PictureQuality {
  int samples = 4;           ///< per pixel
  int shadow_map_px = 2048;  ///< width and height of the shadow map
  int shadow_taps = 16;      ///< samples of the shadow map per pixel
  int sky_directions = 24;   ///< directions in which shadow from the sky is computed; 0: none
  int shading_px = 1;        ///< shading is computed once per square of this side
  /// As of GarmentPainter::look_from: the simulated edges of a T-shirt are 7 in a small window.
  float shortest_edge_px = 8.0F;
  double cost = 1.0;  ///< of a whole frame, relative to the cheapest quality

  bool operator==(const PictureQuality&) const = default;
};

/// From best to cheapest. First the sky's shadow and the size of the shadow map are reduced, then samples,
/// then the resolution of shading.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 16, 24, 1, 8, 2.9},
                                                                     {4, 1024, 16, 12, 1, 8, 2.6},
                                                                     {1, 1024, 8, 6, 1, 12, 1.5},
                                                                     {1, 512, 6, 6, 2, 24, 1.2},
                                                                     {1, 256, 6, 4, 2, 24, 1.1},
                                                                     {1, 256, 4, 0, 2, 24, 1.0}}};

/// Chooses the best quality that still allows 30 frames per second. If drawing takes processors away from the
/// simulation, quality is reduced further, and at last the frame rate.
class QualityControl {
 public:
  /// Index into picture_qualities, for frames in which something moves.
  std::size_t level() const { return level_; }

  /// How long the window has to pause after a frame, so that the simulation gets processors.
  double rest_ms() const { return rest_ms_; }

  /// Takes the duration of a frame in which the scene was drawn. Also takes the simulated time that was given
  /// up meanwhile because no processor was free.
  void note(double frame_ms, double given_up_ms);

  static constexpr double longest_ms = 32.0;  ///< longer frames reduce the quality; a little less than 1/30 s
  /// Longest pause after a frame; more would make the window slower.
  static constexpr double most_rest_ms = 40.0;

 private:
  void go_to(std::size_t level);
  void note_simulation(double share_given_up);
  bool is_too_slow();
  bool has_time_for_better() const;

  std::size_t level_ = 2;
  double mean_ms_ = 0.0;
  double given_up_ = 0.0;  ///< mean fraction of simulated time that was given up
  double rest_ms_ = 0.0;
  int frames_ = 0;                 ///< since the level changed
  int slow_frames_ = 0;            ///< in a row
  int patience_ = least_patience;  ///< frames that must be fast enough before a better level is tried
  bool is_trial_ = false;          ///< the level is better than the one before and not yet proven

  static constexpr int least_patience = 90;
};

/// From the held vertex to the hand, in metres.
using HandThread = std::array<glm::vec3, 2>;

/// The thread between cloth and a hand that it cannot follow, because it is held elsewhere or would have to
/// cross something. Empty if nothing is held, or if the two are so near to each other that the cloth is in
/// the hand. `garment` is one of those that the hand holds.
std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment, const ViewArea& area);

/// One garment in its surroundings, and where in the window it is drawn. Refers to what it was made of.
struct GarmentSight {
  const ViewerState& state;
  const Snapshot& garment;
  ViewArea area;
  int left_px = 0;  ///< of the area, from the left side of the window
};

/// The picture of one garment in an OpenGL context.
class ScenePicture {
 public:
  /// The context must outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit ScenePicture(renderer::Context& context) : renderer_(context) {}

  /// Draws to the bottom of a framebuffer; 0 is the window. `level` is an index into picture_qualities. A
  /// garment that did not change since it was drawn at the same or a better level is only copied, unless
  /// `anew`. Returns whether it was drawn, which takes most of the time. Throws renderer::ContextError.
  bool draw(unsigned framebuffer, const GarmentSight& sight, std::size_t level, bool anew);

  /// Whether `draw` would give the same result as the last one.
  bool is_drawn(const GarmentSight& sight, std::size_t level) const { return is_drawn(look_of(sight), level); }

 private:
  // Inputs that a painter was made for, as painted_as() lists them.
  using PaintedAs = std::tuple<std::shared_ptr<const LoadedScene>, std::shared_ptr<const std::vector<sim::Index>>,
                               SurfaceLook, StretchOf, std::array<double, 2>, std::string, bool, WhichSprings, int>;
  // Inputs of the scene's picture, as look_of() lists them.
  using SceneLook = std::tuple<PaintedAs, std::shared_ptr<const sim::Checkpoint>, OrbitCamera, bool, bool,
                               std::optional<HandThread>, int, int>;

  static PaintedAs painted_as(const GarmentSight& sight);
  static SceneLook look_of(const GarmentSight& sight);
  bool is_drawn(const SceneLook& look, std::size_t level) const { return drawn_level_ <= level && look == drawn_look_; }
  void draw_anew(unsigned framebuffer, const GarmentSight& sight, const PictureQuality& quality, bool keep);
  GarmentPainter& painter_for(const GarmentSight& sight);
  void add_normals(const Snapshot& garment, renderer::FrameView& frame);

  renderer::SceneRenderer renderer_;
  std::optional<SceneLook> drawn_look_;
  bool is_kept_ = false;  ///< the renderer still has the picture and can copy it
  std::size_t drawn_level_ = 0;
  PaintedAs painted_as_;
  std::optional<GarmentPainter> painter_;
  std::vector<glm::vec3> normal_points_;
  std::optional<HandThread> thread_;
};

/// Draws the user interface in an OpenGL context. The panel has thousands of small triangles and changes in
/// every simulated frame. Therefore it is kept as a picture, which is renewed a few times per second.
class InterfacePicture {
 public:
  /// The context must outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit InterfacePicture(renderer::Context& context);

  /// Draws over a framebuffer of the window's size; framebuffer 0 is the window. If `is_urgent`, as after
  /// input, the panel is up to date; else it may be `longest_s` old. Throws renderer::ContextError.
  void draw(unsigned framebuffer, const WindowLayout& layout, const UserInterface::Letters& letters,
            const renderer::OverlayView& overlay, bool is_urgent);

  /// Draws `overlay` over the framebuffer, without the kept panel.
  void draw_over(unsigned framebuffer, const WindowLayout& layout, const UserInterface::Letters& letters,
                 const renderer::OverlayView& overlay);

  /// Whether `overlay` is what was drawn last.
  bool is_drawn(const renderer::OverlayView& overlay) const;

  /// Largest age of the panel's picture. A larger value saves drawing, and the panel's curves move less
  /// smoothly.
  static constexpr double longest_s = 0.2;

 private:
  bool take_letters(const UserInterface::Letters& letters);
  void draw_panel(const WindowLayout& layout, const renderer::OverlayView& panel);

  renderer::Context& context_;
  renderer::OverlayPass pass_;
  renderer::ColourTarget panel_target_;
  std::uint64_t letters_number_ = 0;
  std::uint64_t drawn_ = 0;       ///< hash of what was drawn, the panel included
  std::uint64_t panel_look_ = 0;  ///< hash of what is in `panel_target_`
  renderer::Resized panel_size_;  ///< of the window that it was drawn for
  Stopwatch since_panel_;
};

/// Everything of the viewer that lives in an OpenGL context. It is made again if the context is lost.
class ViewerPicture {
 public:
  /// The context must outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit ViewerPicture(renderer::Context& context);

  /// Draws the scene and the user interface to a framebuffer of the window's size; framebuffer 0 is the
  /// window. `level` is an index into picture_qualities. `is_urgent` is as in InterfacePicture::draw. Throws
  /// renderer::ContextError.
  void draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
            const UserInterface::Letters& letters, const renderer::OverlayView& overlay, bool is_urgent);

  /// Returns the scene as `draw` shows it, with its legends and without the rest of the user interface. It
  /// uses the same framebuffer, so call it before `draw`. Throws renderer::ContextError.
  renderer::Image picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
                          const UserInterface::Letters& letters, const renderer::OverlayView& legends);

  /// Whether `draw` would give the same result as the last one.
  bool is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                const renderer::OverlayView& overlay) const;

  /// Whether the last `draw`, or the `picture` before it, drew the scene, which takes most of the time. A
  /// scene that did not change since it was drawn at the same or a better level is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  bool draw_scenes(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
                   bool anew);

  renderer::Context& context_;
  ScenePicture first_;
  std::optional<ScenePicture> second_;  ///< while two garments are compared
  InterfacePicture interface_;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that the next `draw` shows
};

}  // namespace taut::app
