#pragma once

namespace taut::sim {

/// The settings of `implicit`. Bending takes the rigidity of the cloth's material.
struct ImplicitSettings {
  double stretch_n_per_m = 1000.0;  ///< along warp and weft; more stretches less and takes more iterations
  /// Against a change of the angle between warp and weft. At half of the above the cloth answers alike in all
  /// directions; less drapes more easily.
  double shear_n_per_m = 500.0;
  /// The damping of each stiffness, as a fraction of it per unit of time. More comes to rest sooner.
  double damping_s = 0.005;
  /// The residual at which the conjugate gradients stop, as a fraction of the first one. Less is more exact
  /// and takes more iterations.
  double tolerance = 1e-4;
  /// A time step in which a triangle's stretch along warp or weft changes by more is done again in two. Less
  /// takes shorter steps where much happens.
  double largest_stretch_change = 0.1;

  bool operator==(const ImplicitSettings&) const = default;
};

}  // namespace taut::sim
