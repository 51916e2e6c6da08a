#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::test {

/// Components in the order x, y, z, w.
using Quaternion = std::array<double, 4>;

/// A model to be written as glTF text. The file itself holds all numbers.
struct GltfModel {
  struct Joint {
    std::string name;
    int parent = -1;  ///< index of an earlier joint; -1: none
    sim::Vec3 translation = sim::Vec3(0.0);
    Quaternion rotation = {0, 0, 0, 1};
  };
  struct Channel {
    int joint = 0;
    std::string path;  ///< "rotation", "translation" or "scale" of the joint, or "weights" of the mesh
    std::vector<float> times_s;
    std::vector<float> values;
  };
  struct Clip {
    std::string name;
    std::vector<Channel> channels;
  };

  std::vector<sim::Vec3> positions;
  std::vector<sim::Triangle> triangles;
  std::vector<Joint> joints = {};
  /// Up to four joints and weights for each vertex. Empty: no skin.
  std::vector<std::vector<std::pair<int, float>>> weights = {};
  std::vector<std::vector<sim::Vec3>> targets = {};  ///< shapes: an offset for each vertex
  std::vector<Clip> clips = {};
};

std::string gltf_text(const GltfModel& model);

/// A closed tube around the y axis from 0 to 2 m. It has rings of eight vertices every 0.25 m, then the middles of
/// its ends. Its joints are Hips at 1 m, Spine at 1.5 m, rotated by a quarter turn about y from its parent, and
/// LeftFoot at 0. Weights change linearly from the foot to the hips and from the hips to the spine.
GltfModel tube();

}  // namespace taut::test
