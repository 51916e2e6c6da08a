#pragma once

#include <array>

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// A frame whose picture needs every shader that pictures of cloth need: a small sheet above a larger one and
/// a floor. Drawn once to compile them.
class WarmUpFrame {
 public:
  /// Returns the frame, valid while this object lives. `scalars`: the sheets show scalars instead of cloth.
  FrameView view(bool scalars) const;
  /// Returns the settings for a small and quick picture with the same shaders.
  static PictureSettings small(const PictureSettings& settings);

 private:
  std::array<glm::vec3, 8> positions_{{{-1, 0, 1},
                                       {1, 0, 1},
                                       {1, 0, -1},
                                       {-1, 0, -1},
                                       {-0.5F, 0.5F, 0.5F},
                                       {0.5F, 0.5F, 0.5F},
                                       {0.5F, 0.5F, -0.5F},
                                       {-0.5F, 0.5F, -0.5F}}};
  std::array<glm::vec3, 8> normals_{
      {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  std::array<std::uint32_t, 12> triangles_{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
  std::array<float, 8> scalars_{};
};

}  // namespace taut::renderer
