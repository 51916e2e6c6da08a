#include "sim/solvers/bounded/contact/contact_mesh.hpp"

namespace taut::sim::bounded {
namespace {

template <typename T> void keep_each_once(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

Primitives make_primitives(std::span<const Triangle> triangles) {
  Primitives p;
  p.triangles.assign(triangles.begin(), triangles.end());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index next = t[(k + 1) % 3];
      p.vertices.push_back({t[k]});
      p.edges.push_back({std::min(t[k], next), std::max(t[k], next)});
    }
  }
  keep_each_once(p.vertices);
  keep_each_once(p.edges);
  return p;
}

}  // namespace

void add_normals(std::span<const Triangle> triangles, const Float4Array& positions, Float4Array& normals) {
  for (const Triangle& t : triangles) {
    const glm::vec3 corner = vec(positions[t[0]]);
    const glm::vec3 normal = glm::cross(vec(positions[t[1]]) - corner, vec(positions[t[2]]) - corner);
    for (const Index row : t) {
      add(normals[row], normal);
      normals[row].fourth = 1.0F;
    }
  }
}

ContactMesh make_contact_mesh(std::span<const Triangle> cloth, std::span<const Triangle> bodies) {
  return {make_primitives(cloth), make_primitives(bodies)};
}

}  // namespace taut::sim::bounded
