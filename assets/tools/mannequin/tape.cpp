#include "tailor/mannequin/tape.hpp"

#include <stdexcept>

#include "app/models/hanging/garment_measures.hpp"

namespace taut::tailor {

double girth_m(const sim::Mesh& mesh, const Tape& tape) {
  for (const app::SectionCurve& curve :
       app::cut_section({mesh.positions, mesh.triangles}, {tape.point_m, tape.normal})) {
    if (app::is_around_point(curve)) {
      return app::tight_tape_m(curve.points_m);
    }
  }
  throw std::runtime_error("the tape '" + tape.name + "' finds nothing to lie around");
}

}  // namespace taut::tailor
