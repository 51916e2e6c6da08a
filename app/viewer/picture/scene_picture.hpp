#pragma once

#include "app/drawing/garment_painter.hpp"
#include "app/viewer/picture/picture_quality.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

/// From the held vertex to the hand, in metres.
using HandThread = std::array<glm::vec3, 2>;

/// The thread between cloth and a hand that it cannot follow, because it is held elsewhere or would have to
/// cross something. Empty if nothing is held, or if the two are so near to each other that the cloth is in
/// the hand. `garment` is one of those that the hand holds.
std::optional<HandThread> hand_thread(const ViewerState& state, const Snapshot& garment,
                                      const ViewArea& area);

/// Adds the thread to what is drawn: in front of everything, faint where surfaces hide it. `thread` must live
/// as long as `frame` is used.
void add_thread(const HandThread& thread, renderer::FrameView& frame);

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
  bool is_drawn(const GarmentSight& sight, std::size_t level) const {
    return is_drawn(look_of(sight), level);
  }

 private:
  // Inputs that a painter was made for, as painted_as() lists them.
  using PaintedAs =
      std::tuple<std::shared_ptr<const LoadedScene>, std::shared_ptr<const std::vector<sim::Index>>,
                 SurfaceLook, StretchOf, std::array<double, 2>, std::string, bool, ShownSprings, int>;
  // Inputs of the scene's picture, as look_of() lists them.
  using SceneLook = std::tuple<PaintedAs, std::shared_ptr<const sim::Checkpoint>, OrbitCamera, bool, bool,
                               std::optional<HandThread>, int, int>;

  static PaintedAs painted_as(const GarmentSight& sight);
  static SceneLook look_of(const GarmentSight& sight);
  bool is_drawn(const SceneLook& look, std::size_t level) const {
    return drawn_level_ <= level && look == drawn_look_;
  }
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

}  // namespace taut::app
