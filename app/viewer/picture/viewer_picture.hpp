#pragma once

#include "app/base/progress.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/drawing/picture_quality.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "renderer/gl/picture_target.hpp"

namespace taut::app {

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
