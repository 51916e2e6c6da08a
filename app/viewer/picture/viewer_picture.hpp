#pragma once

#include <memory>
#include <optional>

#include "app/drawing/garment_painter.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/picture/interface_picture.hpp"
#include "app/viewer/picture/picture_quality.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

/// Everything of the viewer that lives in an OpenGL context; made anew when the context is lost.
class ViewerPicture {
 public:
  /// The context has to outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit ViewerPicture(renderer::Context& context);

  /// Draws the scene and the user interface to a framebuffer of the layout's size (0: the window). `level` is
  /// one of picture_qualities. Unless it is urgent, the panel may be a little old. Throws
  /// renderer::ContextError.
  void draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
            const UserInterface::Letters& letters, const renderer::OverlayView& overlay, bool is_urgent);

  /// The scene as `draw` draws it, with its legends and nothing else of the user interface; draws to the same
  /// framebuffer, so it comes before `draw`. Throws renderer::ContextError.
  renderer::Image picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                          std::size_t level, const UserInterface::Letters& letters,
                          const renderer::OverlayView& legends);

  /// Whether `draw` would draw the same as before.
  bool is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                const renderer::OverlayView& overlay) const;

  /// Whether the last `draw`, or `picture` before it, drew the scene, which takes most of the time. A scene
  /// that has not changed since it was drawn and kept at least as well is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  // What the scene's picture depends on.
  struct SceneLook {
    std::shared_ptr<const LoadedScene> loaded;
    std::shared_ptr<const std::vector<sim::Index>> pins;
    std::shared_ptr<const sim::Checkpoint> checkpoint;
    OrbitCamera camera;
    SurfaceLook surface = SurfaceLook::shaded;
    std::array<double, 2> stretch_range = {0.0, 0.0};
    bool wireframe = false;
    bool shadows = true;
    bool springs = false;
    bool normals = false;
    int width_px = 0;
    int height_px = 0;

    bool operator==(const SceneLook&) const = default;
  };

  SceneLook look_of(const ViewerState& state, const ViewArea& area) const;
  bool is_scene_drawn(const SceneLook& look, std::size_t level) const;
  void draw_scene(unsigned framebuffer, const ViewerState& state, const ViewArea& area,
                  const PictureQuality& quality, bool keep);
  GarmentPainter& painter_for(const ViewerState& state, const ViewArea& area);
  void add_springs(const ViewerState& state, renderer::FrameView& frame);
  void add_normals(const ViewerState& state, renderer::FrameView& frame);

  // What a painter was made for.
  struct PaintedAs {
    std::shared_ptr<const LoadedScene> loaded;
    std::shared_ptr<const std::vector<sim::Index>> pins;
    SurfaceLook surface = SurfaceLook::shaded;
    std::array<double, 2> stretch_range = {0.0, 0.0};
    bool wireframe = false;
    int height_px = 0;

    bool operator==(const PaintedAs&) const = default;
  };

  renderer::Context& context_;
  renderer::SceneRenderer scene_renderer_;
  InterfacePicture interface_;
  std::optional<SceneLook> drawn_look_;
  bool is_kept_ = false;  ///< the renderer has what was drawn and can show it again
  std::size_t drawn_level_ = 0;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that `draw` is to show
  PaintedAs painted_as_;
  std::optional<GarmentPainter> painter_;
  std::array<std::vector<glm::vec3>, sim::all_spring_kinds.size()> spring_points_;
  std::vector<glm::vec3> normal_points_;
};

}  // namespace taut::app
