#include "sim/solvers/bounded/coarse_cloth.hpp"

namespace taut::sim::bounded {
namespace {

constexpr Index unassigned = ~Index{0};

class Clusters {
 public:
  explicit Clusters(const Garment& garment)
      : adjacency_(garment.adjacency), cluster_of_(garment.mesh.positions.size(), unassigned) {}

  /// Puts a free vertex and up to three free neighbours into a new cluster. A vertex without free neighbours
  /// joins the smallest cluster next to it.
  void add(Index v) {
    if (cluster_of_[v] != unassigned) return;
    const Index joined = smallest_beside(v);
    std::vector<Index> members = {v};
    for (const Index e : adjacency_.vertex_edges[v]) {
      const Index other = other_end(adjacency_.edges[e], v);
      if (cluster_of_[other] == unassigned && members.size() < largest_cluster) members.push_back(other);
    }
    const bool is_alone = members.size() == 1 && joined != unassigned;
    const Index cluster = is_alone ? joined : static_cast<Index>(sizes_.size());
    if (!is_alone) sizes_.push_back(0);
    for (const Index member : members) {
      cluster_of_[member] = cluster;
      ++sizes_[cluster];
    }
  }

  std::size_t count() const { return sizes_.size(); }
  std::vector<Index> take() { return std::move(cluster_of_); }

 private:
  Index smallest_beside(Index v) const {
    Index smallest = unassigned;
    for (const Index e : adjacency_.vertex_edges[v]) {
      const Index cluster = cluster_of_[other_end(adjacency_.edges[e], v)];
      if (cluster != unassigned && (smallest == unassigned || sizes_[cluster] < sizes_[smallest])) {
        smallest = cluster;
      }
    }
    return smallest;
  }

  const Adjacency& adjacency_;
  std::vector<Index> cluster_of_;
  std::vector<std::size_t> sizes_;
};

/// Returns the triangles between three clusters, each once, oriented like the first fine triangle that spans
/// them.
std::vector<Triangle> triangles_between(const Mesh& fine, const std::vector<Index>& cluster_of) {
  std::set<std::array<Index, 3>> known;
  std::vector<Triangle> triangles;
  for (const Triangle& t : fine.triangles) {
    const Triangle coarse = {cluster_of[t[0]], cluster_of[t[1]], cluster_of[t[2]]};
    std::array<Index, 3> sorted = {coarse[0], coarse[1], coarse[2]};
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2] && known.insert(sorted).second) {
      triangles.push_back(coarse);
    }
  }
  return triangles;
}

}  // namespace

CoarseCloth coarsen(const Garment& fine, const std::vector<Index>& order) {
  Clusters clusters(fine);
  for (const Index v : order) clusters.add(v);
  std::vector<double> masses_kg(clusters.count(), 0.0);
  CoarseCloth coarse;
  coarse.cluster_of = clusters.take();
  for (std::size_t v = 0; v < coarse.cluster_of.size(); ++v) {
    masses_kg[coarse.cluster_of[v]] += fine.masses_kg[v];
  }
  Mesh mesh;
  mesh.positions.resize(masses_kg.size(), Vec3(0.0));
  for (std::size_t v = 0; v < coarse.cluster_of.size(); ++v) {
    const Index cluster = coarse.cluster_of[v];
    const double part = masses_kg[cluster] > 0.0 ? fine.masses_kg[v] / masses_kg[cluster] : 0.0;
    coarse.mass_fraction.push_back(part);
    mesh.positions[cluster] += part * fine.mesh.positions[v];
  }
  mesh.triangles = triangles_between(fine.mesh, coarse.cluster_of);
  coarse.garment = make_garment(std::move(mesh), {}, fine.material);
  coarse.garment.others = fine.others;
  if (!fine.material_of.empty()) coarse.garment.material_of.resize(masses_kg.size());
  for (std::size_t v = 0; v < fine.material_of.size(); ++v) {
    coarse.garment.material_of[coarse.cluster_of[v]] = fine.material_of[v];
  }
  coarse.garment.masses_kg = std::move(masses_kg);
  return coarse;
}

}  // namespace taut::sim::bounded
