#include "renderer/scene_renderer.hpp"

#include "renderer/light/studio_light.hpp"
#include "renderer/passes/backdrop_pass.hpp"
#include "renderer/passes/mark_pass.hpp"
#include "renderer/passes/sampling_pass.hpp"
#include "renderer/passes/surface_pass.hpp"

namespace taut::renderer {

namespace {

bool sees_floor(const FrameView& frame) {
  return frame.ground_height_m && !frame.backdrop.plain && frame.camera.eye.y > *frame.ground_height_m;
}

bool has_marks(const FrameView& frame) {
  return !frame.lines.empty() || !frame.points.empty() ||
         std::ranges::any_of(frame.surfaces, [](const SurfaceView& surface) { return surface.wireframe.has_value(); });
}

// Blended light has to be encoded after blending, which only the renderer's own target ensures.
bool is_blended(const FrameView& frame, const PictureSettings& settings) {
  return settings.samples > 1 || settings.supersampling > 1 || settings.passes > 1 || has_marks(frame);
}

BackdropGrid choose_grid(const PictureSettings& settings) {
  if (settings.samples > 1) return BackdropGrid::fine;
  return settings.shading_px > 1 ? BackdropGrid::coarsest : BackdropGrid::coarse;
}

// Returns the colour of a plain backdrop in linear light, premultiplied.
glm::vec4 plain_colour(const Backdrop& backdrop) {
  return backdrop.transparent ? glm::vec4{0.0F} : glm::vec4{linear_light(backdrop.lower_colour), 1.0F};
}

// OpenGL counts pixel rows from the bottom.
PixelRect tile_rect(const Tile& tile, const PictureSettings& settings) {
  return {tile.x_px, settings.height_px - tile.y_px - tile.height_px, tile.width_px, tile.height_px};
}

// Returns the tiles of an area that fit into the visibility buffer.
std::vector<Tile> split_tiles(const Tile& area, int supersampling) {
  const int side_px = VisibilityBuffer::max_side_px / supersampling;
  std::vector<Tile> tiles;
  for (int y = 0; y < area.height_px; y += side_px) {
    for (int x = 0; x < area.width_px; x += side_px) {
      tiles.push_back(
          {area.x_px + x, area.y_px + y, std::min(side_px, area.width_px - x), std::min(side_px, area.height_px - y)});
    }
  }
  return tiles;
}

}  // namespace

struct SceneRenderer::RendererResources {
  Context& context;
  const GladGLContext& gl;
  SurfacePass surface_pass;
  StudioLight light;
  BackdropPass backdrop_pass;
  MarkPass mark_pass;
  PictureTarget picture;
  VisibilityBuffer visibility;
  ResolvePass resolve_pass;
  SamplingPass sampling_pass;
  std::function<void(int, int)> report_pass;
  PictureTarget large;  // target of a supersampled tile
  Buffer block_buffer;
  std::vector<TriangleMesh> sphere_meshes;
  std::vector<SurfaceView> surfaces;  // surfaces of the frame and the sphere meshes

  explicit RendererResources(Context& made)
      : context(made),
        gl(made.gl()),
        surface_pass(gl),
        light(gl),
        backdrop_pass(gl),
        mark_pass(gl),
        picture(gl),
        visibility(gl),
        resolve_pass(gl),
        sampling_pass(gl),
        large(gl),
        block_buffer(gl) {
    check_errors(gl, "starting the renderer");
  }

  // Draws to `picture` if no framebuffer is given. A framebuffer requires a frame that is neither blended nor
  // supersampled.
  void draw(std::optional<GLuint> framebuffer, const FrameView& frame, const PictureSettings& settings) {
    check(frame, settings);
    context.make_current();
    FrameBlock block;
    begin(block, frame, settings);
    if (!framebuffer) picture.begin(settings.width_px, settings.height_px);
    if (settings.passes > 1) {
      draw_sampled(block, frame, settings);
    } else if (settings.supersampling > 1) {
      picture.clear();
      draw_supersampled(block, frame, settings);
    } else {
      draw_whole(framebuffer.value_or(picture.framebuffer()), block, frame, settings);
    }
    light.unbind();
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    check_errors(gl, "drawing a frame");
  }

  void begin(FrameBlock& block, const FrameView& frame, const PictureSettings& settings) {
    reset_state();
    sphere_meshes.clear();
    surfaces = frame.surfaces;
    sphere_meshes.reserve(frame.spheres.size());
    for (const SphereView& spheres : frame.spheres) {
      sphere_meshes.push_back(merged_spheres(spheres));
      surfaces.push_back(make_sphere_view(sphere_meshes.back(), spheres));
    }
    // Finer detail than that of coarse meshes does not show in the shadows of a single pass.
    std::vector<SurfaceView> casters = surfaces;
    if (settings.passes == 1) std::ranges::transform(surfaces, casters.begin(), coarse_surface);
    light.begin(block, frame, casters, settings);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, frame_block_binding, block_buffer.name());
    if (settings.passes == 1) {
      upload_block(block);
      light.draw_maps(block);
      gl.Flush();
    }
    surface_pass.upload(surfaces);
    if (settings.passes > 1) return;
    light.bind();
    light.gather(surface_pass.vertex_count());
  }

  // A user interface may share the context and leave its own settings behind.
  void reset_state() const {
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
    light.unbind();
  }

  void upload_tile(FrameBlock& block, const FrameView& frame, const PictureSettings& settings, const Tile& tile) const {
    set_tile(block, frame.camera, settings, tile);
    upload_block(block);
  }

  void upload_block(const FrameBlock& block) const {
    upload(gl, GL_UNIFORM_BUFFER, block_buffer, std::span<const FrameBlock>(&block, 1));
  }

  // Draws the background with one sample, as it has no edges, and blends only the part covered by surfaces and marks
  // over it with many samples.
  void draw_whole(GLuint framebuffer, FrameBlock& block, const FrameView& frame, const PictureSettings& settings) {
    const Tile whole{0, 0, settings.width_px, settings.height_px};
    upload_tile(block, frame, settings, whole);
    draw_behind(framebuffer, block, frame, settings);
    for (const Tile& tile : split_tiles(screen_bounds(frame, surfaces, block.world_to_clip, settings), 1)) {
      const PixelRect place = tile_rect(tile, settings);
      upload_tile(block, frame, settings, tile);
      draw_visibility(place, frame, settings);
      shade_surfaces_and_marks(framebuffer, place, frame, settings);
    }
  }

  // Averages the whole picture, as the floor's shadow is noise at the size of a drawn pixel.
  void draw_supersampled(FrameBlock& block, const FrameView& frame, const PictureSettings& settings) {
    const int factor = settings.supersampling;
    for (const Tile& tile : split_tiles({0, 0, settings.width_px, settings.height_px}, factor)) {
      const glm::ivec2 large_px = factor * glm::ivec2{tile.width_px, tile.height_px};
      upload_tile(block, frame, settings, tile);
      large.begin(large_px.x, large_px.y);
      draw_behind(large.framebuffer(), block, frame, settings);
      const PixelRect all{0, 0, large_px.x, large_px.y};
      draw_visibility(all, frame, settings);
      shade_surfaces_and_marks(large.framebuffer(), all, frame, settings);
      const PixelRect place = tile_rect(tile, settings);
      gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
      gl.Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
      resolve_pass.draw(large.texture(), 1, factor, {place.x_px, place.y_px});
    }
  }

  // Averages many passes, each with its own light.
  void draw_sampled(const FrameBlock& whole, const FrameView& frame, PictureSettings settings) {
    settings.samples = settings.supersampling = 1;
    const std::vector<Tile> tiles = split_tiles({0, 0, settings.width_px, settings.height_px}, 1);
    const int all = static_cast<int>(tiles.size()) * settings.passes;
    int done = 0;
    for (const Tile& tile : tiles) {
      sampling_pass.begin(tile.width_px, tile.height_px);
      if (frame.backdrop.plain) sampling_pass.set_behind(plain_colour(frame.backdrop), settings.passes);
      for (int i = 0; i < settings.passes; ++i) {
        add_pass(whole, frame, settings, tile, make_pass_sample(i, settings.passes));
        if (report_pass) report_pass(++done, all);
      }
      sampling_pass.develop(picture.framebuffer(), tile_rect(tile, settings), settings.passes,
                            surface_pass.has_data_colours());
    }
  }

  void add_pass(FrameBlock block, const FrameView& frame, const PictureSettings& settings, const Tile& tile,
                const PassSample& sample) {
    light.turn(block, sample);
    block.sky_floor.x = sees_floor(frame) ? 1.0F : 0.0F;
    set_tile(block, frame.camera, settings, tile, sample.pixel_offset);
    upload_block(block);
    light.draw_maps(block);
    light.bind();
    const PixelRect place{0, 0, tile.width_px, tile.height_px};
    if (!frame.backdrop.plain) sampling_pass.add_backdrop();
    draw_visibility(place, frame, settings);
    surface_pass.add_sampled(visibility, sampling_pass.surfaces(), place);
    if (!has_marks(frame)) return;
    visibility.begin_marks();
    draw_marks(frame);
    gl.BindFramebuffer(GL_FRAMEBUFFER, sampling_pass.marks());
    resolve_pass.add(visibility.marks());
  }

  void draw_behind(GLuint framebuffer, const FrameBlock& block, const FrameView& frame,
                   const PictureSettings& settings) {
    if (frame.backdrop.plain) {
      const Colour& colour = frame.backdrop.lower_colour;
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(0, 0, static_cast<GLint>(block.viewport.x), static_cast<GLint>(block.viewport.y));
      const float alpha = frame.backdrop.transparent ? 0.0F : 1.0F;
      gl.ClearColor(alpha * colour[0], alpha * colour[1], alpha * colour[2], alpha);
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.Disable(GL_SCISSOR_TEST);
      return;
    }
    backdrop_pass.draw(framebuffer, block, sees_floor(frame), choose_grid(settings));
  }

  // `place` is the tile's rectangle in the framebuffer.
  void draw_visibility(const PixelRect& place, const FrameView& frame, const PictureSettings& settings) {
    visibility.begin(place.width_px, place.height_px, settings.samples);
    if (sees_floor(frame) && reaches_below(*frame.ground_height_m, frame, surfaces)) backdrop_pass.draw_floor_depth();
    surface_pass.draw_visibility(has_marks(frame));
  }

  // Shades the surfaces of the last draw_visibility(). Marks have their own edges between pixels, so they are drawn
  // separately and blended over.
  void shade_surfaces_and_marks(GLuint framebuffer, const PixelRect& place, const FrameView& frame,
                                const PictureSettings& settings) {
    surface_pass.shade(visibility, framebuffer, place, settings.shading_px > 1);
    if (!has_marks(frame)) return;
    visibility.begin_marks();
    draw_marks(frame);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
    resolve_pass.draw(visibility.marks(), visibility.samples(), 1, {place.x_px, place.y_px});
  }

  // Marks are encoded by the framebuffer, as blending needs linear light. Opaque surfaces are encoded in their shader,
  // once per pixel instead of once per sample.
  void draw_marks(const FrameView& frame) {
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_FRAMEBUFFER_SRGB);
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
};

SceneRenderer::SceneRenderer(Context& context) {
  context.make_current();
  parts_ = std::make_unique<RendererResources>(context);
}

SceneRenderer::~SceneRenderer() { delete_in_context(parts_->context, parts_); }

// The picture of a ball above a larger one and a floor needs every shader that pictures of cloth need.
void SceneRenderer::prepare(const PictureSettings& settings, bool scalars) {
  const std::array balls{make_sphere({0.0F, 0.0F, 0.0F}, 1.0F, 16), make_sphere({0.0F, 1.6F, 0.0F}, 0.4F, 16)};
  const std::vector<float> values(balls[0].positions.size());
  FrameView frame;
  for (const TriangleMesh& ball : balls) {
    SurfaceView& surface = frame.surfaces.emplace_back();
    surface.positions = surface.material_coordinates = ball.positions;
    surface.normals = ball.normals;
    surface.triangles = ball.triangles;
    if (scalars) surface.scalars = ScalarColours{values};
  }
  frame.ground_height_m = -1.5F;
  frame.camera.eye = {0.0F, 3.0F, 6.0F};
  frame.camera.target = glm::vec3{0.0F};
  PictureSettings small = settings;
  small.width_px = small.height_px = 64;
  small.shadow_map_px = 256;
  small.passes = std::min(settings.passes, 2);
  small.sky_directions = std::min(settings.sky_directions, 2);
  draw_kept(frame, small);
}

Image SceneRenderer::draw(const FrameView& frame, const PictureSettings& settings) {
  draw_kept(frame, settings);
  return parts_->picture.read(frame.backdrop.transparent);
}

bool SceneRenderer::draw_to(unsigned framebuffer, const FrameView& frame, const PictureSettings& settings) {
  if (is_blended(frame, settings)) {
    draw_kept(frame, settings);
    show_kept(framebuffer, settings.width_px, settings.height_px);
    return true;
  }
  parts_->draw(framebuffer, frame, settings);
  return false;
}

void SceneRenderer::set_pass_report(std::function<void(int, int)> report) { parts_->report_pass = std::move(report); }

void SceneRenderer::draw_kept(const FrameView& frame, const PictureSettings& settings) {
  parts_->draw(std::nullopt, frame, settings);
}

void SceneRenderer::show_kept(unsigned framebuffer, int width_px, int height_px, int left_px) const {
  parts_->context.make_current();
  parts_->gl.Disable(GL_SCISSOR_TEST);
  parts_->picture.show(framebuffer, width_px, height_px, left_px);
  check_errors(parts_->gl, "showing the picture");
}

}  // namespace taut::renderer
