#pragma once

#include <memory>
#include <optional>

#include "app/drawing/garment_painter.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/picture/hand_thread.hpp"
#include "app/viewer/picture/interface_picture.hpp"
#include "app/viewer/picture/picture_quality.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

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
  renderer::Image picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                          std::size_t level, const UserInterface::Letters& letters,
                          const renderer::OverlayView& legends);

  /// Whether `draw` would give the same result as the last one.
  bool is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                const renderer::OverlayView& overlay) const;

  /// Whether the last `draw`, or the `picture` before it, drew the scene, which takes most of the time. A
  /// scene that did not change since it was drawn at the same or a better level is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  // What the scene's picture depends on.
  struct SceneLook {
    std::shared_ptr<const LoadedScene> loaded;
    std::shared_ptr<const std::vector<sim::Index>> pins;
    std::shared_ptr<const sim::Checkpoint> checkpoint;
    OrbitCamera camera;
    SurfaceLook surface = SurfaceLook::shaded;
    StretchOf stretch_of = StretchOf::springs;
    std::array<double, 2> stretch_range = {0.0, 0.0};
    std::string fabric;
    bool wireframe = false;
    bool shadows = true;
    ShownSprings springs;
    bool normals = false;
    std::optional<HandThread> thread;
    int width_px = 0;
    int height_px = 0;

    bool operator==(const SceneLook&) const = default;
  };

  SceneLook look_of(const ViewerState& state, const ViewArea& area) const;
  bool is_scene_drawn(const SceneLook& look, std::size_t level) const;
  void draw_scene(unsigned framebuffer, const ViewerState& state, const ViewArea& area,
                  const PictureQuality& quality, bool keep);
  GarmentPainter& painter_for(const ViewerState& state, const ViewArea& area);
  void add_normals(const ViewerState& state, renderer::FrameView& frame);

  // What a painter was made for.
  struct PaintedAs {
    std::shared_ptr<const LoadedScene> loaded;
    std::shared_ptr<const std::vector<sim::Index>> pins;
    SurfaceLook surface = SurfaceLook::shaded;
    StretchOf stretch_of = StretchOf::springs;
    std::array<double, 2> stretch_range = {0.0, 0.0};
    std::string fabric;
    bool wireframe = false;
    ShownSprings springs;
    int height_px = 0;

    bool operator==(const PaintedAs&) const = default;
  };

  renderer::Context& context_;
  renderer::SceneRenderer scene_renderer_;
  InterfacePicture interface_;
  std::optional<SceneLook> drawn_look_;
  bool is_kept_ = false;  ///< the renderer still has the picture and can copy it
  std::size_t drawn_level_ = 0;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that the next `draw` shows
  PaintedAs painted_as_;
  std::optional<GarmentPainter> painter_;
  std::vector<glm::vec3> normal_points_;
  std::optional<HandThread> thread_;
};

}  // namespace taut::app
