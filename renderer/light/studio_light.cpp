#include "renderer/light/studio_light.hpp"

#include <future>

#include "renderer/gl/shader.hpp"

namespace taut::renderer {

namespace {

void set_up(const GladGLContext& gl, const Sampler& sampler, GLint filter) {
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, filter);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, filter);
  // Nothing reaches the map's edge, so that clamping shows nothing in the way outside.
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
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
    if (surface.casts_shadow && !surface.triangles.empty()) casters.push_back(&surface);
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
    : gl_(&context), shadow_texture_(context), floor_texture_(context), compare_(context), plain_(context) {
  set_up(*gl_, compare_, GL_LINEAR);
  gl_->SamplerParameteri(compare_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_->SamplerParameteri(compare_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  set_up(*gl_, plain_, GL_NEAREST);
  gl_->BindTexture(GL_TEXTURE_2D, floor_texture_.name());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_LINEAR);
}

void StudioLight::begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
                        const PictureSettings& settings) {
  casters_ = casters_among(surfaces);
  casters_box_ = box_around(casters_);
  // A map of everything would show nothing of what is near.
  if (casters_box_ && !is_near(*casters_box_)) {
    casters_.clear();
    casters_box_.reset();
  }
  block = make_frame_block(frame, settings, casters_box_);
  if (!settings.shadows) casters_.clear();
  set_shadow_bounds(block, casters_);
  shadow_side_px_ = shadow_map_side(settings);
  sky_directions_ = settings.sky_directions;
  has_floor_ = frame.ground_height_m && !frame.backdrop.plain;
}

void StudioLight::draw_maps(const FrameBlock& block) {
  // The two look at the same casters and share nothing else.
  std::future<void> shadows = std::async(std::launch::async, [&] { draw_shadow_map(block); });
  sky_light_.draw_maps(casters_, casters_.empty() ? std::nullopt : casters_box_, sky_directions_);
  if (has_floor_) sky_light_.gather_floor(block.ground_light_area, block.ground.y, floor_light_);
  shadows.get();
  shadow_classifier_.set_shadow_map(shadow_map_, block);
}

void StudioLight::gather(const SurfaceView& surface, SurfaceLight& light) {
  shadow_classifier_.classify(surface, light.key);
  sky_light_.gather(surface, light.sky);
}

void StudioLight::draw_shadow_map(const FrameBlock& block) {
  shadow_map_.resize(shadow_side_px_);
  shadow_map_.clear();
  for (const SurfaceView* caster : casters_) {
    shadow_map_.draw(block.world_to_shadow, caster->positions, caster->triangles);
  }
}

void StudioLight::upload_shadow_map() {
  const int side_px = shadow_map_.side_px();
  bind_texture(*gl_, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture_);
  if (allocated_px_ != side_px) {
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, 0, GL_DEPTH_COMPONENT,
                    GL_FLOAT, nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    allocated_px_ = side_px;
    uploaded_ = {glm::ivec2{0}, glm::ivec2{side_px}};
  }
  const MapArea changed = united(uploaded_, shadow_map_.drawn());
  const glm::ivec2 size_px = changed.upper - changed.lower;
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, side_px);
  gl_->TexSubImage2D(GL_TEXTURE_2D, 0, changed.lower.x, changed.lower.y, size_px.x, size_px.y,
                     GL_DEPTH_COMPONENT, GL_FLOAT,
                     shadow_map_.depths().data() + changed.lower.y * side_px + changed.lower.x);
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  uploaded_ = shadow_map_.drawn();
}

void StudioLight::upload() {
  upload_shadow_map();
  if (!has_floor_) return;
  bind_texture(*gl_, ground_light_unit, GL_TEXTURE_2D, floor_texture_);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, SkyLight::floor_px, SkyLight::floor_px, 0, GL_RED, GL_FLOAT,
                  floor_light_.data());
}

void StudioLight::bind() const {
  bind_texture(*gl_, shadow_compare_unit, GL_TEXTURE_2D, shadow_texture_);
  bind_texture(*gl_, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture_);
  bind_texture(*gl_, ground_light_unit, GL_TEXTURE_2D, floor_texture_);
  gl_->BindSampler(shadow_compare_unit, compare_.name());
  gl_->BindSampler(shadow_depth_unit, plain_.name());
}

void StudioLight::unbind() const {
  for (unsigned unit = 0; unit < unit_count; ++unit) {
    gl_->BindSampler(unit, 0);
    gl_->ActiveTexture(GL_TEXTURE0 + unit);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
    gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    gl_->BindTexture(GL_TEXTURE_BUFFER, 0);
  }
  gl_->ActiveTexture(GL_TEXTURE0);
}

}  // namespace taut::renderer
