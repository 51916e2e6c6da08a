#include "sim/within_bound.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

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

void move_within_bound(const Garment& garment, const SolverSettings& settings, State& state) {
  if (settings.kind != SolverKind::bounded ||
      keeps_bound(garment.springs, state.current, settings.max_stretch)) {
    return;
  }
  bounded::Layout layout = bounded::make_layout(garment);
  bounded::Loops loops(bounded::kernels_for(settings.vector_unit), 1);
  bounded::StartRows start;
  bounded::set_start(layout, state.current, start);
  loops.start_springs(start, layout.springs);
  bounded::Certifier certifier(layout);
  certifier.certify(layout, bounded::Rows(layout.row_count()), settings.max_stretch, largest_cost, loops);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    const Vec3 moved = bounded::vector_of(certifier.corrected()[row]);
    state.current[layout.vertex_of_row[row]] += moved;
    state.previous[layout.vertex_of_row[row]] += moved;
  }
}

}  // namespace taut::sim
