#pragma once

#include <optional>
#include <string>

#include "app/scene/model_units.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// How a model is brought into the scene, which is in metres with y up.
struct Placement {
  double scale = 1.0;   ///< metres in the file's unit
  double extent = 0.0;  ///< the largest along an axis, in the file's unit
  ModelAxis up = ModelAxis::y;
  sim::Vec3 moved_m = {0.0, 0.0, 0.0};  ///< after turning; only for models very far from the origin
  std::string unit_text;                ///< which unit it is, and how that is known
  std::string up_text;                  ///< which direction is up, and how that is known
  bool guessed = false;                 ///< unit or axis, and not what they are by default

  sim::Vec3 operator()(const sim::Vec3& in_file) const;
};

/// What is known about a model before it is placed.
struct PlacementHints {
  std::optional<double> asked_scale;
  std::optional<ModelAxis> asked_up;
  std::optional<double> metres_per_unit;  ///< the file's own
  std::optional<ModelAxis> up;            ///< the file's own
};

/// The unit that was asked for, or the file's own where it makes something between a glove and a tent, or
/// else the first of metre, centimetre, millimetre and decimetre that makes a garment of 0.2 to 2.5 m; where
/// none does, it is made 1 m large. Likewise the axis: y unless the model is far longer along z. Far from the
/// origin, where single precision would not tell its vertices apart, it is moved there.
Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints);

}  // namespace taut::app
