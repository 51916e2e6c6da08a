#include "renderer/light/light_maps.hpp"

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
  const auto pairs = static_cast<int>(sky_pairs_of_pass);
  for (int i = 0; i < pairs; ++i) {
    // Pairs of one pass are far apart, so that each pass has some light from above and from the sides.
    const float y = (static_cast<float>(i * count + index) + 0.5F) / static_cast<float>(pairs * count);
    const glm::vec2 flat = std::sqrt(1.0F - y * y) * direction_at(recurrence(i * count + index, 4));
    sample.towards_sky[static_cast<std::size_t>(i)] = {flat.x, y, flat.y};
  }
  return sample;
}

LightMaps::LightMaps(const GladGLContext& context)
    : gl_(&context), framebuffer_(context), compare_(context), plain_(context) {
  // Nothing reaches the maps' edges, so clamped samples are unoccluded.
  for (const Sampler* sampler : {&compare_, &plain_}) {
    const GLint filter = sampler == &compare_ ? GL_LINEAR : GL_NEAREST;
    gl_->SamplerParameteri(sampler->name(), GL_TEXTURE_MIN_FILTER, filter);
    gl_->SamplerParameteri(sampler->name(), GL_TEXTURE_MAG_FILTER, filter);
    gl_->SamplerParameteri(sampler->name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_->SamplerParameteri(sampler->name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  gl_->SamplerParameteri(compare_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_->SamplerParameteri(compare_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void LightMaps::resize(int layers, int side_px) {
  const glm::ivec2 shape{std::max(layers, 1), side_px};
  if (shape == shape_) return;
  shape_ = shape;
  maps_.emplace(*gl_);
  bind_texture(*gl_, sky_maps_unit, GL_TEXTURE_2D_ARRAY, *maps_);
  gl_->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, shape_.x, 0, GL_DEPTH_COMPONENT,
                  GL_FLOAT, nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
}

void LightMaps::begin(int layer) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->DrawBuffer(GL_NONE);
  gl_->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_->name(), 0, layer);
  gl_->Viewport(0, 0, shape_.y, shape_.y);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

void LightMaps::bind(unsigned unit, bool compares) const {
  bind_texture(*gl_, unit, GL_TEXTURE_2D_ARRAY, *maps_);
  gl_->BindSampler(unit, (compares ? compare_ : plain_).name());
}

}  // namespace taut::renderer
