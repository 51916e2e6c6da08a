#include "renderer/light/studio_light.hpp"

#include <future>
#include <glm/common.hpp>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

namespace {

void set_up(const GladGLContext& gl, const Sampler& sampler, GLint filter) {
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, filter);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, filter);
  // Nothing reaches the map's edge, so that clamping shows nothing in the way outside.
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void set_up_floor(const GladGLContext& gl, const Texture& texture) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    gl.TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

std::optional<Box> box_around(std::span<const SurfaceView* const> casters) {
  std::optional<Box> box;
  for (const SurfaceView* caster : casters) {
    const Box own = bounding_box(caster->positions);
    box = box ? united(*box, own) : own;
  }
  return box;
}

std::vector<const SurfaceView*> casters_among(std::span<const SurfaceView> surfaces) {
  std::vector<const SurfaceView*> casters;
  for (const SurfaceView& surface : surfaces) {
    if (surface.casts_shadow && surface.filled && !surface.triangles.empty()) casters.push_back(&surface);
  }
  return casters;
}

MapArea united(const MapArea& a, const MapArea& b) {
  if (a.lower == a.upper) return b;
  if (b.lower == b.upper) return a;
  return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

}  // namespace

StudioLight::StudioLight(const GladGLContext& context)
    : gl(&context), shadow_texture(context), floor_texture(context), compare(context), plain(context) {
  set_up(*gl, compare, GL_LINEAR);
  gl->SamplerParameteri(compare.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl->SamplerParameteri(compare.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  set_up(*gl, plain, GL_NEAREST);
  set_up_floor(*gl, floor_texture);
}

void StudioLight::begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
                        const PictureSettings& settings) {
  casters = casters_among(surfaces);
  casters_box = box_around(casters);
  // A map of everything would show nothing of what is near.
  if (casters_box && !is_near(*casters_box)) {
    casters.clear();
    casters_box.reset();
  }
  block = make_frame_block(frame, settings, casters_box);
  if (!settings.shadows) casters.clear();
  set_shadow_bounds(block, casters);
  shadow_side_px = shadow_map_side(settings);
  sky_directions = settings.sky_directions;
  has_floor = frame.ground_height_m && !frame.backdrop.plain;
}

void StudioLight::look(const FrameBlock& block) {
  // The two look at the same casters and share nothing else.
  std::future<void> shadows = std::async(std::launch::async, [&] { draw_shadow_map(block); });
  sky_light.look(casters, casters.empty() ? std::nullopt : casters_box, sky_directions);
  if (has_floor) sky_light.gather_floor(block.ground_light_area, block.ground.y, floor_light);
  shadows.get();
  key_decision.look(shadow_map, block);
}

void StudioLight::gather(const SurfaceView& surface, SurfaceLight& light) {
  key_decision.decide(surface, light.key);
  sky_light.gather(surface, light.sky);
}

void StudioLight::draw_shadow_map(const FrameBlock& block) {
  shadow_map.resize(shadow_side_px);
  shadow_map.clear();
  for (const SurfaceView* caster : casters) {
    shadow_map.draw(block.world_to_shadow, caster->positions, caster->triangles);
  }
}

void StudioLight::upload_shadow_map() {
  const int side_px = shadow_map.side_px();
  bind_texture(*gl, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture);
  if (allocated_px != side_px) {
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   nullptr);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    allocated_px = side_px;
    uploaded = {glm::ivec2{0}, glm::ivec2{side_px}};
  }
  const MapArea changed = united(uploaded, shadow_map.drawn());
  const glm::ivec2 size_px = changed.upper - changed.lower;
  gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl->PixelStorei(GL_UNPACK_ROW_LENGTH, side_px);
  gl->TexSubImage2D(GL_TEXTURE_2D, 0, changed.lower.x, changed.lower.y, size_px.x, size_px.y,
                    GL_DEPTH_COMPONENT, GL_FLOAT,
                    shadow_map.depths().data() + changed.lower.y * side_px + changed.lower.x);
  gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  uploaded = shadow_map.drawn();
}

void StudioLight::upload() {
  upload_shadow_map();
  if (!has_floor) return;
  bind_texture(*gl, ground_light_unit, GL_TEXTURE_2D, floor_texture);
  gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, SkyLight::floor_px, SkyLight::floor_px, 0, GL_RED, GL_FLOAT,
                 floor_light.data());
}

void StudioLight::bind() const {
  bind_texture(*gl, shadow_compare_unit, GL_TEXTURE_2D, shadow_texture);
  bind_texture(*gl, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture);
  bind_texture(*gl, ground_light_unit, GL_TEXTURE_2D, floor_texture);
  gl->BindSampler(shadow_compare_unit, compare.name());
  gl->BindSampler(shadow_depth_unit, plain.name());
}

void StudioLight::unbind() const {
  for (unsigned unit = 0; unit < unit_count; ++unit) {
    gl->BindSampler(unit, 0);
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    gl->BindTexture(GL_TEXTURE_BUFFER, 0);
  }
  gl->ActiveTexture(GL_TEXTURE0);
}

}  // namespace taut::renderer
