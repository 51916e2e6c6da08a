#pragma once

#include "sim/mesh/types.hpp"

struct aiScene;

namespace taut::app {

/// Stands for "no node above".
inline constexpr sim::Index no_node = 0xFFFFFFFFU;

/// A node of the tree that moves a model: joints are nodes, and so is what meshes hang on.
struct RigNode {
  std::string name;
  sim::Index parent = no_node;             ///< the index of a node before this one
  glm::dmat4 to_parent = glm::dmat4(1.0);  ///< as it was stored
};

/// A mesh at a node, with its share of the vertices.
struct RigPart {
  sim::Index node = 0;
  std::string mesh;  ///< name
  std::size_t first_vertex = 0;
  std::size_t vertices = 0;
  bool is_skinned = false;  ///< its vertices follow their bones, and not the node
};

/// A joint as a mesh sees it.
struct RigBone {
  sim::Index node = 0;
  glm::dmat4 from_mesh = glm::dmat4(1.0);  ///< from the mesh into the joint's frame, as they were bound
};

/// How much of a vertex's movement is that of a bone.
struct RigInfluence {
  std::uint64_t vertex = 0;  ///< as wide on every machine: pages read what others encode
  sim::Index bone = 0;
  double weight = 0.0;
};

/// Another shape of a part, which is mixed in.
struct RigTarget {
  sim::Index part = 0;
  double weight = 0.0;             ///< as it was stored
  std::vector<sim::Vec3> offsets;  ///< per vertex of the part, from where it is without the target
};

/// Values at rising times. In between positions and scales go straight, and rotations along the shorter arc
/// at a constant rate (slerp, Shoemake 1985); before the first and after the last they are held.
struct RigKeys {
  std::vector<double> times_s;
  std::vector<glm::dvec4> values;  ///< x, y, z and, of rotations, w
};

/// How a node moves in a clip, instead of its own transform. A list without keys leaves that part of it.
struct RigChannel {
  sim::Index node = 0;
  RigKeys positions;
  RigKeys rotations;
  RigKeys scales;
};

/// How much of a target is mixed in during a clip: the first number of each value.
struct RigTargetChannel {
  sim::Index target = 0;
  RigKeys weights;
};

/// An animation.
struct RigClip {
  std::string name;
  double duration_s = 0.0;
  std::vector<RigChannel> channels;
  std::vector<RigTargetChannel> targets;
  std::vector<std::string> unknown;  ///< names of what it moves and the model does not have
};

/// All that moves the vertices of a model. Empty for a model without bones, targets and animations.
struct Rig {
  std::vector<RigNode> nodes;
  std::vector<RigPart> parts;      ///< their vertices follow each other and are all of the model
  std::vector<sim::Vec3> in_part;  ///< per vertex, where it is in its part
  std::vector<RigBone> bones;
  std::vector<RigInfluence> influences;  ///< ascending by vertex, then in the order of bones
  std::vector<RigTarget> targets;
  std::vector<RigClip> clips;

  bool empty() const { return nodes.empty(); }
};

/// Returns what moves the vertices of a scene of the assimp library; empty if nothing does. Vertices are in
/// the order in which a walk down the tree of nodes meets them. Throws InputError with the reason, without
/// the file's name, if bones or animations mean a name that several nodes have.
///
/// `knows_mixture` is false for FBX: of a shape that a file mixes in by less, or not at all, assimp says all
/// the same that all of it is. None is then mixed in by itself.
Rig read_rig(const aiScene& scene, bool knows_mixture);

}  // namespace taut::app
