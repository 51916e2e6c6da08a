#pragma once

#include "app/base/progress.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "renderer/gl/picture_target.hpp"

namespace taut::app {

/// Drawing quality of the scene. The resolution is always the window's: with software rendering, enlarging a picture of
/// half the size costs as much as drawing the whole one.
struct PictureQuality {
  int samples = 4;           ///< per pixel
  int shadow_map_px = 2048;  ///< width and height of the shadow map
  int shadow_taps = 16;      ///< samples of the shadow map per pixel
  int sky_directions = 12;   ///< directions in which the sky's shadow is computed; 0: none
  int shading_px = 1;        ///< side of the squares that share one shading computation
  /// Edge length for GarmentPainter::look_from. The simulated edges of a T-shirt have 7 px in a small window.
  float min_edge_px = 12.0F;
  double cost = 1.0;  ///< cost of a whole frame, relative to the cheapest quality

  bool operator==(const PictureQuality&) const = default;
};

/// Qualities from best to cheapest, all with smooth outlines. The sky's shadow and the shadow map are reduced first,
/// then samples and the resolution of shading.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 16, 12, 1, 12, 2.9},
                                                                     {4, 1024, 16, 8, 1, 12, 2.7},
                                                                     {1, 1024, 8, 4, 2, 12, 1.7},
                                                                     {1, 512, 6, 4, 2, 24, 1.3},
                                                                     {1, 256, 6, 2, 2, 24, 1.1},
                                                                     {1, 256, 4, 0, 2, 24, 1.0}}};

/// Chooses the best quality that still allows 30 frames per second. If drawing takes processors away from the
/// simulation, it reduces the quality further, and finally the frame rate.
class QualityControl {
 public:
  /// Returns the index into picture_qualities for frames in which something moves.
  std::size_t level() const { return level_; }

  /// Returns how long the window must pause after a frame to leave processors to the simulation.
  double rest_ms() const { return rest_ms_; }

  /// Updates the quality after a frame that drew the scene. `given_up_ms`: simulated time that was given up meanwhile
  /// because no processor was free.
  void note(double frame_ms, double given_up_ms);

  static constexpr double max_ms = 32.0;  ///< duration above which the quality is reduced; slightly less than 1/30 s
  /// Longest pause after a frame. A longer one would make the window slower.
  static constexpr double max_rest_ms = 40.0;

 private:
  void go_to(std::size_t level);
  void note_simulation(double share_given_up);
  bool is_too_slow();
  bool can_afford_next_level() const;

  std::size_t level_ = 2;
  double mean_ms_ = 0.0;
  double given_up_ = 0.0;  ///< mean fraction of simulated time that was given up
  double rest_ms_ = 0.0;
  int frames_ = 0;                        ///< frames since the level changed
  int slow_frames_ = 0;                   ///< consecutive slow frames
  int trial_wait_frames_ = min_patience;  ///< frames that must be fast enough before a better level is tried
  bool is_trial_ = false;                 ///< the level is better than the one before and not yet proven

  static constexpr int min_patience = 90;
};

/// Line from the held vertex to the hand, in metres.
using HandThread = std::array<glm::vec3, 2>;

/// Returns the line between cloth and a hand that it cannot follow, because the cloth is pinned elsewhere or would have
/// to cross something. Empty if nothing is held or the cloth is as near as in the hand. `garment`: one of the garments
/// that the hand holds.
std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment, const ViewArea& area);

/// All that a picture of the window shows. It refers to its sources.
struct WindowView {
  const ViewerState& state;
  const UserInterface& interface;
  WindowLayout layout;
};

/// A garment in its scene and its area of the window. It refers to its sources.
struct GarmentSight {
  const ViewerState& state;
  const Snapshot& garment;
  ViewArea area;
  int left_px = 0;  ///< distance of the area from the window's left side
};

/// Picture of one garment in an OpenGL context.
class ScenePicture {
 public:
  /// The context must outlive the object. Throws renderer::ContextError or renderer::ShaderError.
  explicit ScenePicture(renderer::Context& context) : renderer_(context) {}

  /// Draws to the bottom of a framebuffer; 0 is the window. `level`: index into picture_qualities. An unchanged garment
  /// that was drawn at this level or a better one is only copied, unless `anew`. Returns true if it was drawn, which
  /// takes most of the time. Throws renderer::ContextError.
  bool draw(unsigned framebuffer, const GarmentSight& sight, std::size_t level, bool anew);

  /// Returns true if `draw` would give the same result as the last one.
  bool is_drawn(const GarmentSight& sight, std::size_t level) const { return is_drawn(look_of(sight), level); }

 private:
  // Inputs of a painter; see painted_as().
  using PaintedAs =
      std::tuple<std::shared_ptr<const LoadedScene>, std::shared_ptr<const std::vector<sim::Index>>, SurfaceLook,
                 StretchOf, std::array<double, 2>, std::string, bool, bool, WhichSprings, int>;
  // Inputs of the scene's picture; see look_of().
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

/// Draws the user interface in an OpenGL context. The panel has thousands of small triangles and changes in every
/// simulated frame, so it is kept as a picture that is renewed a few times per second.
class InterfacePicture {
 public:
  /// The context must outlive the object. Throws renderer::ContextError or renderer::ShaderError.
  explicit InterfacePicture(renderer::Context& context);

  /// Draws over a framebuffer of the window's size; 0 is the window. The panel may be `max_interval_s` old, but if
  /// `is_urgent`, as after input, it is up to date. Throws renderer::ContextError.
  void draw(unsigned framebuffer, const WindowView& window, bool is_urgent);

  /// Draws the legends over the framebuffer, without the kept panel.
  void draw_legends(unsigned framebuffer, const WindowView& window);

  /// Returns true if `overlay` was drawn last.
  bool is_drawn(const renderer::OverlayView& overlay) const;

  /// Maximum age of the panel's picture. A larger value saves drawing, but the panel's curves move less smoothly.
  static constexpr double max_interval_s = 0.2;

 private:
  bool take_letters(const UserInterface::Letters& letters);
  void draw_panel(const WindowLayout& layout, const renderer::OverlayView& panel);

  renderer::Context& context_;
  renderer::OverlayPass pass_;
  renderer::ColourTarget panel_target_;
  std::uint64_t letters_number_ = 0;
  std::uint64_t drawn_ = 0;       ///< hash of the overlay drawn last, including the panel
  std::uint64_t panel_look_ = 0;  ///< hash of the picture in `panel_target_`
  renderer::Resized panel_size_;  ///< window size of that picture
  Stopwatch since_panel_;
};

/// Everything of the viewer that needs an OpenGL context. It is made again if the context is lost.
class ViewerPicture {
 public:
  /// The context must outlive the object. Throws renderer::ContextError or renderer::ShaderError.
  explicit ViewerPicture(renderer::Context& context);

  /// Draws the scene and the user interface to a framebuffer of the window's size; 0 is the window. `level`: index into
  /// picture_qualities. `is_urgent`: see InterfacePicture::draw. Throws renderer::ContextError.
  void draw(unsigned framebuffer, const WindowView& window, std::size_t level, bool is_urgent);

  /// Returns the scene as `draw` shows it, with its legends and without the rest of the user interface. Call it before
  /// `draw`, because it uses the same framebuffer. Throws renderer::ContextError.
  renderer::Image picture(unsigned framebuffer, const WindowView& window, std::size_t level);

  /// Returns true if `draw` would give the same result as the last one.
  bool is_drawn(const WindowView& window, std::size_t level) const;

  /// Returns true if the last `draw`, or `picture` before it, drew the scene, which takes most of the time. An
  /// unchanged scene that was drawn at this level or a better one is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  bool draw_scenes(unsigned framebuffer, const WindowView& window, std::size_t level, bool anew);

  renderer::Context& context_;
  ScenePicture first_;
  std::optional<ScenePicture> second_;  ///< set while two garments are compared
  InterfacePicture interface_;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that the next `draw` shows
};

}  // namespace taut::app
