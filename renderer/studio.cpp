#include "renderer/frame_view.hpp"

namespace taut::renderer {

namespace {

// Where the lamps stand, relative to the camera: x right, y up, z from the scene towards the camera. Higher
// makes shadows shorter, farther to the side shows more of the folds.
constexpr glm::vec3 key_lamp{-0.60F, 1.15F, 0.60F};
constexpr glm::vec3 fill_lamp{0.95F, 0.30F, 0.55F};
constexpr glm::vec3 rim_lamp{0.45F, 0.60F, -1.0F};

}  // namespace

const char* name_of(WeaveKind kind) {
  constexpr std::array names = {"knit", "plain", "twill", "satin"};
  return names[static_cast<std::size_t>(kind)];
}

Lighting studio_lighting(const Camera& camera) {
  const glm::vec3 back = camera.eye - camera.target;
  // Lamps stand on the floor of the studio: they follow the camera around, not up and down.
  glm::vec3 towards{back.x, 0.0F, back.z};
  towards = glm::length(towards) > 1e-4F * glm::length(back) ? glm::normalize(towards) : glm::vec3{0, 0, 1};
  const glm::vec3 right{towards.z, 0.0F, -towards.x};
  const glm::vec3 up{0.0F, 1.0F, 0.0F};
  Lighting lighting;
  const auto in_world = [&](const glm::vec3& lamp) {
    return lamp.x * right + lamp.y * up + lamp.z * towards;
  };
  lighting.towards_key = in_world(key_lamp);
  lighting.towards_fill = in_world(fill_lamp);
  lighting.towards_rim = in_world(rim_lamp);
  return lighting;
}

}  // namespace taut::renderer
