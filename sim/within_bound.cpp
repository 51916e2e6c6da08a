#include "sim/within_bound.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/solvers/bounded/certificate.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/loops.hpp"

namespace taut::sim {
namespace {

/// In sweeps over all springs: this is done once, and not sixty times a second.
constexpr double largest_cost = 1000.0;

bool keeps_bound(const Springs& springs, std::span<const Vec3> positions, double max_stretch) {
  const double longest = 1.0 + max_stretch;
  const std::size_t bound_count = springs.begin_of(SpringKind::flexural);
  for (std::size_t s = 0; s < bound_count; ++s) {
    const double length_m = glm::distance(positions[springs.ends[s][0]], positions[springs.ends[s][1]]);
    if (!(length_m <= longest * springs.rest_lengths_m[s])) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<std::vector<Vec3>> moved_within_bound(const Garment& garment, std::span<const Vec3> positions,
                                                    const SolverSettings& settings) {
  if (settings.kind != SolverKind::bounded || keeps_bound(garment.springs, positions, settings.max_stretch)) {
    return std::nullopt;
  }
  bounded::Layout layout = bounded::make_layout(garment);
  bounded::Loops loops(bounded::kernels_for(settings.vector_unit), 1);
  bounded::StartRows start;
  bounded::set_start(layout, positions, start);
  loops.start_springs(start, layout.springs);
  bounded::Certifier certifier(layout);
  certifier.certify(layout, bounded::Rows(layout.row_count()), settings.max_stretch, largest_cost, loops);
  std::vector<Vec3> moved(positions.begin(), positions.end());
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    moved[layout.vertex_of_row[row]] += bounded::vector_of(certifier.shown()[row]);
  }
  return moved;
}

}  // namespace taut::sim
