#include "renderer/light/light_maps.hpp"

#include <glm/ext/matrix_transform.hpp>

namespace taut::renderer {
namespace {

// Returns the term `index` of an additive recurrence in one of five dimensions: its step is a power of the inverse of
// the root of x^6 = x + 1.
float recurrence(int index, int dimension) {
  constexpr double root = 1.1347241384015194;
  const double place = 0.5 + static_cast<double>(index + 1) * std::pow(root, -(dimension + 1));
  return static_cast<float>(place - std::floor(place));
}

glm::vec2 direction_at(float turn) {
  const float angle = 2.0F * std::numbers::pi_v<float> * turn;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

PassSample make_pass_sample(int index, int count) {
  PassSample sample;
  sample.pixel_offset = glm::vec2{recurrence(index, 0), recurrence(index, 1)} - 0.5F;
  sample.lamp_point = std::sqrt(recurrence(index, 2)) * direction_at(recurrence(index, 3));
  const auto pairs = static_cast<int>(sky_pair_count);
  for (int i = 0; i < pairs; ++i) {
    // Pairs of one pass are far apart, so that each pass has some light from above and from the sides.
    const float y = (static_cast<float>(i * count + index) + 0.5F) / static_cast<float>(pairs * count);
    const glm::vec2 flat = std::sqrt(1.0F - y * y) * direction_at(recurrence(i * count + index, 4));
    sample.towards_sky[static_cast<std::size_t>(i)] = {flat.x, y, flat.y};
  }
  return sample;
}

glm::mat4 light_view(const glm::mat4& world_to_map, bool lower) {
  const glm::mat4 centred = glm::translate(glm::mat4{1.0F}, {-1.0F, -1.0F, lower ? 1.0F : -1.0F});
  return glm::scale(centred, {2.0F, 2.0F, lower ? -2.0F : 2.0F}) * world_to_map;
}

LightMaps::LightMaps(const GladGLContext& context) : gl_(&context), framebuffer_(context), compare_(context) {
  set_comparing(*gl_, compare_, GL_LINEAR);
}

void LightMaps::begin(int layer, int side_px) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (side_px != side_px_) {
    maps_.emplace(*gl_);
    bind_texture(*gl_, light_maps_unit, GL_TEXTURE_2D_ARRAY, *maps_);
    gl_->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, layer_count, 0, GL_DEPTH_COMPONENT,
                    GL_FLOAT, nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl_->DrawBuffer(GL_NONE);
    side_px_ = side_px;
  }
  gl_->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_->name(), 0, layer);
  gl_->Viewport(0, 0, side_px, side_px);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

void LightMaps::bind() const {
  bind_texture(*gl_, light_maps_unit, GL_TEXTURE_2D_ARRAY, *maps_);
  gl_->BindSampler(light_maps_unit, compare_.name());
}

}  // namespace taut::renderer
