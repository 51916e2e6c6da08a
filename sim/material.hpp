#pragma once

namespace taut::sim {

/// The cloth in physical terms, which do not depend on how finely it is meshed.
struct Material {
  double areal_density_kg_per_m2 = 0.15;  ///< a light jersey; heavier cloth answers wind less
  /// Of `bounded`. A soft jersey; denim has about ten times that, and folds less.
  double bending_rigidity_n_m = 5e-6;
  /// Of `bounded`: of springs shorter than at rest. Less crumples sooner. See
  /// FrameReport::followed_compression_n_per_m.
  double compression_stiffness_n_per_m = 30.0;
  double thickness_m = 0.001;  ///< kept between cloth and colliders
  double friction = 0.3;       ///< Coulomb's coefficient, on colliders that have none of their own

  bool operator==(const Material&) const = default;
};

}  // namespace taut::sim
