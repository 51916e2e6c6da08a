#include <glm/geometric.hpp>

#include "renderer/frame_view.hpp"

namespace taut::renderer {

Lighting studio_lighting(const Camera& camera) {
  const glm::vec3 back = camera.eye - camera.target;
  // Lamps stand on the floor of the studio: they follow the camera around, not up and down.
  glm::vec3 towards{back.x, 0.0F, back.z};
  towards = glm::length(towards) > 1e-4F * glm::length(back) ? glm::normalize(towards) : glm::vec3{0, 0, 1};
  const glm::vec3 right{towards.z, 0.0F, -towards.x};
  const glm::vec3 up{0.0F, 1.0F, 0.0F};
  Lighting lighting;
  lighting.towards_key = -0.60F * right + 1.15F * up + 0.60F * towards;
  lighting.towards_fill = 0.95F * right + 0.30F * up + 0.55F * towards;
  lighting.towards_rim = 0.45F * right + 0.60F * up - 1.0F * towards;
  return lighting;
}

}  // namespace taut::renderer
