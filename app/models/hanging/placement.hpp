#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// Transform of a model into the scene, which is in metres with y up.
struct Placement {
  double scale = 1.0;           ///< metres per unit of the file
  double extent = 0.0;          ///< largest size along an axis, in the file's unit
  ModelAxis up = ModelAxis::y;  ///< direction of the file that becomes +y
  /// Offset after scaling and turning. It is zero unless the model is very far from the origin.
  sim::Vec3 moved_m = {0.0, 0.0, 0.0};
  std::string unit_text;  ///< unit and its source, for people
  std::string up_text;    ///< up direction and its source, for people
  bool guessed = false;   ///< true if the unit or the axis was guessed and is not the default
  bool is_vast = false;   ///< true if it is larger than any garment, because the file or the user says so

  /// Transforms a point of the file into the scene, in metres.
  sim::Vec3 operator()(const sim::Vec3& in_file) const;
};

/// Facts about unit and axis before the model is placed. Empty members are guessed.
struct PlacementHints {
  std::optional<double> asked_scale;             ///< metres per unit, set by the user
  std::optional<ModelAxis> asked_up;             ///< axis set by the user
  std::optional<double> metres_per_unit;         ///< unit in the file
  std::optional<ModelAxis> up;                   ///< axis in the file
  std::optional<ModelAxis> up_by_openings = {};  ///< result of up_by_openings(), for want of anything better
  std::optional<ModelAxis> up_by_hanging = {};   ///< result of up_by_hanging(), if openings do not say
};

/// Chooses the unit, in this order: the user's; the file's own, if the model is then larger than a glove and smaller
/// than a tent; the likeliest of all that give a garment of 0.1 to 2.5 m, by how many files are in it, and by how near
/// the model's size and its narrowest opening, or the area of a hat, a sock or a glove, then are to a grown-up's garments.
/// A second unit that is nearly as likely is named too. If there is none, the model is scaled to 1 m. Throws
/// std::invalid_argument as sim::weld_and_validate does, if it guesses the unit.
Placement choose_unit(const sim::Mesh& mesh, const PlacementHints& hints);

/// Chooses the up axis, in this order: the user's; the file's own; the axis by its openings; the axis with which it
/// moves less when it is hung; z if the model is far longer along z; y. A model very far from the origin is moved
/// there, because single precision could not resolve its vertices. Requires a placement with the unit.
void choose_up(const sim::Mesh& mesh, const PlacementHints& hints, Placement& placement);

/// Chooses the unit, then the up axis. Throws as choose_unit() does.
Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints);

/// Returns the model turned so that this axis becomes y.
sim::Mesh upright(const sim::Mesh& mesh, ModelAxis up);

/// Returns this axis or the opposite one, by the first of these that tells: a bag stays as it stands; a hem is longer
/// than the opening above, and a single waist or neck is above the others; legs are below; one sees deeper into it from
/// below; it is narrower at its top. Requires the adjacency of this mesh.
ModelAxis better_way_up(const sim::Mesh& mesh, const sim::Adjacency& adjacency, ModelAxis up);

/// Returns the axis along which the model stands upright, by its openings: that of a hat, which is open below, and of a
/// sock, which is open above and bent; y or z if only one of them has an opening at its top that carries most of the
/// model; -z for a model that lies on its back with its narrower opening at that end. Empty if the openings do not say.
/// Of cloth that is modelled with two walls, the outer one counts.
std::optional<ModelAxis> up_by_openings(const sim::Mesh& model);

}  // namespace taut::app
