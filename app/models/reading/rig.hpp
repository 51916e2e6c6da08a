#pragma once

#include "sim/mesh/types.hpp"

struct aiScene;

namespace taut::app {

/// Index that stands for no node.
inline constexpr sim::Index no_node = 0xFFFFFFFFU;

/// A node of the tree that moves a model: a joint, or a node that meshes hang on.
struct RigNode {
  std::string name;
  sim::Index parent = no_node;             ///< index of a node before this one
  glm::dmat4 to_parent = glm::dmat4(1.0);  ///< stored transform
};

/// A mesh at a node, with its range of vertices.
struct RigPart {
  sim::Index node = 0;
  std::string mesh;  ///< name
  std::size_t first_vertex = 0;
  std::size_t vertices = 0;
  bool is_skinned = false;  ///< true if its vertices follow their bones instead of the node
};

/// Binding of a mesh to a joint.
struct RigBone {
  sim::Index node = 0;
  glm::dmat4 from_mesh = glm::dmat4(1.0);  ///< transform from the mesh to the joint's axes when they were bound
};

/// Weight of a bone in the motion of a vertex.
struct RigInfluence {
  std::uint64_t vertex = 0;  ///< eight bytes on every machine, because web pages read what others encode
  sim::Index bone = 0;
  double weight = 0.0;
};

/// A shape of a part that is mixed in.
struct RigTarget {
  sim::Index part = 0;
  double weight = 0.0;             ///< stored weight
  std::vector<sim::Vec3> offsets;  ///< per vertex of the part, its offset from the shape without the target
};

/// Values at rising times. Between two times, positions and scales are interpolated linearly, rotations along the
/// shorter arc at a constant rate (slerp, Shoemake 1985). They are constant before the first and after the last time.
struct RigKeys {
  std::vector<double> times_s;
  std::vector<glm::dvec4> values;  ///< x, y, z, and w of rotations
};

/// Motion of a node in a clip, in place of its own transform. A list without keys leaves that part of the transform.
struct RigChannel {
  sim::Index node = 0;
  RigKeys positions;
  RigKeys rotations;
  RigKeys scales;
};

/// Weight of a target during a clip: the first number of each value.
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
  std::vector<std::string> unknown;  ///< names of moved nodes that the model does not have
};

/// Everything that moves the vertices of a model. Empty for a model without bones, targets and animations.
struct Rig {
  std::vector<RigNode> nodes;
  std::vector<RigPart> parts;      ///< parts with consecutive vertices, together all of the model's
  std::vector<sim::Vec3> in_part;  ///< position of each vertex in its part
  std::vector<RigBone> bones;
  std::vector<RigInfluence> influences;  ///< ascending by vertex, then in the order of bones
  std::vector<RigTarget> targets;
  std::vector<RigClip> clips;

  bool empty() const { return nodes.empty(); }
};

/// Returns the rig of a scene of the assimp library; empty if nothing moves its vertices. Vertices are in the order in
/// which a walk down the tree of nodes meets them. Throws InputError with the reason, without the file's name, if bones
/// or animations refer to a name that several nodes have.
///
/// `knows_mixture` is false for FBX: assimp reports full weight for shapes that a file mixes in partly or not at all.
/// No shape is then mixed in by itself.
Rig read_rig(const aiScene& scene, bool knows_mixture);

}  // namespace taut::app
