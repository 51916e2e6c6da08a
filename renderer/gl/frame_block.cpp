#include "renderer/gl/frame_block.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace taut::renderer {

namespace {

// Tangent of half the angle under which the key light is seen at penumbra 1: a large softbox. Larger gives
// softer shadows and needs more taps against noise.
constexpr float key_softness = 0.10F;
// Radius of the lit floor in units of the scene's radius. Smaller shows where the floor ends.
constexpr float floor_radius = 9.0F;
// Radius of the widest blur of a shadow, share of the map's side. Larger is softer far from what casts it,
// and needs more taps against noise.
constexpr float widest_blur = 40.0F / 2048.0F;
// Taps on the floor for one on a surface: the floor's shadow has a fourth of the pixels.
constexpr float floor_taps = 1.75F;
// Texels of the shadow map for a drawn pixel of the picture's shorter side. More is sharper than the picture
// can show.
constexpr float texels_for_pixel = 1.4F;
// Less shows as dots in narrow penumbrae, however small the picture.
constexpr int least_shadow_map_px = 1024;
// Reach of the floor's light texture beyond the scene's radius, share of the scene's height above the floor:
// a thing up high darkens a wider and fainter patch. Less cuts that patch off, more makes it coarser.
constexpr float light_reach = 1.5F;
// Extent of the backdrop's gradient above the middle of the picture, share of the field of view.
constexpr float gradient_extent = 0.65F;

glm::vec4 light(const glm::vec3& towards, float strength) {
  const float length = glm::length(towards);
  const glm::vec3 unit = length > 0.0F ? towards / length : glm::vec3{0.0F, 1.0F, 0.0F};
  return {unit, strength};
}

float radius_of(const Box& box) { return std::max(0.5F * glm::length(box.upper - box.lower), 1e-3F); }

glm::vec3 middle_of(const Box& box) { return 0.5F * (box.lower + box.upper); }

void set_shadow(FrameBlock& block, const Lighting& lighting, const PictureSettings& settings,
                const std::optional<Box>& casters, float most_bulge_m) {
  block.world_to_shadow = glm::mat4{1.0F};
  block.shadow = glm::vec4{1.0F, 1.0F, 1.0F, 0.0F};
  if (!casters || !settings.shadows) return;
  const glm::vec3 towards{block.towards_key};
  block.world_to_shadow = world_to_unit_cube(*casters, towards);
  const float side_m = 2.0F * radius_of(*casters);
  const auto texels = static_cast<float>(shadow_map_side(settings));
  const float tangent = std::max(lighting.penumbra, 0.0F) * key_softness;
  block.shadow = {side_m / texels, 1.0F / texels, side_m, std::max(tangent, 1e-5F)};
  const auto taps = static_cast<float>(settings.shadow_taps);
  block.shadow_blur = {widest_blur * texels, taps, floor_taps * taps, most_bulge_m};
}

void set_ground(FrameBlock& block, const FrameView& frame, const std::optional<Box>& casters) {
  const Box box = casters.value_or(Box{frame.camera.target - 1.0F, frame.camera.target + 1.0F});
  const glm::vec3 middle = middle_of(box);
  const float height = frame.ground_height_m.value_or(0.0F);
  const float radius = radius_of(box);
  block.ground = {middle.x, height, middle.z, floor_radius * radius};
  const float reach = radius + light_reach * std::max(middle.y - height, 0.0F);
  block.ground_light_area = {middle.x - reach, middle.z - reach, 0.5F / reach, 0.5F / reach};
}

glm::mat4 tile_of_clip(const PictureSettings& settings, const Tile& tile) {
  const auto width = static_cast<float>(settings.width_px);
  const auto height = static_cast<float>(settings.height_px);
  const auto tile_width = static_cast<float>(tile.width_px);
  const auto tile_height = static_cast<float>(tile.height_px);
  const glm::vec2 scale{width / tile_width, height / tile_height};
  const glm::vec2 centre{(2.0F * static_cast<float>(tile.x_px) + tile_width) / width - 1.0F,
                         1.0F - (2.0F * static_cast<float>(tile.y_px) + tile_height) / height};
  const glm::mat4 scaled = glm::scale(glm::mat4{1.0F}, glm::vec3{scale, 1.0F});
  return glm::translate(scaled, glm::vec3{-centre, 0.0F});
}

float aspect_of(const PictureSettings& settings) {
  return static_cast<float>(settings.width_px) / static_cast<float>(settings.height_px);
}

// Directions through a plane at distance 1 in front of the eye.
void set_rays(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile) {
  const glm::mat3 axes = glm::transpose(glm::mat3{camera.view()});
  const float half_height = std::tan(0.5F * camera.vertical_fov_rad);
  const float pixel = 2.0F * half_height / static_cast<float>(settings.height_px);
  const auto left = static_cast<float>(tile.x_px) - 0.5F * static_cast<float>(settings.width_px);
  const auto bottom = 0.5F * static_cast<float>(settings.height_px) - static_cast<float>(tile.y_px + tile.height_px);
  const auto scale = static_cast<float>(settings.supersampling);
  const float drawn_pixel = pixel / scale;
  block.ray_corner =
      glm::vec4{axes * glm::vec3{pixel * left, pixel * bottom, -1.0F}, scale * static_cast<float>(tile.x_px)};
  block.ray_across = glm::vec4{drawn_pixel * axes[0], scale * static_cast<float>(settings.width_px)};
  block.ray_up =
      glm::vec4{drawn_pixel * axes[1], scale * static_cast<float>(settings.height_px - tile.y_px - tile.height_px)};
}

}  // namespace

int shadow_map_side(const PictureSettings& settings) {
  const int drawn_px = settings.supersampling * std::min(settings.width_px, settings.height_px);
  int side_px = least_shadow_map_px;
  while (static_cast<float>(side_px) < texels_for_pixel * static_cast<float>(drawn_px)) side_px *= 2;
  return std::min(side_px, settings.shadow_map_px);
}

FrameBlock make_frame_block(const FrameView& frame, const PictureSettings& settings,
                            const std::optional<Box>& casters) {
  FrameBlock block{};
  const Lighting& lighting = frame.lighting;
  block.eye = glm::vec4{frame.camera.eye, 1.0F};
  block.towards_key = light(lighting.towards_key, lighting.key);
  block.towards_fill = light(lighting.towards_fill, lighting.fill);
  block.towards_rim = light(lighting.towards_rim, lighting.rim);
  const Backdrop& backdrop = frame.backdrop;
  const Colour white{1.0F};
  block.upper_colour = glm::vec4{linear_light(backdrop.transparent ? white : backdrop.upper_colour), lighting.ambient};
  block.lower_colour =
      glm::vec4{linear_light(backdrop.transparent ? white : backdrop.lower_colour), backdrop.plain ? 1.0F : 0.0F};
  float most_bulge_m = 0.0F;
  for (const SurfaceView& surface : frame.surfaces) {
    if (surface.refinement) most_bulge_m = std::max(most_bulge_m, surface.refinement->most_bulge_m);
  }
  set_shadow(block, lighting, settings, casters, most_bulge_m);
  set_ground(block, frame, casters);
  // The backdrop's gradient starts at the middle of the picture, wherever the camera points.
  const glm::vec3 forward = glm::normalize(frame.camera.target - frame.camera.eye);
  const float pitch = std::asin(std::clamp(forward.y, -1.0F, 1.0F));
  block.backdrop_horizon = {std::sin(pitch),
                            std::sin(std::min(pitch + gradient_extent * frame.camera.vertical_fov_rad, 1.57F)),
                            backdrop.transparent ? 1.0F : 0.0F, 0.0F};
  return block;
}

void set_shadow_bounds(FrameBlock& block, std::span<const SurfaceView* const> casters) {
  glm::vec2 lower{1.0F};
  glm::vec2 upper{0.0F};
  for (const SurfaceView* caster : casters) {
    for (const glm::vec3& position : caster->positions) {
      const glm::vec2 place{block.world_to_shadow * glm::vec4{position, 1.0F}};
      lower = glm::min(lower, place);
      upper = glm::max(upper, place);
    }
  }
  block.shadow_bounds = {lower, upper};
}

void set_tile(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile) {
  block.world_to_clip = tile_of_clip(settings, tile) * camera.projection(aspect_of(settings)) * camera.view();
  const auto scale = static_cast<float>(settings.supersampling);
  block.viewport = {static_cast<float>(tile.width_px) * scale, static_cast<float>(tile.height_px) * scale, scale,
                    static_cast<float>(settings.height_px) * scale};
  set_rays(block, camera, settings, tile);
}

glm::mat4 world_to_unit_cube(const Box& box, const glm::vec3& towards) {
  const float radius = radius_of(box) * 1.001F;
  const glm::vec3 middle = middle_of(box);
  const glm::vec3 up = std::abs(towards.y) < 0.99F ? glm::vec3{0.0F, 1.0F, 0.0F} : glm::vec3{0.0F, 0.0F, 1.0F};
  const glm::mat4 view = glm::lookAt(middle + towards * radius, middle, up);
  const glm::mat4 clip = glm::ortho(-radius, radius, -radius, radius, 0.0F, 2.0F * radius);
  const glm::mat4 halved = glm::translate(glm::mat4{1.0F}, glm::vec3{0.5F});
  return glm::scale(halved, glm::vec3{0.5F}) * clip * view;
}

}  // namespace taut::renderer
