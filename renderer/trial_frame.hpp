#pragma once

#include <array>

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// A small sheet above a larger one and a floor: what it takes to draw them is what pictures of cloth take.
class TrialFrame {
 public:
  /// `numbers`: the sheets show scalars instead of cloth. The view is valid while this lives.
  FrameView view(bool numbers) const;
  /// The settings, but for what makes a picture large.
  static PictureSettings small(const PictureSettings& settings);

 private:
  std::array<glm::vec3, 8> positions{{{-1, 0, 1},
                                      {1, 0, 1},
                                      {1, 0, -1},
                                      {-1, 0, -1},
                                      {-0.5F, 0.5F, 0.5F},
                                      {0.5F, 0.5F, 0.5F},
                                      {0.5F, 0.5F, -0.5F},
                                      {-0.5F, 0.5F, -0.5F}}};
  std::array<glm::vec3, 8> normals{
      {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  std::array<std::uint32_t, 12> triangles{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
  std::array<float, 8> scalars{};
};

}  // namespace taut::renderer
