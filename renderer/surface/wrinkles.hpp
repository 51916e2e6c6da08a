#pragma once

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// Small folds of shortened cloth that the edges of its mesh are too long to show. Waves fixed in the material run
/// along the shortened direction; a slope of 2 sqrt(e) takes up the fraction e of a length. (Gillette and others 2015
/// and Chen and others 2021 add wrinkles from the same measure.)
class Wrinkles {
 public:
  /// Takes one vertex per position and three per triangle. `wavelength`: in the unit of positions.
  Wrinkles(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, float wavelength);

  /// Sets the vertices for heights: `fine_rest_positions` has the mesh's, then one for each of `parents`, as in
  /// RefinedMesh.
  void refine(std::span<const glm::vec3> fine_rest_positions, std::span<const VertexPair> parents);

  /// Returns the height of each fine vertex along its normal, for a mesh at these positions. Valid until the next call.
  std::span<const float> heights(std::span<const glm::vec3> positions);

 private:
  static constexpr std::size_t waves = 10;
  using PerWave = std::array<float, waves>;

  PerWave squared_slopes(std::size_t triangle, std::span<const glm::vec3> positions) const;
  void spread(std::vector<PerWave>& values) const;

  std::array<glm::vec3, waves> directions_;  ///< unit wave directions in the material
  std::vector<std::uint32_t> triangles_;
  /// Triangle at rest: `side_b` and `side_c` times a direction are its components along the two sides.
  struct RestTriangle {
    glm::vec3 side_b, side_c;
    float area;     ///< doubled area
    PerWave along;  ///< squared length of each wave direction in the plane; 0 if nearly normal to it
  };
  std::vector<RestTriangle> planes_;
  std::vector<VertexPair> edges_;
  std::vector<VertexPair> parents_;
  std::vector<PerWave> shapes_;  ///< wave heights at slope 1 by fine vertex
  std::vector<PerWave> slopes_;  ///< slopes by fine vertex
  std::vector<float> weights_, heights_;
  float wavelength_;
};

}  // namespace taut::renderer
