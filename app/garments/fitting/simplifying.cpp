#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>

#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/fitting/tuning.hpp"

namespace taut::app {

using namespace fitting;

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Net = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

Net to_net(const sim::Mesh& mesh) {
  Net net;
  for (const sim::Vec3& p : mesh.positions) net.add_vertex({p.x, p.y, p.z});
  for (const auto& [a, b, c] : mesh.triangles) {
    net.add_face(Net::VertexHandle(static_cast<int>(a)), Net::VertexHandle(static_cast<int>(b)),
                 Net::VertexHandle(static_cast<int>(c)));
  }
  return net;
}

sim::Mesh to_mesh(const Net& net) {
  sim::Mesh mesh;
  for (const auto v : net.vertices()) mesh.positions.emplace_back(net.point(v)[0], net.point(v)[1], net.point(v)[2]);
  for (const auto f : net.faces()) {
    sim::Triangle& t = mesh.triangles.emplace_back();
    std::size_t k = 0;
    for (const auto v : net.fv_range(f)) t[k++] = static_cast<sim::Index>(v.idx());
  }
  return mesh;
}

}  // namespace

sim::Mesh simplify(const sim::Mesh& surface, std::size_t max_triangles) {
  Net net = to_net(surface);
  net.request_face_normals();
  net.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Net> decimater(net);
  OpenMesh::Decimater::ModQuadricT<Net>::Handle by_quadric;
  OpenMesh::Decimater::ModRoundnessT<Net>::Handle by_roundness;
  OpenMesh::Decimater::ModNormalFlippingT<Net>::Handle by_normal;
  decimater.add(by_quadric);
  decimater.add(by_roundness);
  decimater.add(by_normal);
  decimater.module(by_quadric).unset_max_err();
  decimater.module(by_roundness).set_min_roundness(min_roundness);
  decimater.module(by_normal).set_max_normal_deviation(max_normal_turn_deg);
  decimater.initialize();
  decimater.decimate_to_faces(0, max_triangles);
  net.garbage_collection();
  return to_mesh(net);
}

}  // namespace taut::app
