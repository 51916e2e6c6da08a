#include "renderer/scene_renderer.hpp"

#include <algorithm>
#include <array>
#include <deque>

#include "renderer/bindings.hpp"
#include "renderer/colour_map_textures.hpp"
#include "renderer/frame_block.hpp"
#include "renderer/frame_check.hpp"
#include "renderer/ground_pass.hpp"
#include "renderer/key_decision.hpp"
#include "renderer/mark_pass.hpp"
#include "renderer/merged_spheres.hpp"
#include "renderer/picture_target.hpp"
#include "renderer/shadow_pass.hpp"
#include "renderer/sky_pass.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> shaded{"SHADED"};

std::optional<Box> box_around_casters(const std::vector<SurfaceView>& surfaces) {
  std::optional<Box> box;
  for (const SurfaceView& surface : surfaces) {
    if (!surface.casts_shadow || !surface.filled || surface.triangles.empty()) continue;
    const Box own = bounding_box(surface.positions);
    box = box ? united(*box, own) : own;
  }
  return box;
}

std::vector<Tile> tiles_of(const PictureSettings& settings) {
  const int side_px = PictureTarget::max_side_px / settings.supersampling;
  std::vector<Tile> tiles;
  for (int y = 0; y < settings.height_px; y += side_px) {
    for (int x = 0; x < settings.width_px; x += side_px) {
      tiles.push_back(
          {x, y, std::min(side_px, settings.width_px - x), std::min(side_px, settings.height_px - y)});
    }
  }
  return tiles;
}

}  // namespace

struct SceneRenderer::Parts {
  Context& context;
  const GladGLContext& gl;
  Program decided_surface;
  Program open_surface;
  Program backdrop;
  ShadowPass shadow_pass;
  SkyPass sky_pass;
  GroundPass ground_pass;
  MarkPass mark_pass;
  PictureTarget target;
  DepthSamplers samplers;
  Buffer block_buffer;
  VertexArray no_arrays;
  KeyDecision key_decision;
  ColourMapTextures colour_maps;
  std::deque<SurfaceBuffers> buffers;  // one for each surface, kept from frame to frame
  std::vector<SurfaceView> surfaces;   // those of the frame and the balls

  explicit Parts(Context& made);
  void draw_to(GLuint framebuffer, const FrameView& frame, const PictureSettings& settings, bool top_first);
  void reset_state() const;
  void collect_surfaces(const FrameView& frame, std::vector<TriangleMesh>& balls);
  void fill_buffers(const glm::vec3& eye);
  void prepare_light(FrameBlock& block, const std::optional<Box>& casters, const FrameView& frame,
                     const PictureSettings& settings);
  void bind_light() const;
  void unbind_light() const;
  void send(const FrameBlock& block) const;
  void draw_tile(const FrameBlock& block, const FrameView& frame, const PictureSettings& settings,
                 const Tile& tile);
  void draw_backdrop(const glm::mat4& to_direction) const;
  void use_surface_program(const Program& program, const SurfaceView& view) const;
  void draw_surfaces();
  void draw_marks(const FrameView& frame);
};

SceneRenderer::Parts::Parts(Context& made)
    : context(made),
      gl(made.gl()),
      decided_surface(gl, embedded_shaders(), "surface.vert", "surface.frag"),
      open_surface(gl, embedded_shaders(), "surface.vert", "surface.frag", shaded),
      backdrop(gl, embedded_shaders(), "fullscreen.vert", "backdrop.frag"),
      shadow_pass(gl, embedded_shaders()),
      sky_pass(gl, embedded_shaders()),
      ground_pass(gl, embedded_shaders()),
      mark_pass(gl, embedded_shaders()),
      target(gl, embedded_shaders()),
      samplers(gl),
      block_buffer(gl),
      no_arrays(gl),
      colour_maps(gl) {
  for (const Program* program : {&decided_surface, &open_surface, &backdrop}) bind_shared_inputs(*program);
  check_errors(gl, "starting the renderer");
}

// The context may be shared with a user interface that leaves its own settings behind.
void SceneRenderer::Parts::reset_state() const {
  for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL,
                           GL_FRAMEBUFFER_SRGB, GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART}) {
    gl.Disable(off);
  }
  gl.Enable(GL_MULTISAMPLE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearDepth(1.0);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  unbind_light();
}

void SceneRenderer::Parts::collect_surfaces(const FrameView& frame, std::vector<TriangleMesh>& balls) {
  surfaces = frame.surfaces;
  balls.reserve(frame.spheres.size());
  for (const SphereView& spheres : frame.spheres) {
    balls.push_back(merged_spheres(spheres));
    surfaces.push_back(view_of(balls.back(), spheres));
  }
}

void SceneRenderer::Parts::fill_buffers(const glm::vec3& eye) {
  std::vector<float> decided;
  while (buffers.size() < surfaces.size()) buffers.emplace_back(gl);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].filled) continue;
    key_decision.decide(surfaces[i], decided);
    buffers[i].fill(surfaces[i], decided, eye);
  }
}

void SceneRenderer::Parts::send(const FrameBlock& block) const {
  gl.BindBuffer(GL_UNIFORM_BUFFER, block_buffer.name());
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, frame_block_binding, block_buffer.name());
}

void SceneRenderer::Parts::prepare_light(FrameBlock& block, const std::optional<Box>& casters,
                                         const FrameView& frame, const PictureSettings& settings) {
  std::vector<const SurfaceView*> casting_views;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!settings.shadows || !surfaces[i].casts_shadow || !surfaces[i].filled) continue;
    casting_views.push_back(&surfaces[i]);
  }
  set_shadow_bounds(block, casting_views);
  key_decision.look(casting_views, block);
  fill_buffers(frame.camera.eye);
  std::vector<const SurfaceBuffers*> casting;
  for (const SurfaceView* view : casting_views) {
    casting.push_back(&buffers[static_cast<std::size_t>(view - surfaces.data())]);
  }
  shadow_pass.draw(casting, block.world_to_shadow, settings.shadow_map_px);
  sky_pass.draw_atlas(casting_views, settings.shadows ? casters : std::nullopt, settings.sky_directions);
  send(block);
  bind_light();
  if (frame.ground_height_m) sky_pass.draw_ground_light();
  bind_texture(gl, ground_light_unit, GL_TEXTURE_2D, sky_pass.ground_light());
}

void SceneRenderer::Parts::bind_light() const {
  bind_texture(gl, shadow_compare_unit, GL_TEXTURE_2D, shadow_pass.texture());
  bind_texture(gl, shadow_depth_unit, GL_TEXTURE_2D, shadow_pass.texture());
  bind_texture(gl, sky_atlas_unit, GL_TEXTURE_2D, sky_pass.atlas());
  gl.BindSampler(shadow_compare_unit, samplers.compare.name());
  gl.BindSampler(shadow_depth_unit, samplers.plain.name());
  gl.BindSampler(sky_atlas_unit, samplers.compare.name());
}

// Nothing may be read while it is drawn to, and what comes after must not meet these samplers.
void SceneRenderer::Parts::unbind_light() const {
  for (unsigned unit = 0; unit < unit_count; ++unit) {
    gl.BindSampler(unit, 0);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

void SceneRenderer::Parts::draw_backdrop(const glm::mat4& to_direction) const {
  // On the far plane and last: only where nothing else is.
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.DepthMask(GL_FALSE);
  backdrop.use();
  backdrop.set("clip_to_direction", to_direction);
  gl.BindVertexArray(no_arrays.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.DepthMask(GL_TRUE);
}

void SceneRenderer::Parts::use_surface_program(const Program& program, const SurfaceView& view) const {
  program.use();
  program.set("outside_colour", linear_light(view.style.outside_colour));
  program.set("inside_colour", linear_light(view.style.inside_colour));
  program.set("finish", glm::vec4{std::clamp(view.style.roughness, 0.05F, 1.0F), view.style.sheen,
                                  view.style.translucency, view.scalars ? 1.0F : 0.0F});
  const bool woven = !view.material_coordinates.empty() && !view.scalars;
  program.set("weave", glm::vec4{woven ? view.style.weave : 0.0F, 0.0F, 0.0F, 0.0F});
}

void SceneRenderer::Parts::draw_surfaces() {
  // Pushed back a little, more where slanted: wireframes lie on them.
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1.5F, 4.0F);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SurfaceView& view = surfaces[i];
    if (!view.filled) continue;
    bind_texture(gl, scalar_map_unit, GL_TEXTURE_2D,
                 colour_maps.get(view.scalars ? view.scalars->map : ColourMap::viridis));
    use_surface_program(decided_surface, view);
    buffers[i].draw_decided();
    use_surface_program(open_surface, view);
    buffers[i].draw_open();
  }
}

// Blending has to happen in linear light, so marks are encoded by the framebuffer. Everything opaque encodes
// in its shader: once for each pixel instead of once for each sample.
void SceneRenderer::Parts::draw_marks(const FrameView& frame) {
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  for (const SurfaceView& view : frame.surfaces) {
    if (view.wireframe) mark_pass.draw_wireframe(view.positions, *view.wireframe);
  }
  for (const LineView& lines : frame.lines) mark_pass.draw_lines(lines);
  for (const PointView& points : frame.points) mark_pass.draw_points(points);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.DepthMask(GL_TRUE);
}

void SceneRenderer::Parts::draw_tile(const FrameBlock& block, const FrameView& frame,
                                     const PictureSettings& settings, const Tile& tile) {
  send(block);
  target.begin(tile.width_px * settings.supersampling, tile.height_px * settings.supersampling,
               settings.samples);
  draw_surfaces();
  const bool above = frame.ground_height_m && frame.camera.eye.y > *frame.ground_height_m;
  if (above && !frame.backdrop.plain) ground_pass.draw(block);
  draw_backdrop(clip_to_direction(frame.camera, settings, tile));
  draw_marks(frame);
  gl.Disable(GL_DEPTH_TEST);
}

void SceneRenderer::Parts::draw_to(GLuint framebuffer, const FrameView& frame,
                                   const PictureSettings& settings, bool top_first) {
  reset_state();
  std::vector<TriangleMesh> balls;
  collect_surfaces(frame, balls);
  const std::optional<Box> casters = box_around_casters(surfaces);
  FrameBlock block = make_frame_block(frame, settings, casters);
  prepare_light(block, casters, frame, settings);
  for (const Tile& tile : tiles_of(settings)) {
    set_tile(block, frame.camera, settings, tile);
    gl.Enable(GL_DEPTH_TEST);
    draw_tile(block, frame, settings, tile);
    target.resolve(framebuffer, tile, settings.height_px, settings.supersampling, top_first);
  }
  unbind_light();
  gl.BindVertexArray(0);
  gl.UseProgram(0);
  check_errors(gl, "drawing a frame");
}

SceneRenderer::SceneRenderer(Context& context) {
  context.make_current();
  parts = std::make_unique<Parts>(context);
}

SceneRenderer::~SceneRenderer() {
  try {
    parts->context.make_current();
  } catch (const ContextError&) {
    // Deleting names without their context is undefined; they go when the process does.
    static_cast<void>(parts.release());
  }
}

Image SceneRenderer::draw(const FrameView& frame, const PictureSettings& settings) {
  check_frame(frame);
  check_settings(settings);
  parts->context.make_current();
  const GLuint framebuffer = parts->target.picture_framebuffer(settings.width_px, settings.height_px);
  parts->draw_to(framebuffer, frame, settings, true);
  return parts->target.read(settings.width_px, settings.height_px);
}

void SceneRenderer::draw_to(unsigned framebuffer, const FrameView& frame, const PictureSettings& settings) {
  check_frame(frame);
  check_settings(settings);
  parts->context.make_current();
  parts->draw_to(framebuffer, frame, settings, false);
}

}  // namespace taut::renderer
