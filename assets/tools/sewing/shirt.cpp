#include "tailor/sewing/shirt.hpp"

#include <stdexcept>

namespace taut::tailor {

std::vector<Triangle> Shirt::triangles() const {
  std::vector<Triangle> all;
  for (const Panel& panel : panels) {
    for (const Triangle& t : panel.triangles) {
      all.push_back({panel.vertices[t[0]], panel.vertices[t[1]], panel.vertices[t[2]]});
    }
  }
  return all;
}

const Seam& Shirt::seam(const std::string& name) const {
  for (const Seam& seam : seams) {
    if (seam.name == name) {
      return seam;
    }
  }
  throw std::out_of_range("the shirt has no seam named " + name);
}

}  // namespace taut::tailor
