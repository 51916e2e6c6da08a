#include "app/bodies/room_for_cloth.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <string>

#include "app/bodies/body_girths.hpp"
#include "app/bodies/dressing.hpp"
#include "app/fitting/surface_tree.hpp"

namespace taut::app {
namespace {

/// Room for two layers of usual cloth, with their distances to bodies and to each other.
constexpr double room_m = 0.008;
constexpr double faces_each_other = -0.2;  ///< the cosine between the normals, at most
// As shares of the growth. Between two steps two limbs close in by less than the room.
constexpr double thick_enough = 0.48;
constexpr int steps = 13;
/// Stands for the end of a crease, where surfaces are near each other however thin the body is: it is not moved.
constexpr double in_crease = 2.0;

sim::Vec3 area_normal(std::span<const sim::Vec3> positions_m, const sim::Triangle& t) {
  return glm::cross(positions_m[t[1]] - positions_m[t[0]], positions_m[t[2]] - positions_m[t[0]]);
}

/// A body as it grows.
struct Growth {
  std::vector<sim::Vec3> thin_m, full_m;
  std::span<const sim::Triangle> triangles;
  std::span<const sim::Index> ends;  ///< per vertex; see ends_of_body()

  std::vector<sim::Vec3> at(double share, const std::vector<double>& most) const {
    std::vector<sim::Vec3> positions_m(thin_m.size());
    for (std::size_t v = 0; v < thin_m.size(); ++v) {
      positions_m[v] = glm::mix(thin_m[v], full_m[v], std::min(share, most[v]));
    }
    return positions_m;
  }

  /// Stops what is too near to another surface that faces it.
  void stop_at(double share, double stopped_share, std::vector<double>& most) const {
    const std::vector<sim::Vec3> positions_m = at(share, most);
    std::vector<sim::Vec3> face_normals;
    std::vector<sim::Vec3> normals(positions_m.size(), sim::Vec3(0.0));
    for (const sim::Triangle& t : triangles) {
      face_normals.push_back(area_normal(positions_m, t));
      for (const sim::Index v : t) {
        normals[v] += face_normals.back();
      }
    }
    const SurfaceTree tree(positions_m, triangles);
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      const sim::Vec3 normal = normals[v];
      const auto is_before = [&](const SurfacePoint& point) {
        const sim::Vec3& other = face_normals[point.triangle];
        const bool is_in_end = ends[v] != no_node && ends[triangles[point.triangle][0]] == ends[v];
        return !is_in_end && glm::dot(point.place_m - positions_m[v], normal) > 0.0 &&
               glm::dot(other, normal) < faces_each_other * glm::length(other) * glm::length(normal);
      };
      if (most[v] > stopped_share && most[v] <= 1.0 && tree.nearest(positions_m[v], room_m, is_before)) {
        most[v] = stopped_share > thick_enough ? stopped_share : in_crease;
      }
    }
  }
};

/// Per vertex of the file, the linear part of what takes it from its part into the model.
std::vector<glm::dmat3> into_model(const Rig& rig, const RigPose& pose) {
  std::vector<glm::dmat3> transforms(rig.in_part.size(), glm::dmat3(0.0));
  for (const RigPart& part : rig.parts) {
    for (std::size_t v = part.first_vertex; !part.is_skinned && v < part.first_vertex + part.vertices; ++v) {
      transforms[v] = glm::dmat3(pose.to_model[part.node]);
    }
  }
  for (const RigInfluence& influence : rig.influences) {
    const RigBone& bone = rig.bones[influence.bone];
    transforms[influence.vertex] += influence.weight * glm::dmat3(pose.to_model[bone.node] * bone.from_mesh);
  }
  return transforms;
}

/// Per vertex of the file, the end of the body that it follows most: the head with the neck, a hand or a foot, with all
/// that hangs on it. No cloth goes between lips, fingers or toes. no_node elsewhere.
std::vector<sim::Index> ends_of_body(const Rig& rig) {
  std::vector<sim::Index> of_node(rig.nodes.size(), no_node);
  const std::map<std::string, sim::Index> joints = joint_nodes(rig);
  for (const char* end : {"neck", "head", "left hand", "right hand", "left foot", "right foot"}) {
    if (const auto found = joints.find(end); found != joints.end()) {
      of_node[found->second] = found->second;
    }
  }
  for (sim::Index n = 0; n < of_node.size(); ++n) {
    const sim::Index parent = rig.nodes[n].parent;
    of_node[n] = parent != no_node && of_node[parent] != no_node ? of_node[parent] : of_node[n];
  }
  std::vector<sim::Index> ends(rig.in_part.size(), no_node);
  for (const RigPart& part : rig.parts) {
    std::fill_n(ends.begin() + static_cast<std::ptrdiff_t>(part.first_vertex), part.vertices, of_node[part.node]);
  }
  std::vector<double> most(ends.size(), 0.0);
  for (const RigInfluence& influence : rig.influences) {
    if (influence.weight > most[influence.vertex]) {
      most[influence.vertex] = influence.weight;
      ends[influence.vertex] = of_node[rig.bones[influence.bone].node];
    }
  }
  return ends;
}

}  // namespace

std::optional<RoomForCloth> leave_room(const Rig& rig, std::span<const RigPose> poses,
                                       const FileVertexPlaces& places,
                                       std::span<const sim::Triangle> triangles) {
  std::vector<double> most(places.file_vertex.size(), 1.0);
  const std::vector<sim::Index> ends_in_file = ends_of_body(rig);
  std::vector<sim::Index> ends;
  for (const std::size_t v : places.file_vertex) {
    ends.push_back(ends_in_file[v]);
  }
  for (const RigPose& pose : poses) {
    std::vector<sim::Vec3> full(rig.in_part.size());
    pose_vertices(rig, pose, full);
    const Growth growth = {placed_m(places, thin_shape(rig, pose)), placed_m(places, full), triangles, ends};
    for (int step = 1; step <= steps; ++step) {
      const auto share_at = [](int s) { return thick_enough + (1.0 - thick_enough) * s / steps; };
      growth.stop_at(share_at(step), share_at(step - 1), most);
    }
  }
  const RigPose& pose = poses.front();
  const std::vector<glm::dmat3> transforms = into_model(rig, pose);
  const std::vector<sim::Vec3> thin = thin_shape(rig, pose);
  std::vector<sim::Vec3> full(rig.in_part.size());
  pose_vertices(rig, pose, full);
  RoomForCloth result{rig};
  for (std::size_t v = 0; v < most.size(); ++v) {
    const std::size_t in_file = places.file_vertex[v];
    const sim::Vec3 back = (1.0 - most[v]) * (thin[in_file] - full[in_file]);
    if (most[v] < 1.0) {
      ++result.vertices;
      result.rig.in_part[in_file] += glm::inverse(transforms[in_file]) * back;
      result.most_m = std::max(result.most_m, glm::distance(places.placement(full[in_file]),
                                                            places.placement(full[in_file] + back)));
    }
  }
  return result.vertices > 0 ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace taut::app
