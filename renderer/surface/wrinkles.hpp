#pragma once

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// Small folds of cloth that is shorter in some direction than at rest, where the edges of its mesh are too long to
/// show them. Waves that are fixed in the material run along what is shortened; a slope of 2 sqrt(e) takes up the
/// share e of a length. (Gillette and others 2015 and Chen and others 2021 add wrinkles from the
/// same measure.)
class Wrinkles {
 public:
  /// One vertex per position, three per triangle. `wavelength`: in the unit of positions.
  Wrinkles(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, float wavelength);

  /// Says at which vertices heights are wanted: `fine_rest_positions` are those of the mesh and then one for each of
  /// `parents`, as RefinedMesh has them.
  void refine(std::span<const glm::vec3> fine_rest_positions, std::span<const VertexPair> parents);

  /// Returns how far each fine vertex is off along its normal, for a mesh at these positions. Valid until the next
  /// call.
  std::span<const float> heights(std::span<const glm::vec3> positions);

 private:
  static constexpr std::size_t waves = 10;
  using PerWave = std::array<float, waves>;

  PerWave squared_slopes_of(std::size_t triangle, std::span<const glm::vec3> positions) const;
  void spread(std::vector<PerWave>& values) const;

  std::array<glm::vec3, waves> ways_;  ///< of length 1, in the material
  std::vector<std::uint32_t> triangles_;
  /// A triangle at rest: `side_b` and `side_c` times a direction are its shares of the two sides.
  struct Plane {
    glm::vec3 side_b, side_c;
    float area;     ///< twice
    PerWave along;  ///< squared length of each wave's direction in the plane; 0 where it runs too much into it
  };
  std::vector<Plane> planes_;
  std::vector<VertexPair> edges_;
  std::vector<VertexPair> parents_;
  std::vector<PerWave> shapes_;  ///< by fine vertex, of a slope of 1
  std::vector<PerWave> slopes_;  ///< by fine vertex
  std::vector<float> weights_, heights_;
  float wavelength_;
};

}  // namespace taut::renderer
