#include "app/models/reading/rig.hpp"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

/// Default of assimp for a file that does not give the length of a tick.
constexpr double usual_ticks_per_s = 25.0;

bool can_move(const aiScene& scene) {
  const auto moves = [](const aiMesh* mesh) { return mesh->mNumBones > 0 || mesh->mNumAnimMeshes > 0; };
  return scene.mNumAnimations > 0 || std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, moves);
}

glm::dmat4 to_matrix(const aiMatrix4x4& m) {
  // glm has columns where assimp has rows.
  return glm::dmat4(
      glm::mat4(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4));
}

sim::Vec3 to_vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

template <class Key> RigKeys to_keys(std::span<const Key> keys, double seconds_per_tick) {
  RigKeys read;
  for (const Key& key : keys) {
    read.times_s.push_back(key.mTime * seconds_per_tick);
    if constexpr (std::is_same_v<Key, aiQuatKey>) {
      read.values.emplace_back(key.mValue.x, key.mValue.y, key.mValue.z, key.mValue.w);
    } else {
      read.values.emplace_back(key.mValue.x, key.mValue.y, key.mValue.z, 0.0);
    }
  }
  return read;
}

class RigReader {
 public:
  RigReader(const aiScene& scene, bool knows_mixture) : scene_(scene), knows_mixture_(knows_mixture) {}

  Rig read() {
    add_node(*scene_.mRootNode, no_node);
    add_parts(*scene_.mRootNode);
    for (const aiAnimation* animation : std::span(scene_.mAnimations, scene_.mNumAnimations)) {
      add_clip(*animation);
    }
    return std::move(rig_);
  }

 private:
  void add_node(const aiNode& node, sim::Index parent) {
    const auto number = static_cast<sim::Index>(rig_.nodes.size());
    rig_.nodes.push_back({node.mName.C_Str(), parent, to_matrix(node.mTransformation)});
    number_of_[&node] = number;
    named_.emplace(node.mName.C_Str(), number);
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) add_node(*child, number);
  }

  void add_parts(const aiNode& node) {
    for (const unsigned mesh : std::span(node.mMeshes, node.mNumMeshes)) {
      add_part(number_of_.at(&node), *scene_.mMeshes[mesh]);
    }
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) add_parts(*child);
  }

  void add_part(sim::Index node, const aiMesh& mesh) {
    const std::size_t first = rig_.in_part.size();
    for (const aiVector3D& v : std::span(mesh.mVertices, mesh.mNumVertices)) {
      rig_.in_part.push_back(to_vector(v));
    }
    rig_.parts.push_back({node, mesh.mName.C_Str(), first, mesh.mNumVertices, mesh.mNumBones > 0});
    add_bones(mesh, first);
    add_targets(mesh);
  }

  void add_bones(const aiMesh& mesh, std::size_t first_vertex) {
    const auto first = static_cast<std::ptrdiff_t>(rig_.influences.size());
    for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
      const std::optional<sim::Index> node = find(bone->mName.C_Str());
      if (!node) {
        throw InputError("the joint '" + std::string(bone->mName.C_Str()) + "' is not among its nodes");
      }
      const auto number = static_cast<sim::Index>(rig_.bones.size());
      rig_.bones.push_back({*node, to_matrix(bone->mOffsetMatrix)});
      for (const aiVertexWeight& weight : std::span(bone->mWeights, bone->mNumWeights)) {
        if (weight.mVertexId >= mesh.mNumVertices) {
          throw InputError("the joint '" + rig_.nodes[*node].name + "' moves vertex " +
                           std::to_string(weight.mVertexId) + " of a mesh that has " +
                           std::to_string(mesh.mNumVertices));
        }
        rig_.influences.push_back({first_vertex + weight.mVertexId, number, weight.mWeight});
      }
    }
    std::stable_sort(rig_.influences.begin() + first, rig_.influences.end(),
                     [](const RigInfluence& a, const RigInfluence& b) { return a.vertex < b.vertex; });
  }

  void add_targets(const aiMesh& mesh) {
    for (const aiAnimMesh* shape : std::span(mesh.mAnimMeshes, mesh.mNumAnimMeshes)) {
      RigTarget target{static_cast<sim::Index>(rig_.parts.size() - 1), knows_mixture_ ? shape->mWeight : 0.0, {}};
      target.offsets.resize(mesh.mNumVertices, sim::Vec3(0.0));
      if (shape->HasPositions() && shape->mNumVertices != mesh.mNumVertices) {
        throw InputError("the shape '" + std::string(shape->mName.C_Str()) + "' has " +
                         std::to_string(shape->mNumVertices) + " vertices, and its mesh has " +
                         std::to_string(mesh.mNumVertices));
      }
      for (unsigned v = 0; shape->HasPositions() && v < mesh.mNumVertices; ++v) {
        target.offsets[v] = to_vector(shape->mVertices[v]) - to_vector(mesh.mVertices[v]);
      }
      rig_.targets.push_back(std::move(target));
    }
  }

  void add_clip(const aiAnimation& animation) {
    const double ticks_per_s = animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : usual_ticks_per_s;
    const double tick_s = 1.0 / ticks_per_s;
    RigClip clip{animation.mName.C_Str(), animation.mDuration * tick_s, {}, {}, {}};
    for (const aiNodeAnim* channel : std::span(animation.mChannels, animation.mNumChannels)) {
      const std::optional<sim::Index> node = find(channel->mNodeName.C_Str());
      if (!node) {
        clip.unknown.emplace_back(channel->mNodeName.C_Str());
        continue;
      }
      using Places = std::span<const aiVectorKey>;
      clip.channels.push_back(
          {*node, to_keys(Places(channel->mPositionKeys, channel->mNumPositionKeys), tick_s),
           to_keys(std::span<const aiQuatKey>(channel->mRotationKeys, channel->mNumRotationKeys), tick_s),
           to_keys(Places(channel->mScalingKeys, channel->mNumScalingKeys), tick_s)});
    }
    for (const aiMeshMorphAnim* channel : std::span(animation.mMorphMeshChannels, animation.mNumMorphMeshChannels)) {
      add_target_channels(*channel, tick_s, clip);
    }
    rig_.clips.push_back(std::move(clip));
  }

  // A channel is named after its node or its mesh, in FBX with a star and a number appended.
  void add_target_channels(const aiMeshMorphAnim& channel, double tick_s, RigClip& clip) const {
    const std::string full = channel.mName.C_Str();
    const std::string name = full.substr(0, full.rfind('*'));
    bool is_known = false;
    for (sim::Index part = 0, first = 0; part < rig_.parts.size(); ++part) {
      const auto count =
          static_cast<sim::Index>(std::ranges::count_if(rig_.targets, [&](const auto& t) { return t.part == part; }));
      const bool is_meant = rig_.parts[part].mesh == name || rig_.nodes[rig_.parts[part].node].name == name;
      for (sim::Index t = 0; is_meant && t < count; ++t) {
        RigTargetChannel target{first + t, {}};
        for (const aiMeshMorphKey& key : std::span(channel.mKeys, channel.mNumKeys)) {
          for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
            if (key.mValues[k] == t) {
              target.weights.times_s.push_back(key.mTime * tick_s);
              target.weights.values.emplace_back(key.mWeights[k], 0.0, 0.0, 0.0);
            }
          }
        }
        clip.targets.push_back(std::move(target));
      }
      is_known = is_known || (is_meant && count > 0);
      first += count;
    }
    if (!is_known) clip.unknown.push_back(full);
  }

  std::optional<sim::Index> find(const std::string& name) const {
    const auto [first, last] = named_.equal_range(name);
    if (first == last) return std::nullopt;
    if (std::next(first) != last) {
      throw InputError("several of its nodes are called '" + name + "', one of which is a joint or moves");
    }
    return first->second;
  }

  const aiScene& scene_;
  bool knows_mixture_;
  Rig rig_;
  std::map<const aiNode*, sim::Index> number_of_;
  std::multimap<std::string, sim::Index> named_;
};

}  // namespace

Rig read_rig(const aiScene& scene, bool knows_mixture) {
  return can_move(scene) ? RigReader(scene, knows_mixture).read() : Rig{};
}

}  // namespace taut::app
