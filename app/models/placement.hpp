#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// How a model is transformed into the scene, which is in metres with y up.
struct Placement {
  double scale = 1.0;           ///< metres per unit of the file
  double extent = 0.0;          ///< largest size along an axis, in the file's unit
  ModelAxis up = ModelAxis::y;  ///< direction of the file that becomes +y
  /// Added after scaling and turning. Zero unless the model is very far from the origin.
  sim::Vec3 moved_m = {0.0, 0.0, 0.0};
  std::string unit_text;  ///< the unit and how it is known, for people
  std::string up_text;    ///< the up direction and how it is known, for people
  bool guessed = false;   ///< the unit or the axis was guessed and is not the default
  bool is_vast = false;   ///< larger than any garment, because the file or the user says so

  /// Transforms a point of the file into the scene, in metres.
  sim::Vec3 operator()(const sim::Vec3& in_file) const;
};

/// Facts about unit and axis before the model is placed. Empty members are guessed.
struct PlacementHints {
  std::optional<double> asked_scale;             ///< by the user, metres per unit
  std::optional<ModelAxis> asked_up;             ///< by the user
  std::optional<double> metres_per_unit;         ///< from the file
  std::optional<ModelAxis> up;                   ///< from the file
  std::optional<ModelAxis> up_by_openings = {};  ///< from up_by_openings(), for want of anything better
  std::optional<ModelAxis> up_by_hanging = {};   ///< from up_by_hanging(), where openings do not say
};

/// Chooses the unit, in this order: the one asked for; the file's own, if the model is then larger than a
/// glove and smaller than a tent; the first of m, cm, mm and dm that gives a garment of 0.2 to 2.5 m. If none
/// does, the model is scaled to 1 m.
///
/// The up axis is the one asked for or the file's own; else what its openings say; else with which it moves less when
/// it is hung; else z if the model is far longer along z, else y. A model very far from the origin is moved there,
/// because single precision could not tell its vertices apart.
Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints);

/// Returns the model with this axis up: as y.
sim::Mesh upright(const sim::Mesh& mesh, ModelAxis up);

/// Returns the axis along which the model stands upright, by what could hold it: y or z if only one of them
/// has an opening at its top that carries most of the model; of a model that lies on its back -z if its
/// narrower opening is at that end. Empty if the openings do not say. Requires the adjacency of this mesh.
std::optional<ModelAxis> up_by_openings(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

}  // namespace taut::app
