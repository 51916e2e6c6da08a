#include "renderer/light/studio_light.hpp"

namespace taut::renderer {
namespace {

// Side of a map of the sky. Higher values keep finer folds dark but cost time.
constexpr int sky_map_px = 256;
// Blur of a direction's shadow on surfaces, texels of its map. Lower values show edges of single shadows, higher ones
// lose narrow folds.
constexpr float surface_blur_texels = 3.0F;
// Blur of a direction's shadow on the floor, in cones of a direction: above 1, so that neighbouring directions overlap.
// Lower values show single shadows, higher ones lose the contact.
constexpr float floor_blur = 1.5F;
// Side of the texture of the floor's light; the shaders have it too.
constexpr int floor_px = 56;

// Returns a direction of the upper hemisphere; all have equal areas along a spiral (Fibonacci lattice).
glm::vec3 upper_direction(int i, int count) {
  const float y = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
  const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / std::numbers::phi_v<float>;
  const float flat = std::sqrt(1.0F - y * y);
  return {flat * std::cos(turn), y, flat * std::sin(turn)};
}

// Returns the tangent of the half angle of one direction's cone, which has its share of the whole sphere.
float cone_tangent(int directions) {
  const float cosine = std::max(1.0F - 2.0F / static_cast<float>(directions), 0.3F);
  return std::sqrt(1.0F - cosine * cosine) / cosine;
}

std::optional<Box> box_around(std::span<const SurfaceView> casters) {
  std::optional<Box> box;
  for (const SurfaceView& caster : casters) {
    const Box own = bounding_box(caster.positions);
    box = box ? unite(*box, own) : own;
  }
  return box;
}

// Returns the mean of the casters' colours by their triangles, in linear light.
glm::vec3 mean_colour(std::span<const SurfaceView> casters) {
  glm::vec3 sum{0.0F};
  float triangles = 0.0F;
  for (const SurfaceView& caster : casters) {
    const auto own = static_cast<float>(caster.triangles.size());
    sum += own * linear_light(caster.style.outside_colour);
    triangles += own;
  }
  return sum / std::max(triangles, 1.0F);
}

}  // namespace

StudioLight::StudioLight(const GladGLContext& context)
    : gl_(&context),
      key_map_(context),
      sky_maps_(context),
      depth_(context, "caster.vert", "depth.frag"),
      vertex_program_(context, "fullscreen.vert", "vertex_light.frag"),
      floor_program_(context, "fullscreen.vert", "floor_light.frag"),
      vertex_light_(context, GL_RGBA16F, vertex_light_unit),
      floor_light_(context, GL_R16F, ground_light_unit),
      no_arrays_(context),
      caster_arrays_(context),
      caster_positions_(context),
      caster_corners_(context) {
  gl_->BindVertexArray(caster_arrays_.name());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, caster_corners_.name());
  set_attribute(*gl_, 0, caster_positions_, 3, 3, 0);
  gl_->BindVertexArray(0);
}

void StudioLight::begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
                        const PictureSettings& settings) {
  std::vector<SurfaceView> casters;
  std::ranges::copy_if(surfaces, std::back_inserter(casters),
                       [](const SurfaceView& surface) { return surface.casts_shadow && !surface.triangles.empty(); });
  casters_box_ = box_around(casters);
  // A map of extremely distant casters would resolve nothing near.
  if (casters_box_ && !is_near(*casters_box_)) casters_box_.reset();
  block = make_frame_block(frame, settings, casters_box_);
  if (!casters_box_ || !settings.shadows) casters.clear();
  set_shadow_bounds(block, casters);
  upload_casters(casters);
  key_side_px_ = shadow_map_side(settings);
  // The other directions of many passes smooth coarser maps.
  if (settings.passes > 1) key_side_px_ = key_side_px_ / 4 * 3;
  sky_side_px_ = settings.passes > 1 ? key_side_px_ : sky_map_px;
  has_floor_ = frame.ground_height_m && !frame.backdrop.plain;
  block.sky_floor = {0.0F, mean_colour(casters)};
  const int pairs = casters.empty() ? 0 : (settings.sky_directions + 1) / 2;
  std::vector<glm::vec3> directions;
  for (int i = 0; i < pairs; ++i) directions.push_back(upper_direction(i, pairs));
  set_sky(block, directions);
  block.sky_maps_shape.z = surface_blur_texels / static_cast<float>(sky_side_px_);
  block.sky_maps_shape.w = floor_blur * cone_tangent(std::max(2 * pairs, 2));
}

void StudioLight::upload_casters(std::span<const SurfaceView> casters) {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> corners;
  for (const SurfaceView& caster : casters) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), caster.positions.begin(), caster.positions.end());
    for (const std::uint32_t corner : caster.triangles) corners.push_back(first + corner);
  }
  gl_->BindVertexArray(caster_arrays_.name());
  taut::renderer::upload(*gl_, GL_ARRAY_BUFFER, caster_positions_, std::span<const glm::vec3>(positions));
  taut::renderer::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, caster_corners_, std::span<const std::uint32_t>(corners));
  corner_count_ = static_cast<GLsizei>(corners.size());
}

void StudioLight::set_sky(FrameBlock& block, std::span<const glm::vec3> directions) const {
  if (directions.empty()) return;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    block.towards_sky[i] = {directions[i], 0.0F};
    block.world_to_sky[i] = world_to_unit_cube(*casters_box_, directions[i]);
  }
  const float side_m = glm::length(casters_box_->upper - casters_box_->lower);
  block.sky_maps_shape = {directions.size(), side_m / static_cast<float>(sky_side_px_), 0.0F, 0.0F};
}

void StudioLight::turn(FrameBlock& block, const PassSample& sample) const {
  if (corner_count_ == 0) return;
  set_sky(block, sample.towards_sky);
  const glm::vec3 middle{block.towards_key};
  const glm::vec3 other = std::abs(middle.y) < 0.9F ? glm::vec3{0.0F, 1.0F, 0.0F} : glm::vec3{1.0F, 0.0F, 0.0F};
  const glm::vec3 across = glm::normalize(glm::cross(other, middle));
  const glm::vec2 point = block.shadow.w * sample.lamp_point;
  const glm::vec3 towards = glm::normalize(middle + point.x * across + point.y * glm::cross(middle, across));
  block.towards_key = {towards, block.towards_key.w};
  block.world_to_shadow = world_to_unit_cube(*casters_box_, towards);
}

void StudioLight::draw_maps(const FrameBlock& block) {
  const auto sky_layers = 2 * static_cast<int>(block.sky_maps_shape.x);
  key_map_.resize(1, key_side_px_);
  sky_maps_.resize(sky_layers, sky_side_px_);
  const Program& program = depth_.use();
  gl_->BindVertexArray(caster_arrays_.name());
  for (int layer = 0; layer <= sky_layers; ++layer) {
    layer == 0 ? key_map_.begin(0) : sky_maps_.begin(layer - 1);
    program.set("layer", layer);
    gl_->DrawElements(GL_TRIANGLES, corner_count_, GL_UNSIGNED_INT, nullptr);
  }
}

void StudioLight::gather(std::size_t vertex_count) {
  gl_->Disable(GL_DEPTH_TEST);
  gl_->BindVertexArray(no_arrays_.name());
  vertex_light_.begin({texels_per_row, static_cast<int>(vertex_count) / texels_per_row + 1});
  vertex_program_.use();
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  if (has_floor_) {
    floor_light_.begin({floor_px, floor_px});
    floor_program_.use();
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  }
  gl_->Enable(GL_DEPTH_TEST);
}

void StudioLight::bind() const {
  key_map_.bind(key_map_unit, true);
  key_map_.bind(key_depth_unit, false);
  sky_maps_.bind(sky_maps_unit, true);
  vertex_light_.bind();
  floor_light_.bind();
}

void StudioLight::unbind() const {
  for (unsigned unit = 0; unit < unit_count; ++unit) {
    gl_->BindSampler(unit, 0);
    gl_->ActiveTexture(GL_TEXTURE0 + unit);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
    gl_->BindTexture(GL_TEXTURE_2D_ARRAY, 0);
    gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  }
  gl_->ActiveTexture(GL_TEXTURE0);
}

}  // namespace taut::renderer
