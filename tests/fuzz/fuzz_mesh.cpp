// Any bytes as flat arrays, through the mesh pipeline to springs and a few steps. Only std::invalid_argument,
// ContactBlocked and Diverged may be thrown. Coordinates that are not finite must throw Diverged.
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "fuzz.hpp"
#include "sim/blocked_contact.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/mesh/polygons.hpp"
#include "sim/simulation.hpp"

namespace {

using namespace taut::sim;

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// Zeros where the bytes are used up.
  template <class T> T take() {
    T value{};
    const std::size_t there = size_ < sizeof(T) ? size_ : sizeof(T);
    std::memcpy(&value, data_, there);
    data_ += there;
    size_ -= there;
    return value;
  }
  bool at_end() const { return size_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

// Small whole coordinates make vertices coincide and lines align. Raw floats reach every other case.
Vec3 take_position(Bytes& bytes, bool raw) {
  if (raw) {
    const auto x = bytes.take<float>(), y = bytes.take<float>(), z = bytes.take<float>();
    return {x, y, z};
  }
  const auto x = bytes.take<std::int8_t>(), y = bytes.take<std::int8_t>(), z = bytes.take<std::int8_t>();
  return {0.125 * x, 0.125 * y, 0.125 * z};
}

struct Faces {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> counts;
  std::vector<Index> corners;
};

Faces take_faces(Bytes& bytes) {
  Faces faces;
  const auto flags = bytes.take<std::uint8_t>();
  const std::size_t count = bytes.take<std::uint8_t>() % 64;
  for (std::size_t v = 0; v < count; ++v) {
    faces.positions.push_back(take_position(bytes, flags & 1U));
  }
  while (!bytes.at_end() && faces.counts.size() < 256) {
    faces.counts.push_back(bytes.take<std::uint8_t>() % 12);
    for (std::uint32_t k = 0; k < faces.counts.back(); ++k) {
      faces.corners.push_back(bytes.take<std::uint8_t>());
    }
  }
  return faces;
}

void run(const Mesh& mesh, std::uint8_t choice) {
  SimulationSettings settings;
  const double max_stretch = choice % 3 == 0 ? 0.0 : 0.05;
  const std::array<SolverMethod, 7> methods = {IdealSettings{},
                                               ProvotSettings{{}, max_stretch},
                                               StrongSettings{},
                                               BoundedSettings{.max_stretch = max_stretch, .allow_exceeding = true},
                                               VassilevSettings{{}, max_stretch},
                                               FastProjectionSettings{{}, max_stretch},
                                               ImplicitSettings{}};
  settings.solver.method = methods[choice % methods.size()];
  settings.solver.substeps = 1 + choice % 8;
  const std::vector<Index> pins = choice % 2 == 0 ? std::vector<Index>{0} : std::vector<Index>{};
  Simulation simulation(share(make_garment(mesh)), pins, settings, {});
  for (int frame = 0; frame < 2; ++frame) {
    simulation.advance_frame();
    if (first_lost(simulation.state().current) < mesh.positions.size()) {
      std::abort();
    }
  }
}

}  // namespace

void taut::test::fuzz_mesh(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const auto choice = bytes.take<std::uint8_t>();
  const auto weld = bytes.take<std::uint8_t>();
  const Faces faces = take_faces(bytes);
  try {
    const Mesh soup{faces.positions, cut_into_triangles({faces.positions, faces.counts, faces.corners}), {}};
    const ValidatedMesh valid =
        weld_and_validate(soup, {weld < 128 ? 0.0 : 0.01 * (weld - 127), weld % 2 == 0 ? 0.0 : 0.01 * weld});
    const MeshReport& report = valid.report;
    if (report.degenerate_triangles + report.duplicate_triangles + valid.mesh.triangles.size() !=
            report.input_triangles ||
        report.welded_vertices + report.near_vertices + report.sewn_vertices + report.unused_vertices +
                valid.mesh.positions.size() !=
            report.input_vertices) {
      std::abort();  // the report misses a repair
    }
    run(valid.mesh, choice);
  } catch (const std::invalid_argument&) {
  } catch (const Diverged&) {
  } catch (const ContactBlocked&) {  // cloth as large as a planet, or nothing but touching primitives
  }
}
