#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::test {

/// x, y, z, w.
using Quaternion = std::array<double, 4>;

/// A model to be written as glTF text, with all numbers in the file itself.
struct GltfModel {
  struct Joint {
    std::string name;
    int parent = -1;  ///< a joint before this one
    sim::Vec3 translation = sim::Vec3(0.0);
    Quaternion rotation = {0, 0, 0, 1};
  };
  struct Channel {
    int joint = 0;
    std::string path;  ///< "rotation", "translation", "scale", or "weights", of the mesh
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
  /// Per vertex up to four joints and weights; empty: no skin.
  std::vector<std::vector<std::pair<int, float>>> weights = {};
  std::vector<std::vector<sim::Vec3>> targets = {};  ///< offsets per vertex
  std::vector<Clip> clips = {};
};

std::string gltf_text(const GltfModel& model);

/// A closed tube around the y axis from 0 to 2 m, of rings of eight vertices every 0.25 m; behind them the
/// middles of its ends. Its joints: Hips at 1 m; Spine at 1.5 m, a quarter turn about y off its parent;
/// LeftFoot at 0. Weights change linearly from the foot to the hips and from the hips to the spine.
GltfModel tube();

}  // namespace taut::test
